// What the section "Coat" draws by hand. Each is one item of the current window. `deaf`: a finger passes
// through, so that it can scroll.
#pragma once

#include <optional>
#include <span>

#include <imgui.h>

namespace fur::editor {

struct TilePlot {
  ImTextureID texture;  // null: an empty frame
  int texels;           // along the tile's side
  int tiles;            // shown along each side, 1 or more
};

// The tile as a square; under a mouse a loupe shows the texels around it.
void tilePlot(const char* id, const TilePlot& plot, float side, bool deaf);

// Row 0 at the bottom; a line at `height`, 0 to 1.
void finPlot(ImTextureID texture, ImVec2 size, float height);

// A bar for each layer, the skin's at the bottom, as long as its share. `layer` is marked; returns the one
// that the person presses.
std::optional<int> coveragePlot(const char* id, std::span<const float> shares, int layer, ImVec2 size,
                                bool deaf);

}  // namespace fur::editor
