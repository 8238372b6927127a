#include "render/Renderer.h"

#include <algorithm>
#include <cmath>

#include "settings/Presets.h"

namespace fur::render {

namespace {

constexpr int kGroundShadowSize = 128;

Vec3 directionFrom(float yaw, float pitch) {
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

Vec4 shownColor(std::uint32_t rgb) {
  return Vec4((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u, 255.0f) / 255.0f;
}

// From this share of its densest layer up a coat keeps the light from its roots.
constexpr float kCrowdedDensity = 0.35f;

Vec3 lightDirection(const Frame& frame) {
  const Vec3 view = frame.camera.eye - frame.camera.target;
  const float turned = frame.settings.lightFollowsCamera ? std::atan2(view.x, view.z) : 0;
  return directionFrom(frame.settings.lightYaw + turned, frame.settings.lightPitch);
}

// What the key light and the rim light are at the settings' 1.
constexpr float kKeyLight = 2.2f, kRimLight = 2.4f;
// Of the fill light that much comes from all round, which skin gets, too.
constexpr float kFillAround = 0.25f;

// How a pass is drawn: as usual, or its fragments counted.
gl::DrawState stateOf(unsigned variant, const gl::DrawState& usual) {
  if (!(variant & (kViewOverdraw | kViewSteps))) return usual;
  return {.depthWrite = false, .cullBack = usual.cullBack, .blend = gl::Blend::Add, .nearer = true};
}

Vec3 eyeInModel(const Frame& frame) { return Vec3(glm::inverse(frame.worldFromModel) * Vec4(frame.camera.eye, 1)); }

}  // namespace

// Whether strands are so large that one cut at a chart's border can be seen. Below two texels a pixel; a strand is some
// four texels wide.
bool chartsOverlap(const Frame& frame) {
  const float distance = glm::length(frame.camera.eye - frame.camera.target);
  return frame.settings.repeat * 256.0f * distance < 2.0f * pixelsPerUnit(frame);
}

shared::FrameBlock frameBlock(const Frame& frame) {
  const settings::Settings& s = frame.settings;
  const Mat4 modelFromWorld = glm::inverse(frame.worldFromModel);
  const Vec3 lightWorld = lightDirection(frame);
  const auto direction = [&](const Vec3& v) { return modelFromWorld * Vec4(v, 0); };
  const Vec3 top = settings::linearColor(s.backgroundTop), bottom = settings::linearColor(s.backgroundBottom);
  shared::FrameBlock block{};
  block.clipFromWorld = clipFromWorld(frame);
  block.clipFromModel = block.clipFromWorld * frame.worldFromModel;
  block.worldFromModel = frame.worldFromModel;
  block.eye = modelFromWorld * Vec4(frame.camera.eye, 1);
  block.light = direction(lightWorld);
  block.lightWorld = Vec4(lightWorld, 0);
  block.up = direction({0, 1, 0});
  block.pixelsPerUnit = pixelsPerUnit(frame);
  block.lightIntensity = kKeyLight * s.lightIntensity;
  block.keyLight = Vec4(settings::linearColor(s.keyColor) * block.lightIntensity, 1);
  block.fillLight = (1 - kFillAround) * s.fillLight;
  block.backLight = Vec4(settings::linearColor(s.rimColor) * (kRimLight * s.rimLight), 1);
  block.exposure = s.exposure;
  // The surroundings light the fur with their own colour, half of it taken out.
  const Vec3 around(kFillAround * s.fillLight);
  block.sky = Vec4(s.ambient * glm::mix(Vec3(0.75f), top, 0.5f) * settings::linearColor(s.skyColor) + around, 1);
  block.floorLight = Vec4(s.ambient * 0.55f * glm::mix(Vec3(0.6f), bottom, 0.5f) * settings::linearColor(s.groundColor) + around, 1);
  block.viewLayer = s.viewLayer;
  block.backgroundTop = shownColor(s.backgroundTop);
  block.backgroundBottom = shownColor(s.backgroundBottom);
  block.pictureHeight = static_cast<float>(frame.height);
  block.bottomRow = static_cast<float>(frame.bottomRow);
  block.groundCentre = {frame.worldFromModel[3].x, frame.worldFromModel[3].z};
  block.groundHeight = frame.groundHeight;
  block.groundHalfSide = kGroundHalfSide;
  block.groundDarkness = 0.55f;
  block.ballCentre = Vec4(Vec3(frame.ball), 1);
  block.ballRadius = frame.ball.w;
  return block;
}

shared::FurBlock furBlock(const Frame& frame, int tileSize, int storedLayers, const FurDensities& densities, int maskSize) {
  const settings::Settings& s = frame.settings;
  shared::FurBlock coat{};
  coat.furLength = s.furLength;
  coat.tilesPerUnit = s.repeat * 256.0f / static_cast<float>(tileSize);
  coat.layers = static_cast<float>(s.layers);
  coat.slabs = static_cast<float>(frame.slabs);
  coat.tileTexels = static_cast<float>(tileSize);
  coat.storedLayers = static_cast<float>(storedLayers);
  coat.density = *std::max_element(densities.begin(), densities.end());
  coat.stepLength = frame.stepLength;
  const Vec3 factor(frame.baseColorFactor);
  for (int type = 0; type < FUR_TYPES; ++type) {
    const settings::Settings look = settings::typeCoat(s, type);
    coat.rootColors[type] = Vec4(settings::linearColor(look.rootColor) * factor, 1);
    coat.tipColors[type] = Vec4(settings::linearColor(look.tipColor) * factor, 1);
    coat.typeGrows[type] = densities[static_cast<std::size_t>(type)] > 0;
    coat.typeVariance[type] = look.variance;
    coat.typeRise[type] = 1 / std::max(settings::typeHeight(s, type), 1e-6f);
  }
  coat.skinColor = Vec4(settings::linearColor(s.skinColor) * factor, 1);
  coat.lobePeak = 0.39894228f / strandLobeWidth(s);
  // Where few strands stand, they hardly darken each other and the skin.
  const float crowding = saturate(coat.density / kCrowdedDensity);
  coat.lambert = s.lambert;
  coat.specular = s.specular;
  coat.shininess = s.shininess;
  coat.strandShadow = s.strandShadow * crowding;
  coat.occlusion = s.occlusion * crowding;
  coat.textureAmount = s.textureAmount;
  coat.chartsOverlap = chartsOverlap(frame);
  coat.clumpShape = s.clumpShape;
  coat.wetDarkening = s.wetDarkening;
  coat.wetGloss = s.wetGloss;
  coat.maskTexels = static_cast<float>(maskSize);
  return coat;
}

float pixelsPerUnit(const Frame& frame) {
  return static_cast<float>(frame.height) / (2 * std::tan(frame.camera.fovY / 2));
}

Mat4 clipFromWorld(const Frame& frame) {
  const float aspect = static_cast<float>(frame.width) / static_cast<float>(std::max(frame.height, 1));
  const float distance = glm::length(frame.camera.eye - frame.camera.target);
  const Mat4 projection = glm::perspective(frame.camera.fovY, aspect, std::max(0.02f, distance - 3.0f - frame.reach), distance + 7.0f + frame.reach);
  return projection * glm::lookAt(frame.camera.eye, frame.camera.target, Vec3(0, 1, 0));
}

Result<Renderer> Renderer::create() {
  const auto capabilities = gl::queryCapabilities();
  if (!capabilities) return capabilities.error();
  Renderer r;
  const unsigned usual = shadowVariant({});
  for (const auto& [shader, variant] :
       {std::pair(Shader::Shell, usual), std::pair(Shader::Fin, usual), std::pair(Shader::Skin, usual | kUnderFur),
        std::pair(Shader::ShadowMap, +kPlain), std::pair(Shader::ShadowBlur, +kShadowDepth),
        std::pair(Shader::Ground, +kPlain), std::pair(Shader::GroundShadow, +kPlain), std::pair(Shader::Blur, +kPlain), std::pair(Shader::Background, +kPlain)})
    r.programs_.begin(shader, variant);
  const shared::FrameBlock frame{};
  const shared::FurBlock coat{};
  r.frameBlock_ = gl::Buffer(gl::BufferKind::Uniform, gl::bytesOf(frame), true);
  r.coatBlock_ = gl::Buffer(gl::BufferKind::Uniform, gl::bytesOf(coat), true);
  for (int i = 0; i < 2; ++i) {
    r.groundShadow_[i] = gl::Texture({gl::TexelFormat::RGBA8, kGroundShadowSize, kGroundShadowSize, 0}, {});
    r.groundTarget_[i] = gl::Target::toTexture(r.groundShadow_[i]);
  }
  r.setBaseColor(0, 0, {});
  r.updateGroom(groom::GroomMap(groom::GroomMap::kLeastSize), {});
  return r;
}

void Renderer::uploadBlocks(const Frame& frame) {
  const shared::FurBlock coat = furBlock(frame, fur_.size(), fur_.layers(), densities_, mask_.shape().width);
  shared::FrameBlock block = frameBlock(frame);
  furShadowKey(frame).fill(block);
  block.samples = static_cast<float>(std::max(1, gl::platformSamples()));
  frameBlock_.update(gl::bytesOf(block));
  coatBlock_.update(gl::bytesOf(coat));
  frameBlock_.bindAsBlock(FUR_FRAME_BINDING);
  coatBlock_.bindAsBlock(FUR_COAT_BINDING);
  uploadedBytes_ += sizeof block + sizeof coat;
}

void Renderer::warmUp(const Frame& frame) {
  const float bald[] = {0};
  beginFur(1, 1, 1, 1);
  showFur(bald);
  hasFur_ = true;
  Frame pixel = frame;
  pixel.width = pixel.height = 1;
  (void)draw(pixel);  // whoever draws next has the error, too
  hasFur_ = false;
  gl::flush();
  // Drivers put off a pass that is flushed until another begins: one that paints nothing which is kept.
  groundTarget_[1].bind();
  gl::clear(Vec4(0));
  gl::bindPlatformFramebuffer();
  gl::flush();
}

Status Renderer::draw(const Frame& frame) {
  FUR_ASSERT(indexCount_ > 0, "Renderer::draw()", "a surface", indexCount_);
  const bool large = frame.pixelScale >= 1, whole = large && frame.bands <= 1;
  const auto scaled = [&](int side) {
    return large ? side : std::max(1, static_cast<int>(std::lround(static_cast<float>(side) * frame.pixelScale)));
  };
  Frame drawn = frame;
  drawn.width = scaled(frame.width);
  drawn.height = scaled(frame.height);
  drawnPixels_ = static_cast<long>(drawn.width) * drawn.height;
  uploadBlocks(drawn);
  if (drawn.settings.ground)
    if (Status status = drawGroundShadow(drawn); !status) return status;
  fur_.bind(frame.wet);
  mask_.bind(FUR_UNIT_MASK);
  bends_.bind(FUR_UNIT_BEND);
  groom_.bind(FUR_UNIT_GROOM);
  if (frame.painted) paint_.bind(FUR_UNIT_PAINT);
  if (frame.shaped) shape_.bind(FUR_UNIT_SHAPE), lockCentres_.bind(FUR_UNIT_LOCK_CENTRES);
  if (Status status = furShadow_.update(programs_, furShadowKey(frame), surface_, indexCount_); !status) return status;
  if (!whole)
    if (Status status = small_.begin(drawn.width, drawn.height); !status) return status;
  gl::setViewport(drawn.width, drawn.height, frame.bottomRow);
  if (frame.bands > 1) {
    const auto edge = [&](int band) { return drawn.height * band / frame.bands; };
    gl::drawOnlyRows(edge(frame.band), edge(frame.band + 1) - edge(frame.band), drawn.width);
  }
  gl::clear(Vec4(0, 0, 0, 1));
  baseColor_.bind(FUR_UNIT_BASE_COLOR);
  groundShadow_[0].bind(FUR_UNIT_GROUND);
  if (!frame.puddles.empty()) showPuddles(frame.puddles);
  uploadedBytes_ += strandTables_.use(frame.settings);
  if (Status status = drawPasses(drawn); !status) return status;
  if (drawn.transparent && drawn.settings.view != 0)
    if (Status status = drawBackground(drawn); !status) return status;
  if (whole) return Done{};
  gl::setViewport(frame.width, frame.height);
  if (frame.band + 1 == frame.bands) return small_.show(programs_);
  gl::flush();
  gl::bindPlatformFramebuffer();
  return Done{};
}

Status Renderer::drawPasses(const Frame& frame) {
  const auto view = static_cast<View>(frame.settings.view);
  const unsigned look = (frame.wet ? kWet : kPlain) | (hasPicture_ ? kTextured : kPlain) |
                        (frame.settings.strandModel ? kMarschner : kPlain) | shadowVariant(frame.settings) |
                        (frame.types ? kTypes : kPlain) | (frame.groomed || frame.types || frame.shaped ? kGroomed : kPlain) |
                        (frame.painted ? kPainted : kPlain) | (frame.shaped ? kShaped : kPlain);
  constexpr unsigned kFurOnly = kGroomed | kTypes;
  const unsigned skinLook = look & ~(kWet | kMarschner | kShaped), curve = curveVariant(frame.settings);
  const bool furry = hasFur_ && frame.settings.furLength > 0 && !patches_.indices.empty();
  const auto skin = [&](unsigned variant) { return drawSkin(variant); };
  // Of the look, what a view shows, so that fewer shaders are compiled.
  const auto shown = [](unsigned look, unsigned view) {
    unsigned kept = ~0u;
    constexpr unsigned kStands = kWet | kGroomed | kTypes | kShaped;  // where strands stand
    if (view & (kViewTangents | kViewCoverage | kViewDominance | kViewTypes | kViewOffset | kViewClumps | kViewSteps)) kept = kStands;
    if (view & kViewShadow) kept = ~(kMarschner | kTextured | kPainted);
    if (view & kViewLayer) kept = kStands | kTextured | kPainted;
    if (view & (kViewOverdraw | kViewEdges)) kept = kPlain;
    return (look & kept) | view;
  };
  const auto shells = [&](unsigned view) {
    return furry ? drawShells(frame, curve | shown(look, view)) : Status(Done{});
  };
  const auto fins = [&](unsigned view) {
    return furry && frame.settings.fins ? drawFins(frame, curve | shown(look, view)) : Status(Done{});
  };
  const auto model = [&](unsigned view) {
    if (Status status = shells(view); !status) return status;
    if (Status status = fins(view); !status) return status;
    const unsigned under = kUnderFur | (view == kPlain ? look & kWet : kPlain);
    return skin(shown(furry ? (view == kViewShadow ? skinLook & ~kFurOnly : skinLook) | under : skinLook & ~kFurOnly, view));
  };
  const auto both = [](Status first, auto&& second) { return first ? second() : first; };
  const bool counts = view == View::Overdraw || view == View::Steps;
  if (view != View::Final && !counts && !frame.transparent)
    if (Status status = drawBackground(frame); !status) return status;
  switch (view) {
    case View::Skin: return skin(skinLook & ~kFurOnly);
    case View::Wetness: return skin(kViewWetness);
    case View::Normals: return skin(kViewNormals);
    case View::Layout: return skin(kViewLayout);
    case View::Shells: return shells(kPlain);
    case View::Fins: return fins(kPlain);
    case View::Tangents: return shells(kViewTangents);
    case View::Coverage: return shells(kViewCoverage);
    case View::Dominance: return shells(kViewDominance);
    case View::Types: return shells(kViewTypes);
    case View::Offset: return shells(kViewOffset);
    case View::Layer: return both(skin(kViewDim), [&] { return shells(kViewLayer); });
    case View::Exploded: return both(skin(kViewDim), [&] { return shells(kViewLayer | kViewExploded); });
    case View::Clumps: return both(shells(kViewClumps), [&] { return skin(kViewClumps); });
    case View::Bends: return both(skin(kViewDim), [&] { return drawArrows(curve); });
    case View::Forces: return both(skin(kViewDim), [&] { return drawArrows(kViewForces); });
    case View::Silhouette:
      return both(skin(kViewDim), [&] { return furry ? drawFins(frame, kViewEdges) : Status(Done{}); });
    case View::Shadow: return model(kViewShadow);
    case View::Overdraw:
    case View::Steps:
    case View::Final: break;
  }
  if (frame.ball.w > 0 && !counts) {
    const auto program = programs_.use(Shader::Ball, kPlain);
    if (!program) return program.error();
    gl::apply({});
    gl::drawWithoutVertices(6 * FUR_BALL_AROUND * FUR_BALL_DOWN);
  }
  if (Status status = model(kPlain); !status) return status;
  if (!counts) {
    if (Status status = whiskers_.draw(programs_, curve | (look & ~(kTextured | kFurOnly | kPainted | kShaped))); !status) return status;
    if (Status status = drawBackground(frame); !status) return status;
    return drops_.draw(programs_, frame.drops, uploadedBytes_);
  }
  // The picture leaves its depth behind, then fragments are counted that are no further.
  gl::clearColor();
  return view == View::Steps ? shells(kViewSteps) : model(kViewOverdraw);
}

// Where nothing else is; of a transparent picture it is what is taken away there.
Status Renderer::drawBackground(const Frame& frame) {
  gl::apply({.cullBack = false, .blend = frame.transparent ? gl::Blend::Erase : gl::Blend::None});
  const auto drawn = [&](Shader shader, unsigned variant, int squares) -> Status {
    const auto program = programs_.use(shader, variant);
    if (!program) return program.error();
    gl::drawWithoutVertices(6 * squares);
    return Done{};
  };
  if (frame.settings.ground && frame.settings.view == 0 && !frame.transparent)
    if (Status status = drawn(Shader::Ground, frame.puddles.empty() ? kPlain : kWet, FUR_GROUND_CELLS * FUR_GROUND_CELLS); !status)
      return status;
  return drawn(Shader::Background, kPlain, FUR_BACKGROUND_STRIPS);
}

FurShadow::Key Renderer::furShadowKey(const Frame& frame) const {
  settings::Settings s = frame.settings;
  if (patches_.indices.empty()) s.furLength = 0;
  const Vec3 light(glm::inverse(frame.worldFromModel) * Vec4(lightDirection(frame), 0));
  return {static_cast<Shadows>(s.shadows), lightFromModel(light, shadowRadius(s.furLength, frame.reach)),
          volumeShadow(s, *std::max_element(densities_.begin(), densities_.end()), frame.reach),
          curveVariant(s) | (frame.groomed || frame.types ? kGroomed : kPlain), furShadowScene_, frame.ball, frame.ball.w > 0 ? frame.worldFromModel : Mat4(1.0f)};
}

Status Renderer::drawSkin(unsigned variant) {
  const auto program = programs_.use(Shader::Skin, variant);
  if (!program) return program.error();
  gl::apply(stateOf(variant, {.cullBack = !sheets_}));
  surface_.drawIndexed(indexCount_, 1);
  return Done{};
}

Status Renderer::drawShells(const Frame& frame, unsigned variant) {
  const auto program = programs_.use(Shader::Shell, variant);
  if (!program) return program.error();
  const bool exploded = variant & kViewExploded;
  orderShells(eyeInModel(frame), frame.settings.furLength + (exploded ? FUR_EXPLODED_SHELLS * FUR_EXPLODED_GAP : 0),
              chartsOverlap(frame) && !exploded);
  if (shellIndexCount_ == 0) return Done{};
  gl::apply(stateOf(variant, {.alphaToCoverage = true, .alpha = false}));
  shells_.drawIndexed(shellIndexCount_, exploded ? FUR_EXPLODED_SHELLS : variant & kViewLayer ? 1 : frame.slabs);
  return Done{};
}

Status Renderer::drawFins(const Frame& frame, unsigned variant) {
  const bool lines = variant & kViewEdges;
  selectFins(eyeInModel(frame), lines ? 0 : frame.settings.furLength * pixelsPerUnit(frame));
  if (finCount_ == 0) return Done{};
  const auto program = programs_.use(Shader::Fin, variant);
  if (!program) return program.error();
  gl::apply(stateOf(variant, {.cullBack = false, .alphaToCoverage = !lines, .alpha = false}));
  fins_.drawStrips(2 * (FUR_FIN_SEGMENTS + 1), finCount_);
  return Done{};
}

Status Renderer::drawArrows(unsigned variant) {
  const auto program = programs_.use(Shader::Arrow, variant);
  if (!program) return program.error();
  gl::apply({.cullBack = false});
  arrows_.drawStrips(2 * FUR_ARROW_POINTS, vertexCount_);
  return Done{};
}

Status Renderer::drawGroundShadow(const Frame& frame) {
  const settings::Settings& s = frame.settings;
  const bool wet = !frame.puddles.empty();
  const ShadowKey key{frame.worldFromModel, lightDirection(frame), s.furLength, frame.groundHeight, frame.ball, wet ? frame.camera.eye : Vec3(0)};
  if (shadowKey_ == key) return Done{};
  gl::setViewport(kGroundShadowSize, kGroundShadowSize);
  groundTarget_[0].bind();
  gl::clear(Vec4(0));
  const auto flat = programs_.use(Shader::GroundShadow, kPlain);
  if (!flat) return flat.error();
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false, .blend = gl::Blend::Add});
  surface_.drawIndexed(indexCount_, wet ? 3 : 2);
  if (frame.ball.w > 0) {
    const auto round = programs_.use(Shader::GroundShadow, kBall);
    if (!round) return round.error();
    gl::drawWithoutVertices(6 * FUR_BALL_AROUND * FUR_BALL_DOWN);
  }
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
  const auto blur = programs_.use(Shader::Blur, kPlain);
  if (!blur) return blur.error();
  // Across into [1], down back into [0].
  for (const int from : {0, 1}) {
    groundTarget_[1 - from].bind();
    groundShadow_[from].bind(FUR_UNIT_GROUND);
    gl::drawWithoutVertices(3, 3 * from);
  }
  gl::bindPlatformFramebuffer();
  shadowKey_ = key;
  return Done{};
}

}  // namespace fur::render
