#include "scene/Zip.h"

#include <cstring>

#include <gtest/gtest.h>

namespace fur::scene {
namespace {

std::uint32_t numberAt(const std::vector<std::uint8_t>& bytes, std::size_t at, int count) {
  std::uint32_t out = 0;
  for (int i = 0; i < count; ++i) out |= static_cast<std::uint32_t>(bytes[at + static_cast<std::size_t>(i)]) << 8 * i;
  return out;
}

// Read as unpackers do: from the end, by the central directory.
TEST(Zip, GivesEveryFileBackByItsDirectory) {
  const std::vector<NamedFile> files{{"a.txt", {'1', '2', '3', '4', '5', '6', '7', '8', '9'}}, {"empty", {}}, {"b.bin", std::vector<std::uint8_t>(1000, 7)}};
  const std::vector<std::uint8_t> zip = writeZip(files);
  const std::size_t end = zip.size() - 22;
  ASSERT_EQ(numberAt(zip, end, 4), 0x06054b50u);
  ASSERT_EQ(numberAt(zip, end + 10, 2), files.size());
  std::size_t at = numberAt(zip, end + 16, 4);
  EXPECT_EQ(at + numberAt(zip, end + 12, 4), end);
  for (const NamedFile& file : files) {
    ASSERT_EQ(numberAt(zip, at, 4), 0x02014b50u);
    const std::size_t size = numberAt(zip, at + 24, 4), name = numberAt(zip, at + 28, 2), start = numberAt(zip, at + 42, 4);
    EXPECT_EQ(std::string(&zip[at + 46], &zip[at + 46] + name), file.name);
    ASSERT_EQ(numberAt(zip, start, 4), 0x04034b50u);
    EXPECT_EQ(numberAt(zip, start + 8, 2), 0u) << "stored";
    const std::size_t data = start + 30 + numberAt(zip, start + 26, 2);
    ASSERT_EQ(size, file.bytes.size());
    EXPECT_TRUE(std::equal(file.bytes.begin(), file.bytes.end(), zip.begin() + static_cast<std::ptrdiff_t>(data)));
    at += 46 + name;
  }
  // The check value of CRC-32.
  EXPECT_EQ(numberAt(zip, 14, 4), 0xcbf43926u);
}

TEST(Zip, OfNothingIsAnEmptyArchive) { EXPECT_EQ(writeZip({}).size(), 22u); }

}  // namespace
}  // namespace fur::scene
