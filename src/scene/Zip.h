// ZIP files (ISO/IEC 21320-1) without compression, for content that is compressed already.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fur::scene {

struct NamedFile {
  std::string name;  // UTF-8
  std::vector<std::uint8_t> bytes;
};

// Less than 4 GiB and fewer than 65,536 files. All dates are the format's first, so that the same files give the same bytes.
std::vector<std::uint8_t> writeZip(std::span<const NamedFile> files);

}  // namespace fur::scene
