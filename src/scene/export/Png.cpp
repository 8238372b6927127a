#include "scene/Png.h"

#include <algorithm>
#include <array>

#include "core/Assert.h"

namespace fur::scene {

namespace {

using Bytes = std::vector<std::uint8_t>;

void append32(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t crcOf(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1u ^ (crc & 1u ? 0xedb88320u : 0u);
  }
  return ~crc;
}

void appendChunk(Bytes& file, const char* type, std::span<const std::uint8_t> data) {
  append32(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t from = file.size();
  file.insert(file.end(), type, type + 4);
  file.insert(file.end(), data.begin(), data.end());
  append32(file, crcOf(std::span(file).subspan(from)));
}

// Deflate (RFC 1951) with its fixed codes: one block.
class Deflater {
 public:
  explicit Deflater(std::span<const std::uint8_t> data) : data_(data), last_(1u << kHashBits, 0) {
    put(0b011, 3);  // the last block, fixed codes
    for (std::size_t at = 0; at < data.size();) at += step(at);
    literal(256);
    put(0, 7);  // the rest of the last byte
  }
  Bytes out;

 private:
  static constexpr unsigned kHashBits = 15;
  static constexpr std::size_t kFar = 32768, kShort = 4, kLong = 258;

  void put(std::uint32_t bits, unsigned count) {
    held_ |= bits << heldBits_;
    for (heldBits_ += count; heldBits_ >= 8; heldBits_ -= 8, held_ >>= 8u) out.push_back(static_cast<std::uint8_t>(held_));
  }
  // Codes go in from their highest bit.
  void code(std::uint32_t bits, unsigned count) {
    std::uint32_t turned = 0;
    for (unsigned i = 0; i < count; ++i) turned |= (bits >> i & 1u) << (count - 1 - i);
    put(turned, count);
  }
  void literal(std::uint32_t symbol) {
    if (symbol < 144) code(0x30 + symbol, 8);
    else if (symbol < 256) code(0x190 + symbol - 144, 9);
    else if (symbol < 280) code(symbol - 256, 7);
    else code(0xc0 + symbol - 280, 8);
  }
  // Length or distance less their smallest: symbols of `each` to a number of extra bits. Gives the symbol.
  static std::uint32_t split(std::uint32_t value, std::uint32_t each, std::uint32_t& extra, unsigned& bits) {
    bits = 0;
    while (value >= 2 * each << bits) ++bits;
    const std::uint32_t symbol = (bits << (each == 4 ? 2u : 1u)) + (value >> bits);
    extra = value & ((1u << bits) - 1);
    return symbol;
  }
  void match(std::size_t length, std::size_t distance) {
    std::uint32_t extra;
    unsigned bits;
    if (length == kLong) {
      literal(285);
    } else {
      const std::uint32_t symbol = split(static_cast<std::uint32_t>(length - 3), 4, extra, bits);
      literal(257 + symbol);
      put(extra, bits);
    }
    const std::uint32_t symbol = split(static_cast<std::uint32_t>(distance - 1), 2, extra, bits);
    code(symbol, 5);
    put(extra, bits);
  }
  // Writes what begins there; gives how many bytes that are.
  std::size_t step(std::size_t at) {
    const std::size_t left = std::min(data_.size() - at, kLong);
    std::size_t length = 0, from = 0;
    if (left >= kShort) {
      const std::uint32_t four = data_[at] | data_[at + 1] << 8 | data_[at + 2] << 16 | static_cast<std::uint32_t>(data_[at + 3]) << 24;
      std::size_t& newest = last_[four * 0x9e3779b1u >> (32 - kHashBits)];  // + 1; 0: none
      from = newest;
      newest = at + 1;
      if (from > 0 && at + 1 - from <= kFar)
        while (length < left && data_[from - 1 + length] == data_[at + length]) ++length;
    }
    if (length < kShort) {
      literal(data_[at]);
      return 1;
    }
    match(length, at + 1 - from);
    return length;
  }

  std::span<const std::uint8_t> data_;
  std::vector<std::size_t> last_;
  std::uint32_t held_ = 0;
  unsigned heldBits_ = 0;
};

Bytes zlibOf(std::span<const std::uint8_t> data) {
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const std::uint8_t byte : data) a = (a + byte) % 65521, b = (b + a) % 65521;
  Bytes out = {0x78, 0x01};
  const Deflater packed(data);
  out.insert(out.end(), packed.out.begin(), packed.out.end());
  append32(out, b << 16 | a);
  return out;
}

}  // namespace

Bytes writePng(int width, int height, int channels, std::span<const std::uint8_t> pixels) {
  const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
  FUR_ASSERT(pixels.size() == row * static_cast<std::size_t>(height), "scene::writePng()", "width * height * channels bytes", pixels.size());
  // Each row as its difference from the one above.
  Bytes lines;
  lines.reserve(pixels.size() + static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i % row == 0) lines.push_back(2);
    lines.push_back(static_cast<std::uint8_t>(pixels[i] - (i < row ? 0 : pixels[i - row])));
  }
  Bytes header;
  append32(header, static_cast<std::uint32_t>(width));
  append32(header, static_cast<std::uint32_t>(height));
  const std::uint8_t kind[] = {8, static_cast<std::uint8_t>(channels == 1 ? 0 : channels == 3 ? 2 : 6), 0, 0, 0};
  header.insert(header.end(), std::begin(kind), std::end(kind));
  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  appendChunk(file, "IHDR", header);
  appendChunk(file, "IDAT", zlibOf(lines));
  appendChunk(file, "IEND", {});
  return file;
}

}  // namespace fur::scene
