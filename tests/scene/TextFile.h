// A file of text as the bytes that importers take.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace fur::scene {

inline std::vector<std::uint8_t> textFile(std::string_view text) { return {text.begin(), text.end()}; }

}  // namespace fur::scene
