// PNG and JPEG to pixels, with stb_image, where no browser does it. Other formats are refused before its code sees them, and
// the size in the header is checked before anything is decoded: the files are not to be trusted.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Result.h"

namespace fur::scene {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // rows from the top
};

// bad-file: neither PNG nor JPEG, or damaged. too-large: a side over kMaxImageSide (at most
// 256 MiB of pixels, then), or more bytes than kMaxFileBytes.
Result<Image> decodeImage(std::span<const std::uint8_t> bytes);

}  // namespace fur::scene
