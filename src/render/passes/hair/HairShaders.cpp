#include "render/passes/hair/HairShaders.h"

#include "render/Programs.h"
#include "render/ShaderSources.h"
#include "render/ShaderText.h"

namespace fur::render {

void provideHairShaders() {
  includeAlso(shaders::kHairIncluded);
  static constexpr ProvidedShader kHair{"hair", shaders::kHairVert, shaders::kHairFrag}, kDepth{"hair_depth", shaders::kHairVert, shaders::kHairDepthFrag},
      kPoints{"hair_points", shaders::kScreenVert, shaders::kHairPointsFrag}, kShadow{"hair_shadow", shaders::kHairShadowVert, shaders::kHairShadowFrag},
      kSkin{"hair_skin", shaders::kHairSkinVert, shaders::kHairSkinFrag};
  Programs::provide(Shader::Hair, kHair);
  Programs::provide(Shader::HairDepth, kDepth);
  Programs::provide(Shader::HairPoints, kPoints);
  Programs::provide(Shader::HairShadow, kShadow);
  Programs::provide(Shader::HairSkin, kSkin);
}

}  // namespace fur::render
