// Reading and writing whole files, for both native programs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/App.h"
#include "core/Result.h"

namespace fur::native {

Result<std::vector<std::uint8_t>> readFile(const std::string& path);
// RGBA8 rows from the top.
Status writePng(const std::string& path, int width, int height, const std::vector<std::uint8_t>& rgba);

// A model by path, or "sphere", "torus", "plane", or "bunny" (models/bunny.glb beside the program or
// below its parent folders). Decodes its picture too; one that cannot be decoded is a warning.
Status loadScene(app::App& app, const std::string& nameOrPath, const std::string& programPath);

}  // namespace fur::native
