// Size and kind of an image from its first bytes, so that limits are checked before anything is decoded.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace fur::scene {

struct ImageHeader {
  std::string mimeType;  // "image/png", "image/jpeg" or "image/webp"
  std::uint32_t width = 0, height = 0;
};

// Nothing for bytes that are none of the three, or end before the size.
std::optional<ImageHeader> readImageHeader(std::span<const std::uint8_t> bytes);

}  // namespace fur::scene
