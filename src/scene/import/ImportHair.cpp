#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "scene/HairFile.h"
#include "scene/Model.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie in memory");

enum Flag : std::uint32_t { kSegments = 1, kPoints = 2, kThickness = 4, kTransparency = 8, kColors = 16, kAll = 31 };
// Farther from the origin points are taken for garbage: their squares would leave no digits.
constexpr float kFarthest = 1e9f;

struct Header {
  char magic[4];
  std::uint32_t strands, points, flags, segments;
  float thickness, transparency, color[3];
  char info[kHairInfoBytes];
};
static_assert(sizeof(Header) == kHairHeaderBytes);

class HairFileReader {
 public:
  HairFileReader(Bytes bytes, const std::string& name) : bytes_(bytes), name_(name.c_str()) {}

  HairFile run() {
    readHeader();
    checkSize();
    if (header_.flags & kSegments) take(hair_.segments, header_.strands);
    else hair_.segments.assign(header_.strands, static_cast<std::uint16_t>(header_.segments));
    checkSegments();
    take(hair_.points, header_.points);
    if (header_.flags & kThickness) take(hair_.thickness, header_.points);
    if (header_.flags & kTransparency) take(hair_.transparency, header_.points);
    if (header_.flags & kColors) take(hair_.colors, header_.points);
    checkNumbers();
    return std::move(hair_);
  }

 private:
  template <class... T>
  [[noreturn]] void fail(ErrorId id, const char* format, T... values) {
    throw ImportError({id, formatted(format, name_, values...)});
  }

  void readHeader() {
    if (bytes_.size() > kMaxFileBytes) fail(ErrorId::TooLarge, "%s: it has %zu bytes; at most %zu are read", bytes_.size(), kMaxFileBytes);
    if (bytes_.size() < sizeof header_) fail(ErrorId::BadFile, "%s: it has %zu bytes; the header of a .hair file has %zu", bytes_.size(), kHairHeaderBytes);
    std::memcpy(&header_, bytes_.data(), sizeof header_);
    bytes_ = bytes_.subspan(sizeof header_);
    if (std::memcmp(header_.magic, "HAIR", 4) != 0) fail(ErrorId::BadFile, "%s: it does not begin with HAIR");
    if (header_.flags & ~std::uint32_t{kAll}) fail(ErrorId::UnsupportedVersion, "%s: its flags are %u; 1, 2, 4, 8 and 16 are known", header_.flags);
    if (!(header_.flags & kPoints)) fail(ErrorId::BadFile, "%s: it has no points");
    if (header_.strands == 0 || header_.points == 0) fail(ErrorId::BadFile, "%s: it has %u strands and %u points", header_.strands, header_.points);
    if (header_.strands > kMaxStrands) fail(ErrorId::TooLarge, "%s: it has %u strands; at most %zu are read", header_.strands, kMaxStrands);
    if (header_.points > kMaxHairPoints) fail(ErrorId::TooLarge, "%s: it has %u points; at most %zu are read", header_.points, kMaxHairPoints);
    if (!(header_.flags & kSegments) && (header_.segments == 0 || header_.segments > kMaxSegments))
      fail(ErrorId::BadFile, "%s: its strands have %u segments each; 1 to %u can be", header_.segments, kMaxSegments);
    const float numbers[] = {header_.thickness, header_.transparency, header_.color[0], header_.color[1], header_.color[2]};
    if (!std::all_of(std::begin(numbers), std::end(numbers), [](float x) { return std::isfinite(x); }))
      fail(ErrorId::BadFile, "%s: a default in its header is not a number");
    hair_.defaultThickness = header_.thickness;
    hair_.defaultTransparency = header_.transparency;
    hair_.defaultColor = {header_.color[0], header_.color[1], header_.color[2]};
    hair_.info.assign(header_.info, std::find(header_.info, header_.info + kHairInfoBytes, '\0'));
  }

  // Before any memory is asked for. Limits keep these sums within 32 bits, wasm's too.
  void checkSize() {
    const auto of = [&](Flag flag, std::size_t each) { return header_.flags & flag ? each : 0; };
    const std::size_t perPoint = of(kPoints, 12) + of(kThickness, 4) + of(kTransparency, 4) + of(kColors, 12);
    const std::size_t needed = header_.strands * of(kSegments, 2) + header_.points * perPoint;
    if (needed > bytes_.size())
      fail(ErrorId::BadFile, "%s: its %u strands and %u points need %zu bytes after the header; it has %zu", header_.strands, header_.points, needed,
           bytes_.size());
  }

  void checkSegments() {
    std::uint64_t sum = 0;
    for (const std::uint16_t segments : hair_.segments) sum += segments + std::uint64_t{1};
    if (sum != header_.points)
      fail(ErrorId::BadFile, "%s: the segments of its strands make %llu points; its header says %u", static_cast<unsigned long long>(sum), header_.points);
  }

  void checkNumbers() {
    for (std::size_t i = 0; i < hair_.points.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(hair_.points[i][axis]) <= kFarthest)) fail(ErrorId::BadFile, "%s: point %zu is no place within 10^9 of the origin", i);
    checkAll(hair_.thickness, "thickness");
    checkAll(hair_.transparency, "transparency");
    for (std::size_t i = 0; i < hair_.colors.size(); ++i)
      for (int c = 0; c < 3; ++c)
        if (!std::isfinite(hair_.colors[i][c])) fail(ErrorId::BadFile, "%s: the %s of point %zu is not a number", "colour", i);
  }
  void checkAll(const std::vector<float>& values, const char* what) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i])) fail(ErrorId::BadFile, "%s: the %s of point %zu is not a number", what, i);
  }

  template <class T>
  void take(std::vector<T>& to, std::size_t count) {
    to.resize(count);
    std::memcpy(to.data(), bytes_.data(), count * sizeof(T));
    bytes_ = bytes_.subspan(count * sizeof(T));
  }

  Bytes bytes_;
  const char* name_;
  Header header_{};
  HairFile hair_;
};

}  // namespace

Result<HairFile> readHair(std::span<const std::uint8_t> bytes, const std::string& name) {
  return guardedImport<HairFile>(name, [&] { return HairFileReader(bytes, name).run(); });
}

}  // namespace fur::scene
