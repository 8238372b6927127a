#include "scene/Png.h"

#include <algorithm>
#include <string>

#include "core/Assert.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace fur::scene {

std::vector<std::uint8_t> writePng(int width, int height, int channels, std::span<const std::uint8_t> pixels) {
  FUR_ASSERT(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels),
             "writePng()", "width * height * channels bytes", pixels.size());
  std::vector<std::uint8_t> file;
  const auto append = [](void* to, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(to)->insert(static_cast<std::vector<std::uint8_t>*>(to)->end(), bytes, bytes + size);
  };
  stbi_write_png_to_func(append, &file, width, height, channels, pixels.data(), width * channels);
  return file;
}

void makeStraight(std::span<std::uint8_t> rgba) {
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const int alpha = rgba[i + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t k = 0; k < 3; ++k) rgba[i + k] = static_cast<std::uint8_t>(std::min(255, (rgba[i + k] * 255 + alpha / 2) / alpha));
  }
}

}  // namespace fur::scene
