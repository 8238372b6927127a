// Letters of water, as the panel's font has them.
#pragma once

#include <string>

#include "app/App.h"

namespace fur::app {

// Across the middle of what is free of the picture, its pixels at the left top. Needs the panel's ImGui context.
void stampLetters(App& app, const std::string& text, const Vec2& free);

}  // namespace fur::app
