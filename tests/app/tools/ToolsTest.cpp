#include "app/tools/Tools.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "app/tools/GroomEdits.h"

namespace fur::app {
namespace {

Tool toolAt(std::size_t i) { return static_cast<Tool>(i); }
std::string named(Tool tool) { return std::string(nameOf(tool)); }

TEST(Tools, EachIsFoundByItsName) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kToolCount; ++i) {
    EXPECT_EQ(toolNamed(nameOf(toolAt(i))), toolAt(i));
    EXPECT_TRUE(names.insert(named(toolAt(i))).second) << named(toolAt(i)) << " is the name of two";
  }
  EXPECT_EQ(toolNamed("hammer"), std::nullopt);
  EXPECT_EQ(toolNamed(""), std::nullopt);
  EXPECT_EQ(toolNamed("Droplet"), std::nullopt);
}

// Links, saved scenes and pages hold them.
TEST(Tools, NamesThatWereEverGivenOutAreStillKnown) {
  for (const char* name : {"droplet", "dry", "rain", "hose", "towel", "dryer", "comb", "smooth", "raise", "trim", "grow", "type", "whisker", "pluck",
                           "paint", "cut", "thin", "mask", "curl", "frizz", "locks", "pet", "ball", "grab", "none"})
    EXPECT_TRUE(toolNamed(name)) << name;
}

TEST(Tools, WhatWorksOnWaterGroomOrHairPaintsAndNothingElseDoes) {
  for (std::size_t i = 0; i < kToolCount; ++i) {
    const Tool tool = toolAt(i);
    EXPECT_EQ(paints(tool), grooms(tool) || worksOnWater(tool) || worksOnHair(tool)) << named(tool);
    if (goesOn(tool)) EXPECT_TRUE(worksOnWater(tool)) << named(tool);
    if (repeats(tool)) EXPECT_TRUE(paints(tool) && traitsOf(tool).reach > 0) << named(tool);
  }
}

TEST(Tools, WhatTheySayOfThemselvesIsTrue) {
  for (const Tool tool : {Tool::Rain, Tool::Hose, Tool::Dryer}) EXPECT_TRUE(goesOn(tool)) << named(tool);
  for (const Tool tool : {Tool::Droplet, Tool::Towel, Tool::Trim, Tool::Locks}) EXPECT_TRUE(repeats(tool) && !goesOn(tool)) << named(tool);
  for (const Tool tool : {Tool::Comb, Tool::Whisker, Tool::Pluck, Tool::Pet, Tool::Grab}) EXPECT_FALSE(repeats(tool) || goesOn(tool)) << named(tool);
  for (const Tool tool : {Tool::Comb, Tool::Pluck, Tool::Paint, Tool::Locks}) EXPECT_TRUE(grooms(tool)) << named(tool);
  for (const Tool tool : {Tool::Droplet, Tool::Dryer, Tool::Pet, Tool::None}) EXPECT_FALSE(grooms(tool)) << named(tool);
  EXPECT_EQ(traitsOf(Tool::Pet).drag, Drag::Touch);
  EXPECT_EQ(traitsOf(Tool::Grab).drag, Drag::Grab);
  EXPECT_EQ(traitsOf(Tool::None).drag, Drag::Orbit);
}

TEST(Tools, EachHasALabelAndATooltip) {
  for (std::size_t i = 0; i < kToolCount; ++i) {
    EXPECT_STRNE(wordsOf(toolAt(i)).label, "") << named(toolAt(i));
    EXPECT_STRNE(wordsOf(toolAt(i)).tooltip, "") << named(toolAt(i));
  }
}

TEST(GroomEdits, EachIsFoundByItsName) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kGroomEditCount; ++i) {
    const auto edit = static_cast<GroomEdit>(i);
    EXPECT_EQ(groomEditNamed(nameOf(edit)), edit);
    EXPECT_TRUE(names.insert(nameOf(edit)).second) << nameOf(edit) << " is the name of two";
  }
  EXPECT_EQ(groomEditNamed("shave"), std::nullopt);
}

TEST(GroomEdits, TheMaskProtectsTheFurButNotTheMask) {
  for (const GroomEdit edit : {GroomEdit::Length, GroomEdit::Comb, GroomEdit::Paint, GroomEdit::ClearPaint, GroomEdit::ClearShape})
    EXPECT_TRUE(keepsMasked(edit)) << nameOf(edit);
  for (const GroomEdit edit : {GroomEdit::Clear, GroomEdit::Size, GroomEdit::ClearMask, GroomEdit::InvertMask, GroomEdit::SelectType, GroomEdit::GrowMask})
    EXPECT_FALSE(keepsMasked(edit)) << nameOf(edit);
}

}  // namespace
}  // namespace fur::app
