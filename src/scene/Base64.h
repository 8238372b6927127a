// RFC 4648 base64, as data: URIs and coat files have bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fur::scene {

std::string base64Encoded(std::span<const std::uint8_t> bytes);
// Also with the letters - and _ of its variant for URLs; nothing when a character is none of its.
std::optional<std::vector<std::uint8_t>> base64Decoded(std::string_view text);

}  // namespace fur::scene
