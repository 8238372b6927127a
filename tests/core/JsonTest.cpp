#include "core/Json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/Random.h"

namespace fur {
namespace {

using Theirs = nlohmann::json;

bool isSame(const Json& ours, const Theirs& theirs) {
  if (theirs.is_object()) {
    bool same = ours.isObject() && ours.count() >= theirs.size();  // one key may stand there twice
    for (const auto& [key, value] : theirs.items()) {
      const Json* found = ours.find(key);
      same = same && found && isSame(*found, value);
    }
    return same;
  }
  if (theirs.is_array()) {
    bool same = ours.isArray() && ours.count() == theirs.size();
    std::size_t at = 0;
    for (auto it = ours.begin(); same && it != ours.end(); ++it) same = isSame(*it, theirs[at++]);
    return same;
  }
  if (theirs.is_string()) return ours.isString() && ours.text() == theirs.get<std::string>();
  // readDecimal() promises 1e-15.
  if (theirs.is_number()) return std::abs(ours.number() - theirs.get<double>()) <= 1e-15 * std::abs(theirs.get<double>());
  return ours.source() == theirs.dump() && ours.isTrue() == (theirs == true);
}

template <std::size_t N>
const char* oneOf(Random& random, const char* const (&texts)[N]) {
  return texts[random.next() % N];
}

std::string randomJson(Random& random, int depth) {
  const auto kind = random.next() % (depth < 5 ? 4 : 2);
  if (kind == 0) return oneOf(random, {"0", "-0", "1.5e3", "-12.25", "1E-7", "123456789012345678901234567890", "true", "false", "null"});
  if (kind == 1) return oneOf(random, {R"("")", R"("a\n\u0041\"")", R"("\ud83d\ude00 \u20ac\/\\")", "\"\xc3\xa9\""});
  std::string out = kind == 2 ? "[" : "{";
  for (auto left = random.next() % 4; left > 0; --left) {
    if (out.size() > 1) out += oneOf(random, {",", " ,\n"});
    if (kind == 3) out += oneOf(random, {R"("a":)", R"("b" : )", R"("\u0061":)", R"("c\"":)"});
    out += randomJson(random, depth + 1);
  }
  return out + (kind == 2 ? " ]" : "}");
}

TEST(Json, IsReadAsAnotherLibraryReadsIt) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const std::string text = randomJson(random, 0);
    const std::vector<Json> nodes = parseJson(text);
    ASSERT_FALSE(nodes.empty()) << text;
    ASSERT_TRUE(isSame(nodes[0], Theirs::parse(text))) << text;
    EXPECT_EQ(nodes[0].source(), text);
  }
}

TEST(Json, IsRefusedWhereAnotherLibraryRefusesIt) {
  Random random(2);
  int refused = 0;
  for (int i = 0; i < 10'000; ++i) {
    std::string text = randomJson(random, 0);
    const std::size_t at = random.next() % text.size();
    if (random.next() % 2) text.erase(at, 1);
    else text.insert(at, 1, "{}[],:\"u.+-0t \n\x01"[random.next() % 16]);
    const Theirs theirs = Theirs::parse(text, nullptr, false);
    const std::vector<Json> nodes = parseJson(text);
    refused += nodes.empty();
    if (theirs.is_discarded()) {
      // What we take and they do not: half of a pair, half of a character of two bytes.
      const auto has = [&](const char* piece) { return text.find(piece) != std::string::npos; };
      if (!has("ud83d") && !has("ude00") && !has("\xc3") && !has("\xa9")) ASSERT_TRUE(nodes.empty()) << text;
    } else {
      ASSERT_FALSE(nodes.empty()) << text;
      ASSERT_TRUE(isSame(nodes[0], theirs)) << text;
    }
  }
  EXPECT_GT(refused, 3000);
}

TEST(Json, RefusesWhatIsNone) {
  for (const char* text : {"", " ", "[", "{", "[1,]", "{\"a\":1,}", "{\"a\"}", "{a:1}", "[1 2]", "01", "1.", "+1", ".5", "1e", "-", "tru",
                           "nul", "\"", "\"\\x\"", "\"\\u12g4\"", "\"a\nb\"", "1 2", "]", "{\"a\":}", "//", "NaN"})
    EXPECT_TRUE(parseJson(text).empty()) << text;
}

TEST(Json, OfSeveralValuesOfOneKeyTakesTheLast) {
  const std::string text = R"({"a":1,"b":2,"\u0061":3})";
  EXPECT_EQ(parseJson(text)[0].find("a")->number(), 3);
}

TEST(Json, AnswersQuestionsThatDoNotFitWithNothing) {
  const std::string text = R"(["x",5,{}])";
  const std::vector<Json> nodes = parseJson(text);
  EXPECT_EQ(nodes[0].find("x"), nullptr);
  EXPECT_EQ(nodes[0].text(), "");
  EXPECT_TRUE(std::isnan(nodes[1].number()));
  EXPECT_EQ(nodes[3].find("x"), nullptr);
  EXPECT_EQ(nodes[3].count(), 0u);
}

TEST(Json, ReplacesHalfAPairOfSurrogates) {
  const std::string text = R"("\ud83dx\ude00")";
  EXPECT_EQ(parseJson(text)[0].text(), "\xef\xbf\xbdx\xef\xbf\xbd");
}

TEST(Json, WritesStringsThatReadBack) {
  const std::string text = "a \"b\" \\ \n\x1f \xe2\x82\xac";
  const std::string json = jsonString(text);
  EXPECT_EQ(Theirs::parse(json), text);
  EXPECT_EQ(parseJson(json)[0].text(), text);
}

}  // namespace
}  // namespace fur
