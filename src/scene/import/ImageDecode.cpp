#include "scene/ImageDecode.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "scene/Model.h"
#include "scene/import/ImageHeader.h"
#include "scene/import/ImportError.h"

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace fur::scene {

namespace {

bool startsWith(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> magic) {
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

}  // namespace

Result<Image> decodeImage(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 8> kPng = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  constexpr std::array<std::uint8_t, 3> kJpeg = {0xff, 0xd8, 0xff};
  if (!startsWith(bytes, kPng) && !startsWith(bytes, kJpeg))
    return Error{ErrorId::BadFile, "the image is neither PNG nor JPEG"};
  if (bytes.size() > kMaxFileBytes) return Error{ErrorId::TooLarge, "the image has more than 256 MiB"};
  const int size = static_cast<int>(bytes.size());

  Image image;
  int channels = 0;
  const auto header = readImageHeader(bytes);
  if (header && std::max(header->width, header->height) > std::uint32_t{kMaxImageSide})
    return Error{ErrorId::TooLarge, formatted("the image is %u x %u, the limit of a side is %d", header->width, header->height, kMaxImageSide)};
  if (!stbi_info_from_memory(bytes.data(), size, &image.width, &image.height, &channels))
    return Error{ErrorId::BadFile, "the image's header is damaged"};
  if (std::max(image.width, image.height) > kMaxImageSide) return Error{ErrorId::BadFile, "the image's header is damaged"};

  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes.data(), size, &image.width, &image.height, &channels, 4), stbi_image_free);
  if (!pixels) return Error{ErrorId::BadFile, std::string("the image is damaged: ") + stbi_failure_reason()};
  const std::size_t count =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
  image.rgba.assign(pixels.get(), pixels.get() + count);
  return image;
}

}  // namespace fur::scene
