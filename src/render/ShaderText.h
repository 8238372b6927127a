// The text of a shader stage as the driver takes it.
#pragma once

#include <string>
#include <string_view>

namespace fur::render {

// `source` (render/ShaderSources.h) with every #include "x" replaced by that file, each at most once.
std::string stageText(std::string_view source);

}  // namespace fur::render
