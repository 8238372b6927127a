// ZIP files (ISO/IEC 21320-1) whose content is stored as it is: for what is compressed already.
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

// Less than 4 GiB, and fewer than 65,536 files. The files' date is the first that the format knows: the same files make
// the same bytes.
std::vector<std::uint8_t> writeZip(std::span<const NamedFile> files);

}  // namespace fur::scene
