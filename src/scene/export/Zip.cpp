#include "scene/Zip.h"

#include "core/Assert.h"

namespace fur::scene {

namespace {

constexpr std::uint32_t kLocalHeader = 0x04034b50, kCentralHeader = 0x02014b50, kEnd = 0x06054b50;
constexpr std::uint32_t kVersion = 20, kUtf8 = 1 << 11;
constexpr std::uint32_t kFirstDate = 1 << 5 | 1;  // 1 January 1980

// The checksum of ISO 3309, as PNG has it.
std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

class ZipWriter {
 public:
  std::vector<std::uint8_t> out;
  void two(std::uint32_t value) { few(value, 2); }
  void four(std::uint32_t value) { few(value, 4); }
  void text(const std::string& text) { out.insert(out.end(), text.begin(), text.end()); }
  std::uint32_t at() const { return static_cast<std::uint32_t>(out.size()); }

 private:
  void few(std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  }
};

// What both headers of a file have, from its version on.
void describe(ZipWriter& to, const NamedFile& file, std::uint32_t crc) {
  to.two(kVersion);
  to.two(kUtf8);
  to.two(0);  // stored
  to.two(0);  // midnight
  to.two(kFirstDate);
  to.four(crc);
  to.four(static_cast<std::uint32_t>(file.bytes.size()));
  to.four(static_cast<std::uint32_t>(file.bytes.size()));
  to.two(static_cast<std::uint32_t>(file.name.size()));
  to.two(0);  // no extra field
}

}  // namespace

std::vector<std::uint8_t> writeZip(std::span<const NamedFile> files) {
  FUR_ASSERT(files.size() < 65536, "scene::writeZip()", "fewer than 65536 files", files.size());
  ZipWriter zip, central;
  for (const NamedFile& file : files) {
    const std::uint32_t crc = crc32(file.bytes), start = zip.at();
    zip.four(kLocalHeader);
    describe(zip, file, crc);
    zip.text(file.name);
    zip.out.insert(zip.out.end(), file.bytes.begin(), file.bytes.end());
    central.four(kCentralHeader);
    central.two(kVersion);
    describe(central, file, crc);
    central.two(0);   // no comment
    central.two(0);   // the first disk
    central.two(0);
    central.four(0);  // no attributes
    central.four(start);
    central.text(file.name);
  }
  const std::uint32_t start = zip.at();
  zip.out.insert(zip.out.end(), central.out.begin(), central.out.end());
  zip.four(kEnd);
  zip.two(0);
  zip.two(0);
  zip.two(static_cast<std::uint32_t>(files.size()));
  zip.two(static_cast<std::uint32_t>(files.size()));
  zip.four(central.at());
  zip.four(start);
  zip.two(0);
  return std::move(zip.out);
}

}  // namespace fur::scene
