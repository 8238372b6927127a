#include "settings/FurTypes.h"

#include <gtest/gtest.h>

#include "scene/StateJson.h"
#include "settings/Presets.h"
#include "tests/settings/RandomSettings.h"

namespace fur::settings {
namespace {

Settings with(std::initializer_list<std::pair<const char*, const char*>> values) {
  Settings settings;
  Warnings warnings;
  for (const auto& [name, text] : values) EXPECT_TRUE(setField(settings, name, text, warnings)) << name;
  EXPECT_TRUE(warnings.empty());
  return settings;
}

TEST(FurTypes, AreBaldPresetsOrTheirOwn) {
  Settings settings = randomSettings(4);
  for (const char* name : {"type2", "type3", "type4"}) {
    const Field& field = *findField(name);
    EXPECT_EQ(optionName(field, 0), "bald");
    EXPECT_EQ(optionName(field, static_cast<int>(presets().size()) + 1), "own");
    EXPECT_EQ(optionName(field, static_cast<int>(presets().size()) + 2), "") << "no more than there are presets";
    const int type = name[4] - '1';
    for (std::size_t i = 0; i < presets().size(); ++i) {
      EXPECT_EQ(optionName(field, static_cast<int>(i) + 1), presets()[i].name);
      field.set(settings, static_cast<double>(i) + 1);
      EXPECT_EQ(presetOf(typeCoat(settings, type)), &presets()[i]);
      EXPECT_EQ(typeCoat(settings, type).tileSize, settings.tileSize);
    }
    field.set(settings, 0);
    EXPECT_EQ(typeCoat(settings, type).density, 0);
  }
  EXPECT_EQ(typeCoat(settings, 0), settings);
}

TEST(FurTypes, AreSetByANameWithTheirNumber) {
  const Settings settings = with({{"type2.curl", "0.75"}, {"type3.rootColor", "#102030"}, {"type2.name", "Mane"}, {"type1.curl", "0.5"}});
  EXPECT_FLOAT_EQ(typeCoat(settings, 1).curl, 0.75f);
  EXPECT_EQ(typeCoat(settings, 2).rootColor, 0x102030u);
  EXPECT_FLOAT_EQ(settings.curl, 0.5f);
  EXPECT_EQ(typeName(settings, 1), "Mane");
  EXPECT_TRUE(isOwn(settings, 1));
  EXPECT_TRUE(isOwn(settings, 2));
  EXPECT_FALSE(isOwn(settings, 3));
  EXPECT_EQ(typeFieldText(settings, *typeFieldOf("type2.curl")), "0.75");
}

TEST(FurTypes, BecomeTheirOwnFromWhatTheyWere) {
  const Settings settings = with({{"type2", "wool"}, {"type2.curl", "0.1"}});
  Settings wool = *applyPreset(Settings{}, "wool");
  wool.curl = 0.1f;
  for (const Field& field : fields())
    if (field.has(kOfType)) EXPECT_EQ(field.get(typeCoat(settings, 1)), field.get(wool)) << field.name;
}

TEST(FurTypes, LoadPresetsWhole) {
  const Settings settings = with({{"type4.preset", "velvet"}, {"furLength", "0.01"}});
  EXPECT_TRUE(isOwn(settings, 3));
  const Settings velvet = *applyPreset(Settings{}, "velvet"), drawn = drawnCoat(settings, 3);
  for (const Field& field : fields())
    if (field.has(kOfType)) EXPECT_EQ(field.get(drawn), field.get(velvet)) << field.name;
}

TEST(FurTypes, ByAPresetsNameHaveTheLightWeightSkinAndGreatestLengthOfTypeOne) {
  const Settings settings = with({{"type2", "persian"}, {"furLength", "0.03"}, {"specular", "1.5"}, {"gravity", "0.9"}, {"skinColor", "#123456"}});
  const Settings drawn = drawnCoat(settings, 1), persian = *applyPreset(Settings{}, "persian");
  EXPECT_EQ(drawn.rootColor, persian.rootColor);
  EXPECT_EQ(drawn.curl, persian.curl);
  EXPECT_EQ(drawn.specular, 1.5f);
  EXPECT_EQ(drawn.gravity, 0.9f);
  EXPECT_EQ(drawn.skinColor, 0x123456u);
  EXPECT_EQ(drawn.furLength, 0.03f);
}

TEST(FurTypes, OfTheirOwnAreAsLongAsTheySay) {
  const Settings settings = with({{"furLength", "0.1"}, {"type2.furLength", "0.2"}, {"type3.furLength", "0.05"}, {"type4", "bald"}});
  EXPECT_FLOAT_EQ(coatLength(settings, 1), 0.1f) << "only those that grow count";
  EXPECT_FLOAT_EQ(coatLength(settings, 7), 0.2f);
  EXPECT_FLOAT_EQ(typeHeight(settings, 0, 0.2f), 0.5f);
  EXPECT_FLOAT_EQ(typeHeight(settings, 1, 0.2f), 1);
  EXPECT_FLOAT_EQ(typeHeight(settings, 2, 0.2f), 0.25f);
  EXPECT_EQ(typeHeight(settings, 3, 0.2f), 0);
}

TEST(FurTypes, GoThroughStatesAsText) {
  scene::ProgramState given;
  given.settings = with({{"type2.preset", "wool"}, {"type2.name", "A \"quoted\" name"}, {"type3", "own"}, {"type1.picture", "00c0ffee"}, {"type4.density", "0.3"}});
  auto read = scene::readState(scene::writeState(given));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->settings, given.settings);
  EXPECT_TRUE(read->warnings.empty());
}

TEST(FurTypes, WarnOfWhatIsNoneOfTheirs) {
  for (const auto& [name, text] : {std::pair("type2.layers", "8"), std::pair("type5.curl", "1"), std::pair("type2.", "1"), std::pair("type2.curl", "much"),
                                   std::pair("type2.preset", "fox"), std::pair("type3.picture", "red"), std::pair("type3.picture", "123456789ab")}) {
    Settings settings;
    Warnings warnings;
    EXPECT_FALSE(setField(settings, name, text, warnings)) << name;
    EXPECT_EQ(warnings.size(), 1u) << name;
    EXPECT_EQ(settings, Settings{}) << name;
  }
}

TEST(FurTypes, HaveNamesOfWholeCharacters) {
  Settings settings;
  setTypeName(settings, 0, std::string(38, 'a') + "\xc3\xa4");
  EXPECT_EQ(typeName(settings, 0), std::string(38, 'a'));
  setTypeName(settings, 0, "Fell");
  EXPECT_EQ(typeName(settings, 0), "Fell");
  Settings again;
  setTypeName(again, 0, "Fell");
  EXPECT_EQ(settings, again) << "nothing of the longer name is left";
}

}  // namespace
}  // namespace fur::settings
