#include "hair/Scalp.h"

#include <algorithm>

namespace fur::hair {

std::string soundName(std::string_view name) {
  constexpr std::size_t kMost = 64;
  std::size_t size = std::min(name.size(), kMost);
  // A byte 10xxxxxx goes on with the character before it.
  while (size < name.size() && size > 0 && (static_cast<unsigned char>(name[size]) & 0xc0u) == 0x80u) --size;
  return std::string(name.substr(0, size));
}

}  // namespace fur::hair
