#include "settings/Settings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/Random.h"

namespace fur::settings {
namespace {

TEST(Settings, HaveEveryDefaultWithinItsRange) {
  const Settings standard;
  for (const Field& field : fields()) {
    EXPECT_LE(field.low, field.standard) << field.name;
    EXPECT_GE(field.high, field.standard) << field.name;
    EXPECT_LT(field.low, field.high) << field.name;
    EXPECT_EQ(field.get(standard), field.standard) << field.name;
    EXPECT_NE(tooltipOf(field)[0], 0) << field.name;
    EXPECT_NE(field.label[0], 0) << field.name;
  }
}

TEST(Settings, HaveNamesThatAreUnique) {
  std::set<std::string> names;
  for (const Field& field : fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_EQ(findField(field.name), &field);
  }
  EXPECT_EQ(findField("nonsense"), nullptr);
}

TEST(Settings, KeepTheFieldsOfAGroupTogether) {
  std::set<std::string> done;
  std::string last;
  for (const Field& field : fields()) {
    if (field.group == last) continue;
    EXPECT_TRUE(done.insert(field.group).second) << field.group;
    last = field.group;
  }
}

TEST(Settings, ComeBackFromTheirText) {
  Random random(8);
  for (int k = 0; k < 200; ++k) {
    Settings given, read;
    Warnings warnings;
    for (const Field& field : fields())
      setField(given, field, field.low + (field.high - field.low) * random.uniform(), warnings);
    for (const Field& field : fields()) ASSERT_TRUE(setField(read, field.name, fieldText(given, field), warnings)) << field.name;
    EXPECT_EQ(read, given);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
  }
}

TEST(Settings, ComeBackFromTheTextOfTheirBounds) {
  for (const Field& field : fields())
    for (const double bound : {field.low, field.high, field.standard}) {
      Settings given, read;
      Warnings warnings;
      setField(given, field, bound, warnings);
      setField(read, field.name, fieldText(given, field), warnings);
      EXPECT_EQ(field.get(read), field.get(given)) << field.name;
      EXPECT_TRUE(warnings.empty()) << (warnings.empty() ? "" : warnings.front());
    }
}

TEST(Settings, AreClampedWithAWarning) {
  for (const Field& field : fields()) {
    Settings settings;
    Warnings warnings;
    setField(settings, field, field.high + 10, warnings);
    EXPECT_EQ(field.get(settings), field.high) << field.name;
    setField(settings, field, field.low - 10, warnings);
    EXPECT_EQ(field.get(settings), field.low) << field.name;
    setField(settings, field, std::nan(""), warnings);
    EXPECT_EQ(field.get(settings), field.standard) << field.name;
    ASSERT_EQ(warnings.size(), 3u) << field.name;
    EXPECT_EQ(warnings[0].rfind(field.name, 0), 0u) << warnings[0];
  }
}

TEST(Settings, WarnOfAnUnknownNameAndChangeNothing) {
  Settings settings;
  Warnings warnings;
  EXPECT_FALSE(setField(settings, "furriness", "1", warnings));
  EXPECT_EQ(warnings.size(), 1u);
  EXPECT_EQ(settings, Settings());
}

TEST(Settings, WarnOfUnreadableTextAndChangeNothing) {
  for (const char* text : {"", " 1", "1x", "nan", "inf", "0x10", "true", "--1"}) {
    Settings settings;
    Warnings warnings;
    EXPECT_FALSE(setField(settings, "density", text, warnings)) << text;
    EXPECT_EQ(warnings.size(), 1u) << text;
    EXPECT_EQ(settings, Settings());
  }
  Settings settings;
  Warnings warnings;
  EXPECT_FALSE(setField(settings, "fins", "yes", warnings));
  EXPECT_FALSE(setField(settings, "rootColor", "#12", warnings));
  EXPECT_FALSE(setField(settings, "rootColor", "#12345g", warnings));
  EXPECT_FALSE(setField(settings, "view", "everything", warnings));
  EXPECT_EQ(warnings.size(), 4u);
  EXPECT_EQ(settings, Settings());
}

TEST(Settings, ReadTheFormsThatLinksUse) {
  Settings settings;
  Warnings warnings;
  EXPECT_TRUE(setField(settings, "rootColor", "1a2B3c", warnings));
  EXPECT_EQ(settings.rootColor, 0x1a2b3cu);
  EXPECT_TRUE(setField(settings, "fins", "0", warnings));
  EXPECT_FALSE(settings.fins);
  EXPECT_TRUE(setField(settings, "density", "2.5e-1", warnings));
  EXPECT_EQ(settings.density, 0.25f);
  EXPECT_TRUE(setField(settings, "layers", "16.4", warnings));
  EXPECT_EQ(settings.layers, 16);
  EXPECT_TRUE(warnings.empty());
}

TEST(Settings, NameEveryOptionOfAChoice) {
  const Field& view = *findField("view");
  for (int index = 0; index <= static_cast<int>(view.high); ++index) {
    ASSERT_FALSE(optionName(view, index).empty());
    EXPECT_EQ(optionIndex(view, optionName(view, index)), index);
  }
  EXPECT_TRUE(optionName(view, static_cast<int>(view.high) + 1).empty());
  EXPECT_TRUE(optionName(view, -1).empty());
  EXPECT_EQ(optionIndex(view, "x"), -1);
}

// Checks strings, braces and commas; counts the objects.
int objectsIn(const std::string& json) {
  int depth = 0, objects = 0;
  bool inString = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (inString) {
      if (c == '\\') ++i;
      else if (c == '"') inString = false;
      continue;
    }
    if (c == '"') inString = true;
    if (c == '{') ++objects;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth < 0 || (depth == 0 && i + 1 < json.size())) return -1;
  }
  return depth == 0 && !inString ? objects : -1;
}

TEST(Settings, DescribeThemselvesAsJson) {
  const std::string json = fieldTableJson();
  EXPECT_EQ(json.front(), '[');
  EXPECT_EQ(json.back(), ']');
  EXPECT_EQ(objectsIn(json), static_cast<int>(kFieldCount));
  for (const Field& field : fields())
    EXPECT_NE(json.find("{\"name\":\"" + std::string(field.name) + "\",\"label\":"), std::string::npos) << field.name;
}

}  // namespace
}  // namespace fur::settings
