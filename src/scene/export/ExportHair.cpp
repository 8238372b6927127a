#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

#include "core/NumberText.h"
#include "hair/MemberStrands.h"
#include "hair/StrandShading.h"
#include "scene/HairFile.h"

namespace fur::scene {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

constexpr float kSegmentsOfCurl = 10;  // of each of its turns

Vec3 inAxesOf(const Vec3& p, HairUp up) { return up == HairUp::Z ? Vec3(p.x, -p.z, p.y) : p; }

template <class T>
void append(std::vector<std::uint8_t>& to, std::span<const T> values) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
  to.insert(to.end(), first, first + values.size_bytes());
}
template <class T>
void appendOne(std::vector<std::uint8_t>& to, const T& value) {
  append(to, std::span<const T>(&value, 1));
}

Vec3 colorOf(std::uint32_t rgb) { return Vec3(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255) / 255.0f; }

struct Expansion {
  std::span<const hair::Wisp> wisps;
  std::span<const hair::GuideNode> nodes;
  int nodesEach;
  const hair::HairValues& values;
  HairUp up;
  int segments;

  // All strands of one wisp.
  void expand(const hair::Wisp& wisp, std::span<const hair::MemberStrand> members, HairFile& out) const {
    const hair::WispShape shape = hair::shapeOf(values);
    for (const hair::MemberStrand& member : members) {
      for (int i = 0; i <= segments; ++i) {
        // A strand ends before its wisp.
        const float share = static_cast<float>(i) / static_cast<float>(segments), t = member.length * share;
        const hair::WispPoint point = hair::wispPoint(wisp, nodes, nodesEach, shape, t);
        out.points.push_back(inAxesOf(hair::memberPoint(point, hair::memberOffset(member, t), wisp.width, shape, t), up));
        out.thickness.push_back(values.strandWidth * hair::memberWidth(member, t));
        const float variance = 0.5f * (wisp.random + member.random);
        const Vec3 color = hair::strandColor(colorOf(values.rootColor), colorOf(values.tipColor), share, variance, values.variance);
        out.colors.push_back(glm::clamp(color, Vec3(0), Vec3(1)));
      }
      out.segments.push_back(static_cast<std::uint16_t>(segments));
    }
  }
};

}  // namespace

std::vector<std::uint8_t> writeHair(const HairFile& hair) {
  std::vector<std::uint8_t> out;
  append(out, std::span<const char>("HAIR", 4));
  const bool even = std::adjacent_find(hair.segments.begin(), hair.segments.end(), std::not_equal_to<>()) == hair.segments.end();
  const auto flag = [](bool set, std::uint32_t bit) { return set ? bit : 0u; };
  appendOne(out, static_cast<std::uint32_t>(hair.segments.size()));
  appendOne(out, static_cast<std::uint32_t>(hair.points.size()));
  appendOne(out, flag(!even, 1) | 2u | flag(!hair.thickness.empty(), 4) | flag(!hair.transparency.empty(), 8) | flag(!hair.colors.empty(), 16));
  appendOne(out, static_cast<std::uint32_t>(even && !hair.segments.empty() ? hair.segments[0] : 0));
  appendOne(out, hair.defaultThickness);
  appendOne(out, hair.defaultTransparency);
  appendOne(out, hair.defaultColor);
  char info[kHairInfoBytes]{};
  std::memcpy(info, hair.info.data(), std::min(hair.info.size(), kHairInfoBytes - 1));
  append(out, std::span<const char>(info));
  if (!even) append(out, std::span(hair.segments));
  append(out, std::span(hair.points));
  append(out, std::span(hair.thickness));
  append(out, std::span(hair.transparency));
  append(out, std::span(hair.colors));
  return out;
}

HairFile hairOfGuides(const hair::Guides& guides, float width, HairUp up) {
  HairFile out;
  out.defaultThickness = width;
  out.segments.assign(guides.count(), static_cast<std::uint16_t>(guides.nodes - 1));
  for (const Vec3& p : guides.positions) out.points.push_back(inAxesOf(p, up));
  return out;
}

Result<HairFile> hairOfWisps(std::span<const hair::Wisp> wisps, std::span<const hair::GuideNode> nodes, int nodesEach,
                             const hair::HairValues& values, HairUp up) {
  const auto curls = static_cast<int>(values.curl > 0 ? kSegmentsOfCurl * values.curls : 0.0f);
  const Expansion expansion{wisps, nodes, nodesEach, values, up, std::max(hair::kStripSegments, curls)};
  const std::vector<hair::MemberStrand> members = hair::memberStrands(values.strands, values);
  const std::size_t each = members.size() / hair::kWispKinds, strands = wisps.size() * each;
  const std::size_t points = strands * static_cast<std::size_t>(expansion.segments + 1);
  if (strands > kMaxStrands || points > kMaxHairPoints)
    return Error{ErrorId::TooLarge, "hair: " + decimal(strands) + " strands of " + decimal(points) + " points; a .hair file has at most " +
                                        decimal(kMaxStrands) + " of " + decimal(kMaxHairPoints)};
  HairFile out;
  out.defaultThickness = values.strandWidth;
  out.defaultColor = colorOf(values.rootColor);
  out.points.reserve(points), out.thickness.reserve(points), out.colors.reserve(points);
  for (const hair::Wisp& wisp : wisps)
    expansion.expand(wisp, std::span(members).subspan(static_cast<std::size_t>(hair::wispKind(wisp.random)) * each, each), out);
  return out;
}

}  // namespace fur::scene
