// What is drawn: changes of the stages go up to the renderer, and a frame shows them as well as the quality allows.
#include <algorithm>
#include <numeric>
#include <utility>

#include "app/AppState.h"
#include "core/Clock.h"
#include "core/NoteChange.h"
#include "groom/EvenReach.h"
#include "scene/StateJson.h"

namespace fur::app {

Context::Context(bool linksTold) : objects_(std::make_shared<render::ContextObjects>()) {
  objects_->framebuffer = gl::boundFramebuffer();
  gl::setLinksTold(linksTold);
}
Context::~Context() = default;
void Context::use() const { gl::setPlatformFramebuffer(objects_->framebuffer); }

Status App::attach(const Context* with) {
  gl::setContextAlive(true);
  if (!with) gl::rememberPlatformFramebuffer();
  State& s = *state_;
  s.context = with ? with->objects_ : nullptr;
  auto renderer = render::Renderer::create(s.context);
  if (!renderer) return renderer.error();
  s.renderer.emplace(std::move(*renderer));
  s.uploaded = {};
  s.shells = {};
  s.coat.forgetLayers();
  ++s.changed;
  return Done{};
}

void App::detach(bool lost) {
  gl::setContextAlive(!lost);
  state_->renderer.reset();
  state_->context.reset();
  state_->forgetSamples();
  gl::setContextAlive(true);
}

void App::resize(int width, int height, float pixelRatio) {
  State& s = *state_;
  if (width != s.view.width || height != s.view.height) s.governor.forget();
  s.view.width = std::max(width, 1);
  s.view.height = std::max(height, 1);
  s.view.pixelRatio = pixelRatio;
  ++s.changed;
}

void App::setSaved(bool saved, bool transparent) {
  state_->view.camera.ignoreCovered(saved);
  state_->saved = saved;
  state_->transparent = transparent;
  ++state_->changed;
}

void App::setCovered(Vec2 shares, bool atOnce) {
  state_->view.camera.setCovered(shares, atOnce);
  state_->changed += atOnce;
}

void App::setPadding(const Vec4& shares, bool atOnce) {
  state_->view.camera.setPadding(shares, atOnce);
  state_->changed += atOnce;
}

void App::setAutoRotate(bool enabled) { state_->view.autoRotate = enabled; }

void App::setFieldOfView(float radians) {
  state_->view.camera.setFov(radians);
  ++state_->changed;
}

// --- what the stages have changed ---

bool App::State::showsMask() const { return GroomStage::editorBrushes() && !saved && grooms(hand.tool) && groom.hasMask(); }

void App::State::expect(const scene::FurData& fur, std::span<const scene::Material> materials) {
  if (!renderer) return;
  const auto varies = [](const std::vector<groom::GroomMap::Texel>& map) { return std::any_of(map.begin(), map.end(), [&](const auto& texel) { return texel != map[0]; }); };
  render::Frame f = frame();
  if (!fur.state.empty())
    if (auto state = scene::readState(fur.state)) f.settings = state->settings;
  f.coatLength = f.settings.furLength;
  f.settings.fins = f.castsShadows = false;  // not of a first picture
  f.wet = !fur.wetness.empty();
  f.types = std::any_of(fur.map.begin(), fur.map.end(), [](const auto& texel) { return texel[1] | texel[2] | texel[3]; });
  f.groomed = f.types || varies(fur.map);
  f.painted = varies(fur.paint);
  f.shaped = varies(fur.shape);
  render::Renderer::Parts parts{.whiskers = !fur.whiskers.empty()};
  for (const scene::Material& material : materials) (material.bare ? parts.bare : parts.textured) |= material.bare || material.baseColorTexture.image >= 0;
  for (const scene::TypeFiles& coat : fur.coats) parts.textured |= !coat.picture.bytes.empty();
  parts.skinPictured = !fur.coats.back().picture.bytes.empty();
  renderer->begin(f, parts);
}

void App::State::upload() {
  const bool whole = noteChange(uploaded.surface, shape.surfaceRevision());
  if (whole) renderer->setSurface(shape.surface(), shape.firstTangents(), shape.materialOf());
  uploadMaterials();
  uploadPictures();
  uploadMask(whole);
  if (noteChange(uploaded.bends, motion.bendsRevision()) || whole) renderer->updateBends(motion.shown());
  renderer->viewHair(hairView = hair->view(hairLook(hand.pointers.empty() ? hand.hover : hand.lastPosition)));
  uploadGroom(whole);
  const bool posed = noteChange(uploaded.pose, shape.poseRevision()) || whole;
  if (const auto* skin = shape.skin(); skin && posed) renderer->setSkin({skin->positions, skin->normals, skin->tangents});
  if (whole || (posed && shape.skin()) || uploaded.whiskers != groom.groom().whiskers) {
    uploaded.whiskers = groom.groom().whiskers;
    renderer->setWhiskers(groom.hairs(shape));
  }
  uploadHair();
}

void App::State::uploadMask(bool whole) {
  const bool softened = !(settings.technique == 1 && settings.printedMask), anew = noteChange(uploaded.softened, softened) || whole;
  const wet::ChartBorders* borders = water.takeBorders(shape, whole);
  if (borders) renderer->setChartBorders(water.mask().size(), borders->texels());
  for (const wet::TexelRect& part : water.takeChanged(shape, anew || borders)) renderer->updateMask(water.texels(shape, part, softened));
}

// Colour maps of the types and the skin, where they have one.
void App::State::uploadPictures() {
  const bool other = noteChange(uploaded.pictures, settings.typePictures);
  if (!noteChange(uploaded.shelf, shelf.revision()) && !other) return;
  std::array<render::SurfaceMaps::Picture, settings::kFurTypes + 1> pictures;
  for (std::size_t type = 0; type < pictures.size(); ++type)
    if (const ColorMap* map = shelf.picture(settings.typePictures[type])) pictures[type] = {map->width, map->height, map->rgba};
  renderer->setTypePictures(pictures);
}

void App::State::uploadMaterials() {
  if (noteChange(uploaded.materials, materialsRevision)) {
    renderer->setMaterials(document.materials, document.main);
    uploaded.images = 0;
    uploaded.bare.clear();
  }
  if (noteChange(uploaded.images, imageRevision))
    for (std::size_t i = 0; i < document.pictures.size(); ++i)
      if (const Document::Picture& picture = document.pictures[i]; picture.rgba) renderer->setImage(i, picture.width, picture.height, picture.rgba);
  if (noteChange(uploaded.bare, groom.groom().bare)) renderer->setBare(uploaded.bare);
}

render::HairGrowth App::State::hairGrowth(std::size_t scalp) const {
  const HairStage::Growth& growth = hair->growth(scalp);
  const hair::Scalp& of = hair->style().scalps[scalp];
  return {of.values, growth.wisps, growth.members, growth.strips, growth.ambient, growth.baseTangents, static_cast<int>(of.guides.count()), of.guides.nodes};
}

void App::State::uploadHair() {
  const std::size_t count = hair->scalpCount();
  if (uploaded.scalps.size() != count) {
    renderer->setScalps(count);
    uploaded.scalps.assign(count, {});
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (noteChange(uploaded.scalps[i].growth, hair->growthRevision(i))) {
      renderer->growHair(i, hairGrowth(i));
      uploaded.scalps[i].nodes = 0;
    }
    if (noteChange(uploaded.scalps[i].nodes, hair->nodesRevision(i))) renderer->moveHair(i, hair->nodes(i));
  }
}

void App::State::uploadGroom(bool whole) {
  const groom::Groom& now = groom.groom();
  const geometry::TexelRect all{0, 0, now.map.size(), now.map.size()};
  const auto changedOf = [&](groom::MapKind map) {
    const geometry::TexelRect rect = groom.takeChanged(map);
    return whole ? all : rect;
  };
  geometry::TexelRect rect = changedOf(groom::kLengthMap);
  if (noteChange(uploaded.typed, showsTypes())) rect = all;
  if (!rect.empty()) uploadLengths(rect);
  rect = unite(changedOf(groom::kPaintMap), changedOf(groom::kMaskMap));
  const bool shows = showsMask();
  const bool scalp = showsScalp();
  if (noteChange(uploaded.overPaint, shows ? 1 : scalp ? 1 + hairView->colorRevision : 0)) rect = all;
  if (!rect.empty()) {
    // What has been painted before is taken away, too.
    const bool paints = shows || scalp || groom.hasPaint(), before = std::exchange(uploaded.painted, paints);
    if (paints || before) renderer->updatePaint(shows ? GroomStage::editorBrushes()->paintUnderMask(now) : hair->paintUnderView(now.paint), rect);
  }
  if (rect = changedOf(groom::kShapeMap); !rect.empty()) {
    const bool before = std::exchange(uploaded.shaped, groom.hasShape());
    if (uploaded.shaped || before) renderer->updateShape(now.shape, rect);
  }
}

// Only shaders of several types read it.
void App::State::uploadEvenReach() {
  constexpr groom::EvenTexel kEven{4 * groom::kMostReach, 255, 1, 0}, kUnknown{0, 0, 1, 0};
  if (groom.types() > 1) return renderer->updateEvenReach(groom::evenReach(groom.groom().map, shape.surface(), groom.groomSurface(shape).atlas));
  renderer->updateEvenReach({groom.hasLengths() ? &kUnknown : &kEven, 1});
}

void App::State::uploadLengths(const geometry::TexelRect& changed) {
  constexpr int kLeast = groom::GroomMap::kLeastSize;
  const geometry::Surface& surface = shape.surface();
  const std::vector<float>& lengths = groom.vertexLengths();
  // Of a plain map the least says it all.
  if (!groom.hasLengths()) renderer->updateGroom(groom::GroomMap(kLeast), {0, 0, kLeast, kLeast});
  else renderer->updateGroom(uploaded.typed ? groom.groom().map : groom::withCharts(groom.groom().map, surface, groom.groomSurface(shape).atlas), changed);
  uploadEvenReach();
  if (lengths.empty()) return renderer->setFurry({surface.furIndices, surface.ownFurIndices, surface.furClusters}, {});
  const auto remaining = [&](const std::vector<std::uint32_t>& all) { return groom::furryTriangles(all, lengths); };
  renderer->setFurry(geometry::remainingPatches(surface, remaining(surface.furIndices), remaining(surface.ownFurIndices)), lengths);
}

// --- frames ---

// Where a picture is drawn once further shells are worth their price if fur length times grazing share exceeds kCrowded: on a torus with fur of
// 0.3, 0.2 % of all pixels show skin in the hole of the ring instead of fur. Slender bodies, whose share is above kSlender, have slivers of sky
// between breast and foreleg: one further shell leaves little of them, in pictures of the best quality. Samples that are gathered have that
// one on every body, as the bunny has such slivers behind its head. Further shells stand only where rays may come to.
bool App::State::chooseShellCount(bool gathered, double budget) {
  constexpr float kCrowded = 0.024f, kSlender = 0.08f;
  const float length = coatLength();
  if (shells.surface != shape.surfaceRevision() || shells.length != length) {
    const float share = geometry::grazingShare(shape.surface(), shape.query(), length);
    shells = {shape.surfaceRevision(), length, length * share > kCrowded ? kCrowdedShells : share > kSlender ? kSlenderShells : 1};
    renderer->setCrowded({});
  }
  if (shells.found || (shells.count == 1 && !gathered)) return true;
  if (!shells.search) shells.search.emplace(shape.surface(), shape.query(), length);
  for (const double begun = secondsNow(); !shells.search->step();)
    if (secondsNow() - begun > budget) return false;
  renderer->setCrowded(shells.search->take());
  shells.search.reset();
  return shells.found = true;
}

render::Frame App::State::frame(int level) const {
  const QualityLevel& quality = qualityLevels()[static_cast<std::size_t>(level)];
  render::Frame f;
  f.settings = settings;
  f.coatLength = coatLength();
  f.typeHeights = groom.typeHeights();
  f.castsShadows = !coat.isCoarse() || casts;
  f.settings.fins &= quality.fins && !coat.isCoarse();
  f.settings.shadows = std::min(f.settings.shadows, quality.shadows);
  f.pixelScale = quality.pixelScale;
  f.stepLength = quality.stepLength;
  f.hairShare = quality.hairShare;
  f.shellCount = level > 0 && shells.count == kSlenderShells ? 1 : shells.count;
  f.worldFromModel = worldFromModel();
  f.camera = view.pose();
  f.width = view.width;
  f.height = view.height;
  f.transparent = transparent;
  f.bottomRow = bottomRow;
  f.rows = rows;
  f.groundHeight = shape.groundHeight();
  f.reach = glm::length(shape.extent().centre) + shape.extent().radius;
  f.wet = !water.mask().isDry();
  f.wetHair = hair->isWet();
  f.groomed = groom.hasLengths();
  f.painted = groom.hasPaint() || showsMask() || showsScalp();
  f.shaped = groom.hasShape();
  f.types = showsTypes();
  if (const auto ball = motion.touch().ball()) f.ball = Vec4(ball->centre, ball->radius);
  f.baseColorFactor = document.materials[document.main].baseColor;
  f.drops = hair->withHanging(water.water().drops());
  f.puddles = {water.puddles(), water.puddlesRevision()};
  return f;
}

// --- App's side --------------------------------------------------------------------------------

render::Frame App::frame() const { return state_->frame(); }
const furgen::Coat* App::grownCoat() const { return state_->coat.coat().grown(); }
std::span<const Vec4> App::bends() const { return state_->motion.bends(); }
render::HairGrowth App::hairGrowth(std::size_t scalp) const { return state_->hairGrowth(scalp); }
std::span<const hair::GuideNode> App::hairNodes(std::size_t scalp) const { return state_->hair->nodes(scalp); }

App::Stats App::stats() const {
  const State& s = *state_;
  Stats out{};
  out.vertices = static_cast<int>(s.shape.surface().trueVertexCount);
  out.triangles = static_cast<int>(s.shape.mesh().triangleCount());
  out.strands = s.coat.coat().strandCount();
  out.layers = s.settings.layers;
  out.finEdges = static_cast<int>(s.shape.surface().edges.size());
  out.cpuBytes = s.shape.surface().vertices.size() * (sizeof(geometry::SurfaceVertex) + 5 * sizeof(Vec4)) +
                 s.shape.surface().indices.size() * sizeof(std::uint32_t) * 4 +
                 s.shape.surface().edges.size() * sizeof(geometry::SurfaceEdge) + s.water.mask().texels().size() * sizeof(Vec4) +
                 s.groom.groom().map.texels().size() * sizeof(groom::GroomMap::Texel) * std::size(groom::kMaps) +
                 std::accumulate(s.document.pictures.begin(), s.document.pictures.end(), std::size_t{0}, [](std::size_t sum, const Document::Picture& picture) { return sum + (picture.rgba ? picture.rgba->size() : 0); });
  out.gpuBytes = s.renderer ? s.renderer->gpuBytes() : 0;
  out.uploadedBytes = s.uploadedBytes;
  out.framesDrawn = s.framesDrawn;
  out.level = s.drawnLevel;
  out.pixels = s.renderer ? s.renderer->drawnPixels() : 0;
  out.frameTime = s.governor.frameTime();
  return out;
}

}  // namespace fur::app
