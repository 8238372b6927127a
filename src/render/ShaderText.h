// The text of a shader stage as the driver takes it.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fur::render {

namespace shaders {
struct Included;
}

// `source` (render/ShaderSources.h) with every #include "x" replaced by that file, each at most once.
std::string stageText(std::string_view source);
// From then on these files can be included as well as shaders::kIncluded.
void includeAlso(std::span<const shaders::Included> files);

}  // namespace fur::render
