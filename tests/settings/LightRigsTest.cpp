#include "settings/LightRigs.h"

#include <set>

#include <gtest/gtest.h>

#include "settings/FieldValues.h"
#include "settings/Presets.h"

namespace fur::settings {
namespace {

TEST(LightRigs, AreNamedOnceAndShown) {
  std::set<std::string> names, labels;
  for (const LightRig& rig : lightRigs()) {
    EXPECT_TRUE(names.insert(rig.name).second) << rig.name;
    EXPECT_TRUE(labels.insert(rig.label).second) << rig.label;
    EXPECT_FALSE(findPreset(rig.name)) << rig.name << " is a coat";
  }
  EXPECT_EQ(names, (std::set<std::string>{"daylight", "studio", "sunset", "overcast", "backlit", "night"}));
}

TEST(LightRigs, HaveOnlyFieldsOfTheLightWithinTheirRanges) {
  for (const LightRig& rig : lightRigs()) {
    std::set<std::string_view> given;
    for (const FieldValue& value : valuesOf(rig.values)) {
      const Field* field = findField(value.field);
      ASSERT_TRUE(field) << rig.name << ": " << value.field;
      EXPECT_TRUE(belongsToLight(*field)) << rig.name << ": " << value.field;
      EXPECT_FALSE(field->has(kOfCoat)) << rig.name << ": " << value.field;
      EXPECT_TRUE(given.insert(value.field).second) << rig.name << ": " << value.field << " twice";
      Settings settings;
      Warnings warnings;
      EXPECT_TRUE(setField(settings, value.field, value.text, warnings));
      EXPECT_TRUE(warnings.empty()) << rig.name << ": " << warnings.front();
      EXPECT_NE(field->get(settings), field->standard) << rig.name << ": " << value.field << " is the default";
    }
  }
}

TEST(LightRigs, GiveTheSameLightWhateverWasThereAndLeaveTheCoatAlone) {
  for (const LightRig& rig : lightRigs()) {
    Settings other = *applyPreset({}, "persian");
    Warnings warnings;
    for (const LightRig& before : lightRigs()) EXPECT_TRUE(applyLightRig(other, before.name, warnings));
    other.lightYaw = 0.123f;
    EXPECT_EQ(lightRigOf(other), nullptr);
    EXPECT_TRUE(setField(other, "lightRig", rig.name, warnings));
    EXPECT_EQ(lightRigOf(other), &rig);
    ASSERT_TRUE(presetOf(other));
    EXPECT_STREQ(presetOf(other)->name, "persian");
    EXPECT_TRUE(warnings.empty());
  }
}

TEST(LightRigs, DaylightIsTheDefault) {
  ASSERT_TRUE(lightRigOf({}));
  EXPECT_STREQ(lightRigOf({})->name, "daylight");
}

TEST(LightRigs, TheirNameIsReadAsLongAsTheLightIsTheirs) {
  Settings settings;
  Warnings warnings;
  for (const LightRig& rig : lightRigs()) {
    ASSERT_TRUE(setField(settings, "lightRig", rig.name, warnings));
    EXPECT_EQ(settingText(settings, "lightRig"), rig.name);
  }
  settings.lightYaw += 0.1f;
  EXPECT_EQ(settingText(settings, "lightRig"), "");
}

TEST(LightRigs, AnUnknownNameChangesNothingAndTheWarningListsAll) {
  Settings settings;
  Warnings warnings;
  EXPECT_FALSE(setField(settings, "lightRig", "disco", warnings));
  EXPECT_EQ(settings, Settings{});
  ASSERT_EQ(warnings.size(), 1u);
  for (const LightRig& rig : lightRigs()) EXPECT_NE(warnings.front().find(rig.name), std::string::npos) << rig.name;
}

}  // namespace
}  // namespace fur::settings
