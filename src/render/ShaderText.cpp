#include "render/ShaderText.h"

#include <algorithm>
#include <vector>

#include "render/ShaderSources.h"

namespace fur::render {

namespace {

std::span<const shaders::Included> others;

// `seen`: the files that are in the text.
void append(std::string& text, std::string_view source, std::vector<const shaders::Included*>& seen) {
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
    for (const std::span<const shaders::Included> files : {std::span<const shaders::Included>(shaders::kIncluded), others})
      for (const shaders::Included& file : files) {
        if (name != file.name || std::find(seen.begin(), seen.end(), &file) != seen.end()) continue;
        seen.push_back(&file);
        append(text, file.text, seen);
      }
  }
}

}  // namespace

std::string stageText(std::string_view source) {
  std::string text;
  std::vector<const shaders::Included*> seen;
  append(text, source, seen);
  return text;
}

void includeAlso(std::span<const shaders::Included> files) { others = files; }

}  // namespace fur::render
