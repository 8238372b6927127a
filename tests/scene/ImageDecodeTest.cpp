#include "scene/ImageDecode.h"

#include "scene/Png.h"

#include <gtest/gtest.h>

#include <string>

namespace fur::scene {
namespace {

using ByteVector = std::vector<std::uint8_t>;

// PNG's CRC-32 (ISO 3309), bit by bit.
std::uint32_t crc(const ByteVector& bytes) {
  std::uint32_t c = 0xffffffffu;
  for (const std::uint8_t byte : bytes) {
    c ^= byte;
    for (int bit = 0; bit < 8; ++bit) c = c & 1 ? 0xedb88320u ^ (c >> 1) : c >> 1;
  }
  return ~c;
}

void appendNumber(ByteVector& out, std::uint32_t n) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(n >> shift));
}

void appendChunk(ByteVector& png, const std::string& type, const ByteVector& data) {
  appendNumber(png, static_cast<std::uint32_t>(data.size()));
  ByteVector body(type.begin(), type.end());
  body.insert(body.end(), data.begin(), data.end());
  png.insert(png.end(), body.begin(), body.end());
  appendNumber(png, crc(body));
}

// An RGB PNG whose header claims any size and whose data is one row, uncompressed.
ByteVector pngOf(std::uint32_t width, std::uint32_t height, const ByteVector& row) {
  ByteVector png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, header;
  appendNumber(header, width);
  appendNumber(header, height);
  header.insert(header.end(), {8, 2, 0, 0, 0});
  appendChunk(png, "IHDR", header);
  ByteVector raw = {0};  // filter: none
  raw.insert(raw.end(), row.begin(), row.end());
  const auto size = static_cast<std::uint8_t>(raw.size());
  ByteVector zlib = {0x78, 0x01, 1, size, 0, static_cast<std::uint8_t>(~size), 0xff};
  zlib.insert(zlib.end(), raw.begin(), raw.end());
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const std::uint8_t byte : raw) a = (a + byte) % 65521, b = (b + a) % 65521;
  appendNumber(zlib, b << 16 | a);
  appendChunk(png, "IDAT", zlib);
  appendChunk(png, "IEND", {});
  return png;
}

TEST(ImageDecode, GivesThePixelsOfAPng) {
  auto image = decodeImage(pngOf(2, 1, {1, 2, 3, 250, 251, 252}));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->width, 2);
  EXPECT_EQ(image->height, 1);
  EXPECT_EQ(image->rgba, (ByteVector{1, 2, 3, 255, 250, 251, 252, 255}));
}

TEST(ImageDecode, RefusesASideOf20000BeforeDecoding) {
  for (const auto& png : {pngOf(20000, 1, {0, 0, 0}), pngOf(1, 20000, {0, 0, 0})}) {
    const auto image = decodeImage(png);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().id, ErrorId::TooLarge);
  }
}

TEST(ImageDecode, RefusesOtherFormatsUnseen) {
  // A valid one-pixel BMP, which stb_image could read.
  ByteVector bmp(58, 0);
  bmp[0] = 'B', bmp[1] = 'M', bmp[10] = 54, bmp[14] = 40, bmp[18] = 1, bmp[22] = 1, bmp[26] = 1, bmp[28] = 24;
  for (const ByteVector& bytes : {bmp, ByteVector{}, ByteVector{'G', 'I', 'F', '8', '9', 'a'}, ByteVector(4096, 'x')}) {
    const auto image = decodeImage(bytes);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().id, ErrorId::BadFile);
  }
}

TEST(ImageDecode, EveryTruncationIsABadFile) {
  const ByteVector whole = pngOf(2, 1, {1, 2, 3, 4, 5, 6});
  // The last chunk, IEND with its checksum, is not needed to show the picture.
  for (std::size_t size = 0; size + 12 < whole.size() - 8; ++size) {
    const auto image = decodeImage(std::span(whole).first(size));
    ASSERT_FALSE(image) << size;
    EXPECT_EQ(image.error().id, ErrorId::BadFile) << size;
  }
}

TEST(ImageDecode, RefusesADamagedJpeg) {
  ByteVector bytes = {0xff, 0xd8, 0xff, 0xe0, 0, 16, 'J', 'F', 'I', 'F', 0};
  bytes.resize(200, 0x55);
  const auto image = decodeImage(bytes);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().id, ErrorId::BadFile);
}

TEST(ImageDecode, ReadsThePngsThatWeWrite) {
  for (const int channels : {1, 3, 4})
    for (const int width : {1, 7, 300}) {
      const int height = 90;
      std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height * channels));
      // Runs of all lengths, gradients and noise.
      for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<std::uint8_t>(i % 3000 < 1200 ? 77 : i % 3000 < 2000 ? i / 5 : i * i * 2654435761u >> 13u);
      auto image = decodeImage(writePng(width, height, channels, pixels));
      ASSERT_TRUE(image) << image.error().message;
      ASSERT_EQ(image->width, width);
      ASSERT_EQ(image->height, height);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t texel = i / static_cast<std::size_t>(channels), k = i % static_cast<std::size_t>(channels);
        ASSERT_EQ(image->rgba[4 * texel + k], pixels[i]) << i;
      }
    }
}

}  // namespace
}  // namespace fur::scene
