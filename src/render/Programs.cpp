#include "render/Programs.h"

#include <algorithm>
#include <array>

#include "core/Assert.h"
#include "render/ShaderSources.h"
#include "render/ShaderText.h"
#include "shared/Hair.h"
#include "shared/Material.h"

namespace fur::render {

namespace {

constexpr std::size_t kOfHair = static_cast<std::size_t>(Shader::Hair);
std::array<const ProvidedShader*, static_cast<std::size_t>(Shader::HiddenHairLine) - kOfHair + 1> provided{};

// All from the first one of hair on.
const ProvidedShader& providedText(Shader shader) {
  const ProvidedShader* text = shader < Shader::Hair ? nullptr : provided[static_cast<std::size_t>(shader) - kOfHair];
  FUR_ASSERT(text, "Programs::use()", "a program that has this shader", static_cast<int>(shader));
  return *text;
}

// Apart from the vertex shaders, and named first: the linker keeps this order, in which fragment shaders, which
// share most of their text, lie within the 32 KB that the download's compression looks back.
const char* fragmentOf(Shader shader, VariantBits variant) {
  if (variant & kViewOverdraw) return shaders::kViewOverdrawFrag;
  if (shader == Shader::Fin && variant & kViewEdges) return shaders::kViewEdgeFrag;
  switch (shader) {
    case Shader::Background: return shaders::kBackgroundFrag;
    case Shader::Ground: return shaders::kGroundFrag;
    case Shader::GroundShadow: return shaders::kGroundShadowFrag;
    case Shader::Blur: return shaders::kBlurFrag;
    case Shader::Skin: return shaders::kSkinFrag;
    case Shader::Shell: return shaders::kShellFrag;
    case Shader::ClassicShell: return shaders::kClassicShellFrag;
    case Shader::Fin: return shaders::kFinFrag;
    case Shader::ShadowMap: return shaders::kShadowMapFrag;
    case Shader::Enlarge: return shaders::kEnlargeFrag;
    case Shader::Mean: return shaders::kMeanFrag;
    case Shader::ShowMean: return shaders::kShowMeanFrag;
    case Shader::Whisker: return shaders::kWhiskerFrag;
    case Shader::Drop:
    case Shader::Bead: return shaders::kDropFrag;
    case Shader::Ball: return shaders::kBallFrag;
    case Shader::Arrow: return shaders::kArrowFrag;
    case Shader::Bare: return shaders::kBareFrag;
    case Shader::ShadowBlur: return shaders::kShadowBlurFrag;
    default: return providedText(shader).fragment;
  }
}

struct Source {
  const char* label;
  const char* vertex;
  std::string defines{};
};

Source sourceOf(Shader shader) {
  switch (shader) {
    case Shader::Background: return {"background", shaders::kBackgroundVert};
    case Shader::Ground: return {"ground", shaders::kGroundVert};
    case Shader::GroundShadow: return {"ground_shadow", shaders::kGroundShadowVert};
    case Shader::Blur: return {"blur", shaders::kScreenVert};
    case Shader::Skin: return {"skin", shaders::kSkinVert};
    case Shader::Shell: return {"shell", shaders::kShellVert};
    case Shader::ClassicShell: return {"classic_shell", shaders::kClassicShellVert};
    case Shader::Enlarge: return {"enlarge", shaders::kScreenVert};
    case Shader::Mean: return {"mean", shaders::kScreenVert};
    case Shader::ShowMean: return {"show_mean", shaders::kScreenVert};
    case Shader::Fin: return {"fin", shaders::kFinVert};
    case Shader::Whisker: return {"whisker", shaders::kWhiskerVert};
    case Shader::Drop: return {"drop", shaders::kDropVert};
    case Shader::Bead: return {"bead", shaders::kBeadVert, "#define BEAD\n"};
    case Shader::ShadowMap: return {"shadow_map", shaders::kShadowMapVert};
    case Shader::Ball: return {"ball", shaders::kBallVert};
    case Shader::Arrow: return {"arrow", shaders::kArrowVert};
    case Shader::Bare: return {"bare", shaders::kBareVert};
    case Shader::ShadowBlur: return {"shadow_blur", shaders::kScreenVert};
    default: return {providedText(shader).label, providedText(shader).vertex, providedText(shader).defines};
  }
}

std::string definesOf(VariantBits variant) {
  static constexpr std::pair<Variant, const char*> kNames[] = {
      {kWet, "WET"},
      {kViewTangents, "VIEW_TANGENTS"},
      {kViewCoverage, "VIEW_COVERAGE"},
      {kViewWetness, "VIEW_WETNESS"},
      {kViewNormals, "VIEW_NORMALS"},
      {kViewDominance, "VIEW_DOMINANCE"},
      {kViewTypes, "VIEW_TYPES"},
      {kViewOffset, "VIEW_OFFSET"},
      {kTextured, "TEXTURED"},
      {kUnderFur, "UNDER_FUR"},
      {kMarschner, "MARSCHNER"},
      {kShadowDepth, "SHADOW_DEPTH"},
      {kShadowLayers, "SHADOW_LAYERS"},
      {kSkinOnly, "SKIN_ONLY"},
      {kBall, "BALL"},
      {kGroomed, "GROOMED"},
      {kTypes, "TYPES"},
      {kViewLayer, "VIEW_LAYER"},
      {kViewExploded, "VIEW_EXPLODED"},
      {kViewDim, "VIEW_DIM"},
      {kViewEdges, "VIEW_EDGES"},
      {kViewClumps, "VIEW_CLUMPS"},
      {kViewShadow, "VIEW_SHADOW"},
      {kViewSteps, "VIEW_STEPS"},
      {kViewForces, "VIEW_FORCES"},
      {kPolynomial, "POLYNOMIAL"},
      {kViewLayout, "VIEW_LAYOUT"},
      {kPainted, "PAINTED"},
      {kShaped, "SHAPED"},
      {kStrips, "STRIPS"},
      {kOnGround, "ON_GROUND"},
      {kClassic, "CLASSIC"},
      {kPrintedLobe, "PRINTED_LOBE"},
      {kPrintedClumps, "PRINTED_CLUMPS"},
      {kPrintedLight, "PRINTED_LIGHT"},
      {kBorders, "BORDERS"},
  };
  std::string text;
  for (const auto& [bit, name] : kNames)
    if (variant & bit) text += std::string("#define ") + name + " 1\n";
  return text;
}

// Strands stand as in the tile, by the groom's map, by several types; and brushes have changed their shape.
constexpr VariantBits kGrooms[] = {kPlain, kGroomed, kGroomed | kTypes, kGroomed | kShaped, kGroomed | kTypes | kShaped};

// Of the technique `shells`: what stands where under one shadow, each shadow, and each light.
void addClassic(std::vector<std::pair<Shader, VariantBits>>& all) {
  const auto add = [&](VariantBits look) {
    all.emplace_back(Shader::ClassicShell, look | kClassic);
    all.emplace_back(Shader::Fin, look | kClassic);
  };
  constexpr VariantBits kPrinted = kPrintedLobe | kPrintedClumps | kPrintedLight;
  for (const VariantBits look : {+kPlain, kWet | kTextured})
    for (const VariantBits groom : kGrooms) add(look | groom | kShadowDepth);
  for (const VariantBits look : {+kPlain, +kShadowLayers, kMarschner | kShadowDepth, kShadowDepth | kPolynomial, kShadowDepth | kPainted,
                                 kPainted | kTextured | kGroomed | kShaped | kWet, kPrintedLobe | kShadowDepth, kPrintedLight | kShadowDepth,
                                 kWet | kPrintedLobe | kShadowDepth, kWet | kPrintedClumps | kShadowDepth, kWet | kPrintedLight | kShadowDepth,
                                 kWet | kPrinted | kGroomed | kTypes | kShadowDepth})
    add(look);
  for (const VariantBits look : {+kPlain, +kWet, +kTextured, kGroomed | kPainted, kGroomed | kTypes, kTextured | kGroomed | kTypes})
    all.emplace_back(Shader::Skin, look | kUnderFur | kClassic | kShadowDepth);
}

}  // namespace

void Programs::provide(Shader shader, const ProvidedShader& text) { provided[static_cast<std::size_t>(shader) - kOfHair] = &text; }

std::vector<Programs::Entry>::iterator Programs::find(Shader shader, VariantBits variant) {
  return std::find_if(programs_.begin(), programs_.end(), [&](const Entry& entry) { return entry.shader == shader && entry.variant == variant; });
}

void Programs::begin(Shader shader, VariantBits variant) {
  if (find(shader, variant) != programs_.end()) return;
  const Source source = sourceOf(shader);
  programs_.push_back({shader, variant,
                       gl::Program::begin(source.label, stageText(source.vertex), stageText(fragmentOf(shader, variant)), source.defines + definesOf(variant))});
}

bool Programs::ready() const {
  return std::all_of(programs_.begin(), programs_.end(), [](const Entry& entry) { return entry.finished || entry.program.linked(); });
}

bool Programs::finish(gl::Program& program) {
  if (const Status status = program.finish(); !status) {
    error_ = status.error();
    return false;
  }
  program.bindBlock("FrameBlock", FUR_FRAME_BINDING);
  program.bindBlock("FurBlock", FUR_COAT_BINDING);
  program.bindBlock("HairBlock", FUR_HAIR_BINDING);
  program.bindBlock("MaterialBlock", FUR_MATERIAL_BINDING);
  program.bindSampler("coverage", FUR_UNIT_COVERAGE);
  program.bindSampler("strand", FUR_UNIT_STRAND);
  program.bindSampler("offset", FUR_UNIT_OFFSET);
  program.bindSampler("finCoverage", FUR_UNIT_FIN_COVERAGE);
  program.bindSampler("finStrand", FUR_UNIT_FIN_STRAND);
  program.bindSampler("mask", FUR_UNIT_MASK);
  program.bindSampler("bends", FUR_UNIT_BEND);
  program.bindSampler("groom", FUR_UNIT_GROOM);
  program.bindSampler("evenReach", FUR_UNIT_EVEN_REACH);
  program.bindSampler("paint", FUR_UNIT_PAINT);
  program.bindSampler("shapeMap", FUR_UNIT_SHAPE);
  program.bindSampler("lockCentres", FUR_UNIT_LOCK_CENTRES);
  program.bindSampler("baseColor", FUR_UNIT_BASE_COLOR);
  program.bindSampler("typeColors", FUR_UNIT_TYPE_COLORS);
  program.bindSampler("shadowMap", FUR_UNIT_GROUND);
  program.bindSampler("puddles", FUR_UNIT_PUDDLES);
  program.bindSampler("streaks", FUR_UNIT_STREAKS);
  program.bindSampler("source", FUR_UNIT_GROUND);
  program.bindSampler("before", FUR_UNIT_MEAN);
  program.bindSampler("strandM", FUR_UNIT_STRAND_M);
  program.bindSampler("strandN", FUR_UNIT_STRAND_N);
  program.bindSampler("firstSurfaces", FUR_UNIT_SHADOW);
  program.bindSampler("opacities", FUR_UNIT_OPACITY);
  program.bindSampler("hairNodes", FUR_UNIT_HAIR_NODES);
  program.bindSampler("wisps", FUR_UNIT_WISPS);
  program.bindSampler("hairPoints", FUR_UNIT_HAIR_POINTS);
  program.bindSampler("memberStrands", FUR_UNIT_MEMBER_STRANDS);
  program.bindSampler("strips", FUR_UNIT_STRIPS);
  program.bindSampler("ambient", FUR_UNIT_HAIR_AMBIENT);
  program.bindSampler("wispOrder", FUR_UNIT_WISP_ORDER);
  program.bindSampler("baseTangents", FUR_UNIT_BASE_TANGENTS);
  program.bindSampler("normals", FUR_UNIT_NORMALS);
  program.bindSampler("roughnessMap", FUR_UNIT_ROUGHNESS);
  program.bindSampler("occlusionMap", FUR_UNIT_OCCLUSION);
  program.bindSampler("emissiveMap", FUR_UNIT_EMISSIVE);
  program.bindSampler("hairColors", FUR_UNIT_HAIR_COLORS);
  return true;
}

const gl::Program* Programs::use(Shader shader, VariantBits variant) {
  begin(shader, variant);
  const auto entry = find(shader, variant);
  if (!entry->finished && !finish(entry->program)) {
    programs_.erase(entry);
    return nullptr;
  }
  entry->finished = true;
  entry->program.use();
  return &entry->program;
}

std::vector<std::pair<Shader, VariantBits>> allVariants() {
  std::vector<std::pair<Shader, VariantBits>> all = {
      {Shader::Background, kPlain}, {Shader::GroundShadow, kPlain}, {Shader::Blur, kPlain}, {Shader::ShadowBlur, kShadowDepth},
      {Shader::Skin, kViewWetness}, {Shader::Skin, kViewNormals},   {Shader::Skin, kViewLayout},  {Shader::ShadowMap, kPlain},
      {Shader::Enlarge, kPlain},    {Shader::Mean, kPlain},       {Shader::ShowMean, kPlain},    {Shader::Drop, kPlain}, {Shader::Bead, kPlain}, {Shader::Bead, kPolynomial},       {Shader::Ground, kPlain},      {Shader::Ground, kWet},     {Shader::Ball, kPlain},
      {Shader::ShadowMap, kShadowLayers}, {Shader::ShadowMap, kSkinOnly},
      {Shader::ShadowMap, kBall},   {Shader::GroundShadow, kBall},
      {Shader::Skin, kViewClumps},  {Shader::Skin, kViewDim},     {Shader::Fin, kViewEdges},
      {Shader::Arrow, kPlain},      {Shader::Arrow, kPolynomial}, {Shader::Arrow, kViewForces},
      {Shader::HairPoints, kPlain}, {Shader::HairShadow, kPlain}, {Shader::HairShadow, kShadowLayers}, {Shader::HairShadow, kOnGround},
      {Shader::HairDepth, kPlain}, {Shader::HairDepth, kStrips},
      {Shader::HairMap, kPlain},    {Shader::HairWisp, kPlain},   {Shader::HairLine, kPlain},    {Shader::HiddenHairLine, kPlain},
      {Shader::ShadowMap, kPolynomial}, {Shader::ShadowMap, kPolynomial | kShadowLayers},
      {Shader::ShadowMap, kGroomed}, {Shader::ShadowMap, kGroomed | kShadowLayers}, {Shader::ShadowMap, kGroomed | kSkinOnly},
      {Shader::ShadowMap, kGroomed | kTypes}, {Shader::ShadowMap, kGroomed | kTypes | kShadowLayers}, {Shader::ShadowMap, kGroomed | kTypes | kSkinOnly},
      {Shader::Skin, kPainted}, {Shader::Skin, kPainted | kTextured},
      {Shader::Shell, kPolynomial}, {Shader::Fin, kPolynomial},   {Shader::Whisker, kPolynomial},
  };
  for (const VariantBits look : {+kPlain, +kViewClumps, +kShadowDepth, kShadowDepth | kTextured, kShadowDepth | kMarschner, kShadowLayers | kPainted | kTextured})
    for (const VariantBits groom : kGrooms) all.emplace_back(Shader::Shell, look | groom | kWet | kBorders);
  for (const Shader counted : {Shader::Shell, Shader::Fin, Shader::Skin}) all.emplace_back(counted, kViewOverdraw);
  // Paint looks the same in whatever shadow.
  for (const VariantBits look : {+kPlain, +kWet, +kTextured, kWet | kTextured})
    for (const VariantBits groom : kGrooms) {
      const VariantBits painted = look | groom | kPainted | kShadowDepth;
      for (const VariantBits light : {kPlain, kMarschner})
        for (const Shader shader : {Shader::Shell, Shader::Fin}) all.emplace_back(shader, painted | light);
      if (!(groom & kShaped)) all.emplace_back(Shader::Skin, painted | kUnderFur);
      all.emplace_back(Shader::Shell, look | groom | kPainted | kViewLayer);
    }
  addClassic(all);
  for (const VariantBits look : {+kPlain, +kWet})
    for (const VariantBits groom : kGrooms)
      for (const VariantBits view : {+kViewClumps, +kViewSteps, +kViewLayer, kViewLayer | kTextured, kViewLayer | kViewExploded,
                                  kViewLayer | kViewExploded | kTextured, +kViewTangents, +kViewCoverage, +kViewDominance,
                                  +kViewTypes, +kViewOffset})
        all.emplace_back(Shader::Shell, view | look | groom);
  for (const VariantBits shadow : {kPlain, kShadowDepth, kShadowLayers}) {
    all.emplace_back(Shader::Bare, shadow);
    all.emplace_back(Shader::Skin, shadow | kTextured | kGroomed | kTypes);  // with a picture of its own
    for (const VariantBits look : {+kPlain, +kTextured}) {
      all.emplace_back(Shader::Skin, look | shadow);
      for (const VariantBits groom : {+kPlain, +kGroomed, kGroomed | kTypes})
        for (const VariantBits wet : {kPlain, kWet}) all.emplace_back(Shader::Skin, look | shadow | groom | wet | kUnderFur);
    }
    for (const VariantBits look : {+kPlain, +kWet, +kMarschner, kWet | kMarschner}) {
      all.emplace_back(Shader::Whisker, look | shadow);
      for (const VariantBits shape : {+kPlain, +kStrips}) all.emplace_back(Shader::Hair, look | shadow | shape);
      all.emplace_back(Shader::BlendedHair, look | shadow | kStrips);
      if (!(look & kWet)) all.emplace_back(Shader::HairSkin, look | shadow);
    }
    for (const VariantBits look : {+kPlain, +kUnderFur}) all.emplace_back(Shader::Skin, look | shadow | kViewShadow);
    for (const VariantBits groom : kGrooms) {
      for (const VariantBits look : {+kPlain, +kWet})
        for (const Shader shader : {Shader::Shell, Shader::Fin}) all.emplace_back(shader, look | shadow | groom | kViewShadow);
      for (const VariantBits look : {+kPlain, +kWet, +kTextured, kWet | kTextured})
        for (const VariantBits light : {kPlain, kMarschner})
          for (const Shader shader : {Shader::Shell, Shader::Fin}) all.emplace_back(shader, light | look | shadow | groom);
    }
  }
  return all;
}

}  // namespace fur::render
