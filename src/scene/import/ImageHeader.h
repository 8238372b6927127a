// Format and size of an image from its first bytes, to check limits before decoding.
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

// Nothing for other formats, or when the bytes end before the size.
std::optional<ImageHeader> readImageHeader(std::span<const std::uint8_t> bytes);

}  // namespace fur::scene
