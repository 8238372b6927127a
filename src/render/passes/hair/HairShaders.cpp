#include "render/passes/hair/HairShaders.h"

#include "render/Programs.h"
#include "render/ShaderSources.h"
#include "render/ShaderText.h"

namespace fur::render {

void provideHairShaders() {
  static constexpr std::pair<Shader, ProvidedShader> kTexts[] = {
      {Shader::Hair, {"hair", shaders::kHairVert, shaders::kHairFrag}},
      {Shader::BlendedHair, {"hair", shaders::kHairVert, shaders::kHairFrag, "#define BLENDED 1\n"}},
      {Shader::HairDepth, {"hair_depth", shaders::kHairVert, shaders::kHairDepthFrag}},
      {Shader::HairPoints, {"hair_points", shaders::kScreenVert, shaders::kHairPointsFrag}},
      {Shader::HairShadow, {"hair_shadow", shaders::kHairShadowVert, shaders::kHairShadowFrag}},
      {Shader::HairSkin, {"hair_skin", shaders::kHairSkinVert, shaders::kHairSkinFrag}},
      {Shader::HairMap, {"hair_map", shaders::kHairMapVert, shaders::kHairMapFrag}},
      {Shader::HairWisp, {"hair_wisp", shaders::kHairWispVert, shaders::kHairWispFrag}},
      {Shader::HairLine, {"hair_line", shaders::kHairLineVert, shaders::kHairLineFrag}},
      {Shader::HiddenHairLine, {"hair_line", shaders::kHairLineVert, shaders::kHairLineFrag, "#define HIDDEN 1\n"}},
  };
  includeAlso(shaders::kHairIncluded);
  for (const auto& [shader, text] : kTexts) Programs::provide(shader, text);
}

}  // namespace fur::render
