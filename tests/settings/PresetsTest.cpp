#include "settings/Presets.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "scene/StateJson.h"
#include "tests/settings/RandomSettings.h"

namespace fur::settings {
namespace {

using Json = nlohmann::json;

TEST(Presets, AreTheElevenCoats) {
  std::set<std::string> names, labels;
  for (const Preset& preset : presets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_TRUE(labels.insert(preset.label).second) << preset.label;
    EXPECT_EQ(findPreset(preset.name), &preset);
    EXPECT_NE(preset.description[0], 0) << preset.name;
  }
  EXPECT_EQ(names, (std::set<std::string>{"rabbit", "chinchilla", "curlyDog", "thickNylon", "fineSparse", "otter",
                                          "shortCat", "persian", "shag", "velvet", "wool"}));
}

TEST(Presets, GiveTheChinchillaItsInputsOfTheThesis) {
  // Sheppard 2004, 6.2.1, text 3.
  const Settings chinchilla = *applyPreset({}, "chinchilla");
  EXPECT_EQ(chinchilla.thickness, 0.3f);
  EXPECT_EQ(chinchilla.density, 1.0f);
  EXPECT_EQ(chinchilla.curl, 0.1f);
  EXPECT_GT(chinchilla.repeat, Settings{}.repeat);
}

TEST(Presets, SetOnlyFieldsOfTheCoatAndWhatTheySetIsInRange) {
  for (const auto& preset : Json::parse(presetTableJson()))
    for (const auto& [name, value] : preset["settings"].items()) {
      const Field* field = findField(name);
      ASSERT_TRUE(field) << name;
      EXPECT_TRUE(field->has(kOfCoat)) << preset["name"] << ' ' << name;
      Settings settings;
      Warnings warnings;
      EXPECT_TRUE(setField(settings, name, value.is_string() ? value.get<std::string>() : value.dump(), warnings));
      EXPECT_TRUE(warnings.empty()) << preset["name"] << ' ' << name;
      EXPECT_NE(field->get(settings), field->standard) << preset["name"] << ' ' << name << ": says nothing";
    }
}

TEST(Presets, LeaveAloneWhatIsNotTheCoat) {
  for (const char* kept : {"layers", "tileSize", "furMapping", "fins", "seed", "textureAmount", "lightYaw", "ambient", "exposure",
                           "brushRadius", "dryRate", "wind", "inertia", "backgroundTop", "view"})
    EXPECT_FALSE(findField(kept)->has(kOfCoat)) << kept;
  const Settings before = randomSettings(3);
  for (const Preset& preset : presets()) {
    const Settings after = *applyPreset(before, preset.name);
    for (const Field& field : fields())
      if (!field.has(kOfCoat)) EXPECT_EQ(field.get(after), field.get(before)) << preset.name << ' ' << field.name;
  }
}

TEST(Presets, GiveTheSameCoatWhateverWasThereBefore) {
  for (const Preset& preset : presets()) {
    const Settings clean = *applyPreset({}, preset.name);
    for (int seed = 0; seed < 20; ++seed) {
      const Settings after = *applyPreset(randomSettings(seed), preset.name);
      for (const Field& field : fields())
        if (field.has(kOfCoat)) ASSERT_EQ(field.get(after), field.get(clean)) << preset.name << ' ' << field.name;
    }
    EXPECT_EQ(*applyPreset(clean, preset.name), clean);
  }
}

TEST(Presets, AreKnownAgainUntilTheCoatChanges) {
  EXPECT_EQ(presetOf(Settings{}), nullptr);
  for (const Preset& preset : presets()) {
    Settings settings = *applyPreset(randomSettings(9), preset.name);
    EXPECT_EQ(presetOf(settings), &preset);
    settings.seed ^= 1;
    settings.wind = 0.5f;
    EXPECT_EQ(presetOf(settings), &preset) << "another seed is the same kind of coat";
    settings.density *= 0.5f;
    EXPECT_EQ(presetOf(settings), nullptr);
  }
}

TEST(Presets, ComeBackFromASavedState) {
  for (const Preset& preset : presets()) {
    scene::ProgramState given;
    given.settings = *applyPreset(randomSettings(5), preset.name);
    auto read = scene::readState(scene::writeState(given));
    ASSERT_TRUE(read) << preset.name;
    EXPECT_EQ(read->settings, given.settings) << preset.name;
    EXPECT_TRUE(read->warnings.empty()) << preset.name;
    EXPECT_EQ(presetOf(read->settings), &preset);
  }
}

TEST(Presets, ThereIsNoneOfAnUnknownName) {
  EXPECT_FALSE(applyPreset({}, "fox"));
  EXPECT_FALSE(applyPreset({}, ""));
  const std::string warning = unknownPreset("fox");
  EXPECT_NE(warning.find("\"fox\""), std::string::npos);
  for (const Preset& preset : presets()) EXPECT_NE(warning.find(preset.name), std::string::npos) << preset.name;
}

TEST(Presets, DescribeThemselvesAsJson) {
  const Json table = Json::parse(presetTableJson(), nullptr, false);
  ASSERT_TRUE(table.is_array());
  ASSERT_EQ(table.size(), presets().size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(table[i]["name"], presets()[i].name);
    EXPECT_EQ(table[i]["label"], presets()[i].label);
    EXPECT_EQ(table[i]["description"], presets()[i].description);
    EXPECT_TRUE(table[i]["settings"]["tipColor"].is_string());
    EXPECT_TRUE(table[i]["settings"]["furLength"].is_number());
  }
}

}  // namespace
}  // namespace fur::settings
