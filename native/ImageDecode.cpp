#include "native/ImageDecode.h"

#include <algorithm>
#include <array>
#include <memory>

#include "scene/Model.h"

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192
#include <stb/stb_image.h>

namespace fur::native {

static_assert(STBI_MAX_DIMENSIONS == scene::kMaxImageSide);

namespace {

bool startsWith(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> magic) {
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

}  // namespace

Result<Image> decodeImage(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 8> kPng = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  constexpr std::array<std::uint8_t, 3> kJpeg = {0xff, 0xd8, 0xff};
  if (!startsWith(bytes, kPng) && !startsWith(bytes, kJpeg))
    return Error{ErrorId::BadFile, "the image is neither PNG nor JPEG"};
  if (bytes.size() > scene::kMaxFileBytes) return Error{ErrorId::TooLarge, "the image has more than 256 MiB"};
  const int size = static_cast<int>(bytes.size());

  Image image;
  int channels = 0;
  if (!stbi_info_from_memory(bytes.data(), size, &image.width, &image.height, &channels)) {
    const std::string reason = stbi_failure_reason();
    if (reason == "too large")
      return Error{ErrorId::TooLarge, "the image has a side of more than " + std::to_string(scene::kMaxImageSide)};
    return Error{ErrorId::BadFile, "the image is damaged: " + reason};
  }
  if (std::max(image.width, image.height) > scene::kMaxImageSide ||
      std::int64_t{image.width} * image.height > kMaxImagePixels)
    return Error{ErrorId::TooLarge, "the image is " + sizeText(image.width, image.height) + ", the limits are " +
                                        std::to_string(scene::kMaxImageSide) + " a side and 64 Mi texels"};

  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes.data(), size, &image.width, &image.height, &channels, 4), stbi_image_free);
  if (!pixels) return Error{ErrorId::BadFile, std::string("the image is damaged: ") + stbi_failure_reason()};
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
  image.rgba.assign(pixels.get(), pixels.get() + count);
  return image;
}

}  // namespace fur::native
