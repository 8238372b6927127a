#include <gtest/gtest.h>

#include <set>

#include "app/commands/Commands.h"
#include "app/commands/History.h"
#include "app/commands/WaterStrokes.h"

namespace fur::app {
namespace {

constexpr std::size_t kTriangles = 400;

TEST(Commands, EachHasANameOfItsOwnByWhichItIsFound) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Command::Redo); ++i) {
    const auto command = static_cast<Command>(i);
    EXPECT_TRUE(names.insert(nameOf(command)).second) << nameOf(command);
    EXPECT_EQ(commandNamed(nameOf(command)), command);
  }
  EXPECT_EQ(commandNamed("rinse"), std::nullopt);
}

TEST(Commands, AToolThatWorksOnWaterHasTheStrokeOfItsName) {
  for (std::size_t i = 0; i < kToolCount; ++i) {
    const auto tool = static_cast<Tool>(i);
    const auto stroke = strokeOf(tool);
    ASSERT_EQ(stroke.has_value(), worksOnWater(tool)) << nameOf(tool);
    if (!stroke) continue;
    EXPECT_EQ(nameOf(*stroke), nameOf(tool));
    EXPECT_TRUE(isRecorded(*stroke));
    EXPECT_EQ(toolOf(*stroke), tool);
  }
  EXPECT_EQ(toolOf(Command::Groom), Tool::None);
}

std::vector<WaterStroke> session() {
  return {{Command::Hose, 0.25f, 0.75f, 0.0625f, {0, 1, 3}, {{5, {300, Vec3(0.5f, 0.25f, 0.25f), 0}, 1}, {40, {310, Vec3(0.5f, 0.25f, 0.25f), 0}, 0.5f}}},
          {Command::Shake, 0, 0, 0.0625f, Vec3(0), {{135, {0, Vec3(1, 0, 0), 0}, 1}}}};
}

TEST(WaterStrokes, AreReadBackFromTheirText) {
  const std::string text = writeStrokes(session());
  EXPECT_EQ(text.find("[[\"hose\",0.25,0.75,0.0625,0,1,3,5,300,0.25,0.25,1,40"), 0u) << text;
  auto back = readStrokes(text, kTriangles);
  ASSERT_TRUE(back);
  EXPECT_EQ(writeStrokes(*back), text);
}

TEST(WaterStrokes, TheNumbersOfOlderLinksMeanWhatTheyMeant) {
  auto old = readStrokes("[[3,0.25,0.75,0.0625,0,1,3,5,300,0.25,0.25,1],[102,0,0.5,0.0625,0,0,0,9,0,0,0,1]]", kTriangles);
  ASSERT_TRUE(old);
  EXPECT_EQ((*old)[0].what, Command::Hose);
  EXPECT_EQ((*old)[1].what, Command::Soak);
}

TEST(WaterStrokes, OneUnsoundStrokeRefusesTheWholeText) {
  for (const char* bad : {"", "{}", "[7]", "[[\"hose\"]]", "[[\"rinse\",0,0,0.05,0,0,3,0,0,0,0,1]]", "[[\"settings\",0,0,0.05,0,0,3,0,0,0,0,1]]",
                          "[[99,0,0,0.05,0,0,3,0,0,0,0,1]]", "[[\"rain\",0,0,0.05,0,0,3,0,400,0,0,1]]", "[[\"rain\",0,0,0.05,0,0,3,0,0,0,0]]",
                          "[[\"rain\",\"x\",0,0.05,0,0,3,0,0,0,0,1]]", "[[\"rain\",0,0,0.05,0,0,3,-1,0,0,0,1]]"}) {
    auto read = readStrokes(bad, kTriangles);
    ASSERT_FALSE(read) << bad;
    EXPECT_EQ(read.error().id, ErrorId::BadFile);
  }
}

TEST(WaterStrokes, BytesThatEndEarlyOrNameNoCommandAreUnsound) {
  ByteWriter to;
  saveStrokes(to, session());
  ByteReader whole(to.bytes);
  EXPECT_EQ(writeStrokes(restoreStrokes(whole)), writeStrokes(session()));
  EXPECT_TRUE(whole.sound() && whole.atEnd());
  for (std::size_t length = 0; length < to.bytes.size(); ++length) {
    ByteReader cut(std::span(to.bytes).first(length));
    (void)restoreStrokes(cut);
    EXPECT_FALSE(cut.sound()) << length;
  }
  std::vector<std::uint8_t> other = to.bytes;
  other[8] = 'x';  // the first letter of "hose"
  ByteReader renamed(other);
  (void)restoreStrokes(renamed);
  EXPECT_FALSE(renamed.sound());
}

TEST(History, StepsHaveTheNamesOfTheirCommandsInBytes) {
  History history;
  history.push(SettingsStep{});
  history.push(GroomStep{});
  ByteWriter to;
  history.save(to, true);
  const std::string bytes(to.bytes.begin(), to.bytes.end());
  for (const Command one : {Command::Settings, Command::Groom, Command::Model}) EXPECT_NE(bytes.find(nameOf(one)), std::string::npos) << nameOf(one);
  History other;
  EXPECT_TRUE(other.restore(to.bytes));
  EXPECT_TRUE(other.canUndo() && other.canRedo());
  std::vector<std::uint8_t> broken = to.bytes;
  broken[12] = 'S';
  EXPECT_FALSE(other.restore(broken));
  EXPECT_TRUE(other.canUndo());
}

}  // namespace
}  // namespace fur::app
