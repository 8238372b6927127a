#include "render/Programs.h"

#include "render/ShaderSources.h"
#include "shared/Blocks.h"

namespace fur::render {

namespace {

struct Source {
  const char* label;
  const char* vertex;
  const char* fragment;
};

Source sourceOf(Shader shader) {
  switch (shader) {
    case Shader::Background: return {"background", shaders::kScreenVert, shaders::kBackgroundFrag};
    case Shader::GroundShadow: return {"ground_shadow", shaders::kGroundShadowVert, shaders::kGroundShadowFrag};
    case Shader::Blur: return {"blur", shaders::kScreenVert, shaders::kBlurFrag};
    case Shader::Ground: return {"ground", shaders::kGroundVert, shaders::kGroundFrag};
    case Shader::Skin: return {"skin", shaders::kSkinVert, shaders::kSkinFrag};
    case Shader::Shell: return {"shell", shaders::kShellVert, shaders::kShellFrag};
    case Shader::Fin: break;
  }
  return {"fin", shaders::kFinVert, shaders::kFinFrag};
}

std::string definesOf(unsigned variant) {
  static constexpr std::pair<Variant, const char*> kNames[] = {
      {kWet, "WET"},
      {kViewTangents, "VIEW_TANGENTS"},
      {kViewCoverage, "VIEW_COVERAGE"},
      {kViewWetness, "VIEW_WETNESS"},
      {kViewNormals, "VIEW_NORMALS"},
      {kStraightDown, "STRAIGHT_DOWN"},
      {kVertical, "VERTICAL"},
      {kTextured, "TEXTURED"},
  };
  std::string text;
  for (const auto& [bit, name] : kNames)
    if (variant & bit) text += std::string("#define ") + name + " 1\n";
  return text;
}

}  // namespace

Result<const gl::Program*> Programs::use(Shader shader, unsigned variant) {
  const auto key = std::pair(shader, variant);
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    const Source source = sourceOf(shader);
    auto linked = gl::Program::link(source.label, source.vertex, source.fragment, definesOf(variant));
    if (!linked) return linked.error();
    linked->bindBlock("FrameBlock", FUR_FRAME_BINDING);
    linked->bindBlock("FurBlock", FUR_COAT_BINDING);
    linked->bindSampler("tile", FUR_UNIT_TILE);
    linked->bindSampler("fin", FUR_UNIT_FIN);
    linked->bindSampler("mask", FUR_UNIT_MASK);
    linked->bindSampler("bends", FUR_UNIT_BEND);
    linked->bindSampler("baseColor", FUR_UNIT_BASE_COLOR);
    linked->bindSampler("shadowMap", FUR_UNIT_GROUND);
    linked->bindSampler("source", FUR_UNIT_GROUND);
    found = programs_.emplace(key, std::move(*linked)).first;
  }
  found->second.use();
  return &found->second;
}

std::vector<std::pair<Shader, unsigned>> allVariants() {
  std::vector<std::pair<Shader, unsigned>> all = {
      {Shader::Background, kPlain}, {Shader::Ground, kPlain},       {Shader::GroundShadow, kPlain},
      {Shader::Blur, kPlain},       {Shader::Blur, kVertical},      {Shader::GroundShadow, kStraightDown},
      {Shader::Skin, kPlain},       {Shader::Skin, kViewWetness},   {Shader::Skin, kViewNormals},
      {Shader::Skin, kTextured},
  };
  for (const unsigned look : {+kPlain, +kWet, +kTextured, kWet | kTextured}) {
    for (const unsigned view : {kPlain, kViewTangents, kViewCoverage}) all.emplace_back(Shader::Shell, view | look);
    all.emplace_back(Shader::Fin, look);
  }
  return all;
}

}  // namespace fur::render
