#include "render/ShaderText.h"

#include <cstdint>
#include <iterator>

#include "render/ShaderSources.h"

namespace fur::render {

namespace {

// `seen`: one bit for each of kIncluded.
void append(std::string& text, std::string_view source, std::uint64_t& seen) {
  constexpr std::string_view kInclude = "#include \"";
  while (!source.empty()) {
    const std::size_t end = source.find('\n');
    const std::string_view line = source.substr(0, end);
    source.remove_prefix(end == source.npos ? source.size() : end + 1);
    if (line.substr(0, kInclude.size()) != kInclude) {
      text.append(line).push_back('\n');
      continue;
    }
    const std::string_view name = line.substr(kInclude.size(), line.size() - kInclude.size() - 1);
    for (std::size_t i = 0; i < std::size(shaders::kIncluded); ++i) {
      if (name != shaders::kIncluded[i].name || (seen >> i & 1u)) continue;
      seen |= std::uint64_t{1} << i;
      append(text, shaders::kIncluded[i].text, seen);
    }
  }
}

}  // namespace

std::string stageText(std::string_view source) {
  static_assert(std::size(shaders::kIncluded) <= 64);
  std::string text;
  std::uint64_t seen = 0;
  append(text, source, seen);
  return text;
}

}  // namespace fur::render
