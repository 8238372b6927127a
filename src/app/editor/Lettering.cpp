#include "app/editor/Lettering.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <imgui.h>
#include <imgui_internal.h>  // single characters of a text

namespace fur::app {

void stampLetters(App& app, const std::string& text, const Vec2& free) {
  unsigned char* pixels = nullptr;
  int across = 0, down = 0;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &across, &down);
  const ImFont& font = *ImGui::GetFont();
  const int width = static_cast<int>(font.CalcTextSizeA(font.FontSize, 1e9f, 0, text.c_str()).x) + 2;
  const int height = static_cast<int>(font.FontSize) + 2;
  std::vector<std::uint8_t> coverage(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  float pen = 0;
  for (const char* at = text.c_str(); *at;) {
    unsigned int character = 0;
    at += ImTextCharFromUtf8(&character, at, nullptr);
    const ImFontGlyph& glyph = *font.FindGlyph(static_cast<ImWchar>(character));
    const int left = static_cast<int>(pen + glyph.X0), top = static_cast<int>(glyph.Y0);
    const int fromX = static_cast<int>(std::lround(glyph.U0 * static_cast<float>(across)));
    const int fromY = static_cast<int>(std::lround(glyph.V0 * static_cast<float>(down)));
    for (int y = 0; y < static_cast<int>(glyph.Y1 - glyph.Y0) && glyph.Visible; ++y)
      for (int x = 0; x < static_cast<int>(glyph.X1 - glyph.X0); ++x)
        if (left + x >= 0 && left + x < width && top + y >= 0 && top + y < height)
          coverage[static_cast<std::size_t>((top + y) * width + left + x)] = pixels[(fromY + y) * across + fromX + x];
    pen += glyph.AdvanceX;
  }
  app.stamp(coverage, width, height, 0.5f * free, std::min(0.5f * free.x, 0.28f * free.y * pen / font.FontSize));
}

}  // namespace fur::app
