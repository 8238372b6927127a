#include "scene/import/ImageHeader.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "scene/Model.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

namespace {

bool matches(Bytes bytes, std::size_t at, std::string_view text) {
  if (bytes.size() < at + text.size()) return false;
  return std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char c, std::uint8_t byte) { return static_cast<std::uint8_t>(c) == byte; });
}

std::uint32_t bigEndian(Bytes bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[at + i];
  return value;
}

std::uint32_t littleEndian(Bytes bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | bytes[at + i];
  return value;
}

// PNG (ISO/IEC 15948) 11.2.2: IHDR comes first.
std::optional<ImageHeader> readPng(Bytes bytes) {
  if (bytes.size() < 24 || !matches(bytes, 12, "IHDR")) return {};
  return ImageHeader{"image/png", bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
}

// JPEG (ITU T.81) B.2.2: the size stands in the frame header, SOF0 to SOF15 but for DHT, JPG and DAC.
std::optional<ImageHeader> readJpeg(Bytes bytes) {
  std::size_t at = 2;
  while (at + 9 <= bytes.size()) {
    if (bytes[at] != 0xff) return {};
    const std::uint8_t marker = bytes[at + 1];
    if (marker == 0xff) {  // fill bytes
      ++at;
      continue;
    }
    const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) return ImageHeader{"image/jpeg", bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2)};
    const std::uint32_t length = bigEndian(bytes, at + 2, 2);
    if (length < 2 || marker == 0xd9 || marker == 0xda) return {};
    at += 2 + static_cast<std::size_t>(length);
  }
  return {};
}

// RFC 9649 (WebP) 2.5 to 2.7: lossy, lossless, extended.
std::optional<ImageHeader> readWebp(Bytes bytes) {
  if (bytes.size() < 30) return {};
  if (matches(bytes, 12, "VP8 ")) {
    return ImageHeader{"image/webp", littleEndian(bytes, 26, 2) & 0x3fffu, littleEndian(bytes, 28, 2) & 0x3fffu};
  }
  if (matches(bytes, 12, "VP8L")) {
    const std::uint32_t bits = littleEndian(bytes, 21, 4);
    return ImageHeader{"image/webp", (bits & 0x3fffu) + 1, (bits >> 14 & 0x3fffu) + 1};
  }
  if (matches(bytes, 12, "VP8X")) {
    return ImageHeader{"image/webp", littleEndian(bytes, 24, 3) + 1, littleEndian(bytes, 27, 3) + 1};
  }
  return {};
}

}  // namespace

std::optional<ImageHeader> readImageHeader(Bytes bytes) {
  if (matches(bytes, 0, "\x89PNG\r\n\x1a\n")) return readPng(bytes);
  if (matches(bytes, 0, "\xff\xd8\xff")) return readJpeg(bytes);
  if (matches(bytes, 0, "RIFF") && matches(bytes, 8, "WEBP")) return readWebp(bytes);
  return {};
}

Result<EncodedImage> encodedImage(std::vector<std::uint8_t> bytes, const std::string& what) {
  const auto header = readImageHeader(bytes);
  if (!header || header->width == 0 || header->height == 0) return Error{ErrorId::BadFile, what + " is no PNG, JPEG or WebP"};
  constexpr std::uint32_t kMost = kMaxImageSide;
  if (header->width > kMost || header->height > kMost)
    return Error{ErrorId::TooLarge, formatted("%s has %u x %u texels; the limit is %u along a side", what.c_str(), header->width, header->height, kMost)};
  return EncodedImage{header->mimeType, std::move(bytes), static_cast<int>(header->width), static_cast<int>(header->height)};
}

}  // namespace fur::scene
