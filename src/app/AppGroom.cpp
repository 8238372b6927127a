// The half of App that dresses the fur.
#include <algorithm>
#include <array>
#include <cstring>

#include "app/AppState.h"
#include "groom/GroomBrush.h"
#include "groom/GroomFilters.h"
#include "scene/FoModel.h"
#include "settings/Presets.h"

namespace fur::app {

namespace {

// Patches of the length noise, in model units: a few locks wide.
constexpr float kGrain = 0.09f;

// One dab of `tool`; combing goes along `way`.
void dab(Tool tool, groom::Groom& groom, const groom::Ground& ground, const groom::Brush& brush, int type,
         const std::optional<Vec3>& way) {
  switch (tool) {
    case Tool::Comb:
      if (way) groom::comb(groom, ground, brush, *way);
      break;
    case Tool::Smooth: groom::smooth(groom, ground, brush); break;
    case Tool::Raise: groom::raise(groom, ground, brush); break;
    case Tool::Trim: groom::trim(groom, ground, brush); break;
    case Tool::Grow: groom::grow(groom, ground, brush); break;
    case Tool::Type: groom::paintType(groom, ground, brush, type); break;
    case Tool::Pluck: groom::pluck(groom, brush); break;
    default: break;
  }
}

// Values of points as values of true vertices; none stay none.
template <class T>
std::vector<T> perVertex(const std::vector<T>& ofPoints, const groom::Ground& ground) {
  std::vector<T> out;
  for (std::size_t i = 0; !ofPoints.empty() && i < ground.surface.trueVertexCount; ++i)
    out.push_back(ofPoints[ground.points.pointOf[i]]);
  return out;
}

// Those of some vertices; none stay none.
template <class T>
std::vector<T> ofVertices(const std::vector<T>& values, const std::vector<std::uint32_t>& vertices) {
  std::vector<T> out;
  for (std::size_t i = 0; !values.empty() && i < vertices.size(); ++i) out.push_back(values[vertices[i]]);
  return out;
}

groom::TypeHeights heightsOf(const settings::Settings& settings) {
  groom::TypeHeights heights;
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = settings::typeHeight(settings, static_cast<int>(i));
  return heights;
}

std::array<std::uint32_t, groom::kWhiskerBytes / 4> wordsOf(const groom::Whisker& whisker) {
  std::array<std::uint32_t, groom::kWhiskerBytes / 4> words;
  std::memcpy(words.data(), &whisker, sizeof whisker);
  return words;
}

}  // namespace

groom::Ground App::State::ground() {
  if (!points) points.emplace(surface);
  if (!groomAtlas || groomAtlas->size() != groom.map.size()) groomAtlas.emplace(surface, groom.map.size());
  if (groom.comb.empty()) groom.comb.assign(points->count(), Vec3(0));
  return {surface, query, *groomAtlas, *points};
}

void App::State::newGroom() {
  groom = {groom::GroomMap(), {}, {}};
  groomBefore.reset();
  lastDab.reset();
  ++groomRevision;
}

void App::State::groomTouched() {
  ++groomRevision;
  groomStale = forcesChanged = pictureChanged = true;
}

void App::State::readGroomMap() {
  (void)groom.map.takeChanged();
  groomed = !groom.map.isPlain();
  if (const unsigned types = groomed ? groom::typesPresent(groom.map) : 1u; types != std::exchange(furTypes, types)) furChanged = true;
  vertexLengths = groomed ? groom::vertexLengths(groom.map, surface, ground().points, typeHeights) : std::vector<float>();
}

bool App::State::upright() const {
  return std::all_of(groom.comb.begin(), groom.comb.end(), [](const Vec3& comb) { return comb == Vec3(0); });
}

void App::State::refreshGroom() {
  if (!std::exchange(groomStale, false)) return;
  const geometry::TexelRect changed = groom.map.takeChanged();
  if (const groom::TypeHeights heights = heightsOf(settings); std::exchange(typeHeights, heights) != heights || !changed.empty()) {
    readGroomMap();
    if (renderer) uploadGroom(changed);
  }
  if (renderer && shownWhiskers != groom.whiskers) uploadWhiskers();
  std::vector<Vec3> rests, lay;
  if (!upright()) rests = groom::restBends(groom, surface, ground().points);
  for (const Vec3& rest : rests) lay.push_back(rest / groom::kMaxComb);
  water.setLay(std::move(lay));
  bends.setRest(std::move(rests), vertexLengths);
}

void App::State::uploadGroom(const geometry::TexelRect& changed) {
  constexpr int kLeast = groom::GroomMap::kLeastSize;
  if (groomed) {
    renderer->updateGroom(groom.map, changed);
    const auto remaining = [&](const std::vector<std::uint32_t>& all) { return groom::furryTriangles(groom.map, surface, all, typeHeights); };
    renderer->setFurry(geometry::remainingPatches(surface, remaining(surface.furIndices), remaining(surface.ownFurIndices)),
                       vertexLengths);
  } else {
    // Of a plain map the least says it all.
    renderer->updateGroom(groom::GroomMap(kLeast), {0, 0, kLeast, kLeast});
    renderer->setFurry({surface.furIndices, surface.ownFurIndices, surface.furClusters}, {});
  }
}

void App::State::uploadWhiskers() {
  shownWhiskers = groom.whiskers;
  auto hairs = groom::whiskerHairs(groom.whiskers, surface, query);
  carry(hairs);
  renderer->setWhiskers(hairs);
}

void App::State::beginGroomStroke() {
  endStroke();
  ground();
  groomBefore = groom;
  lastDab.reset();
}

void App::State::endGroomStroke() {
  const auto before = std::exchange(groomBefore, std::nullopt);
  if (!before) return;
  if (auto step = groomStep(*before, groom)) history.push(std::move(*step));
}

void App::State::plantWhisker(const geometry::SurfacePoint& at) {
  if (groom.whiskers.size() >= groom::kMostWhiskers) {
    warnings.push_back("512 whiskers stand, which is the limit");
    return;
  }
  groom.whiskers.resize(groom.whiskers.size() + 1);
  groom::Whisker& whisker = groom.whiskers.back();
  whisker.root = positionAt(surface, at);
  whisker.direction = whiskerNormal = normalAt(surface, at);
  whisker.length = settings.whiskerLength;
  whisker.width = settings.whiskerWidth;
  whisker.spread = settings.whiskerSpread;
  whisker.stiffness = settings.whiskerStiffness;
  whisker.hairs = static_cast<std::uint32_t>(settings.whiskerHairs);
  whisker.seed = sprayRandom.next();
  whisker.color = settings.whiskerColor;
  groomTouched();
}

void App::State::aimWhisker(Vec2 pixel) {
  if (!groomBefore || groom.whiskers.size() <= groomBefore->whiskers.size()) return;
  groom::Whisker& whisker = groom.whiskers.back();
  const ModelRay ray = rayThrough(pixel);
  const Vec3 way = ray.origin - whisker.root;
  // Where the ray passes the root, as far from the eye.
  whisker.direction = groom::pulledDirection(whiskerNormal, whisker.length, way - ray.direction * glm::dot(way, ray.direction));
  groomTouched();
}

void App::State::groomAt(const geometry::SurfacePoint& at) {
  if (tool == Tool::Whisker) return plantWhisker(at);
  const Vec3 centre = positionAt(surface, at);
  dab(tool, groom, ground(), {centre, normalAt(surface, at), settings.brushRadius, settings.groomStrength},
      settings.groomType + 1, lastDab ? std::optional(centre - *lastDab) : std::nullopt);
  lastDab = centre;
  groomTouched();
}

void App::State::applyGroomStep(const GroomStep& step, bool undo) {
  ground();
  apply(step, undo, groom);
  groomTouched();
}

// What a file says of the vertices of `mesh`, brought to the points of the surface.
void App::State::takeFur(const scene::FurData& fur) {
  if (!fur.wetness.empty()) {
    std::vector<Vec4> texels;
    const int size = mask.size();
    for (int i = 0; i < size * size; ++i) {
      const int x = i % size * fur.wetnessSize / size, y = i / size * fur.wetnessSize / size;
      texels.push_back(fur.wetness[static_cast<std::size_t>(y) * static_cast<std::size_t>(fur.wetnessSize) + static_cast<std::size_t>(x)]);
    }
    mask.restore(std::move(texels));
    maskTouched();
  }
  if (fur.map.empty() && fur.comb.empty() && fur.lengths.empty() && fur.types.empty() && fur.whiskers.empty())
    return;
  if (!fur.map.empty()) {
    groom.map = groom::GroomMap(fur.mapSize);
    groom.map.restore(fur.map);
  }
  const groom::Ground at = ground();
  // Vertices that were inserted have what lies between their ends.
  std::vector<Vec3> places = mesh.positions, combs = fur.comb;
  std::vector<float> meshLengths = fur.lengths;
  std::vector<int> meshTypes = fur.types;
  for (const geometry::InsertedVertex& vertex : surface.inserted) {
    places.push_back(vertex.of(places));
    if (!combs.empty()) combs.push_back(vertex.of(combs));
    if (!meshLengths.empty()) meshLengths.push_back(vertex.of(meshLengths));
    if (!meshTypes.empty()) meshTypes.push_back(meshTypes[vertex.t < 0.5f ? vertex.a : vertex.b]);
  }
  const std::vector<std::uint32_t> pointOfMesh = at.points.at(places);
  std::vector<float> lengths(fur.lengths.empty() ? 0 : at.points.count());
  std::vector<int> types(fur.types.empty() ? 0 : at.points.count());
  for (std::size_t i = 0; i < pointOfMesh.size(); ++i) {
    const std::uint32_t point = pointOfMesh[i];
    if (point == groom::SurfacePoints::kNoPoint) continue;
    if (!combs.empty()) groom.comb[point] = combs[i];
    if (!lengths.empty()) lengths[point] = meshLengths[i];
    if (!types.empty()) types[point] = meshTypes[i];
  }
  groom.comb = groom::soundComb(std::move(groom.comb), at.points);
  groom::paintFromVertices(groom, at, perVertex(lengths, at), perVertex(types, at));
  groom.whiskers = fur.whiskers;
  groom::keepSound(groom.whiskers, query);
  if (groom.whiskers.size() < fur.whiskers.size()) warnings.push_back("whiskers off the surface are left out");
  groomTouched();
}

// --- App's side --------------------------------------------------------------------------------

void App::groomAll(GroomEdit edit, float value, const Vec3& direction) {
  State& s = *state_;
  if (!std::isfinite(value) || !std::isfinite(direction.x + direction.y + direction.z)) return;
  s.beginGroomStroke();
  const groom::Ground ground = s.ground();
  switch (edit) {
    case GroomEdit::Clear: return clearGroom();
    case GroomEdit::Length: groom::setLength(s.groom.map, value); break;
    case GroomEdit::Invert: groom::invertLength(s.groom.map); break;
    case GroomEdit::Vary:
      groom::varyLength(s.groom, ground, value, kGrain, static_cast<std::uint32_t>(s.settings.seed));
      break;
    case GroomEdit::Type: groom::setType(s.groom.map, static_cast<int>(glm::clamp(value, 1.0f, 4.0f))); break;
    case GroomEdit::Comb: groom::combAlong(s.groom, ground.points, direction, value); break;
    case GroomEdit::Raise: groom::raiseAll(s.groom); break;
    case GroomEdit::Size: s.groom.map = groom::resized(s.groom.map, static_cast<int>(glm::clamp(value, 0.0f, 1e4f))); break;
  }
  s.groomTouched();
  s.endGroomStroke();
}

void App::clearGroom() {
  State& s = *state_;
  s.beginGroomStroke();
  s.groom = groom::plainGroom(s.groom.map.size(), s.ground().points);
  s.groomTouched();
  s.endGroomStroke();
}

void App::groomFromImage(groom::ImageOf what, int width, int height, std::span<const std::uint8_t> rgba) {
  State& s = *state_;
  s.beginGroomStroke();
  groom::paintFromImage(what, s.groom, s.ground(), width, height, rgba);
  s.groomTouched();
  s.endGroomStroke();
}

groom::Coverage App::groomCoverage() const {
  // A plain one needs no atlas.
  State& s = *state_;
  return s.groom.map.isPlain() ? groom::Coverage{} : groom::coverage(s.groom.map, s.ground().atlas);
}

std::uint64_t App::groomRevision() const { return state_->groomRevision; }
bool App::groomed() const { return !state_->groom.isPlain(); }
std::size_t App::whiskerCount() const { return state_->groom.whiskers.size(); }
const groom::GroomMap& App::groomMap() const { return state_->groom.map; }

std::uint64_t App::groomHash() const {
  state_->ground();
  std::uint64_t hash = state_->groom.map.hash();
  const auto add = [&hash](std::uint32_t bits) { hash = (hash ^ bits) * 1099511628211ull; };
  for (const Vec3& comb : state_->groom.comb)
    for (int k = 0; k < 3; ++k) {
      const float number = comb[k] + 0.0f;  // -0 is 0
      std::uint32_t bits;
      std::memcpy(&bits, &number, sizeof bits);
      add(bits);
    }
  for (const groom::Whisker& whisker : state_->groom.whiskers)
    for (const std::uint32_t word : wordsOf(whisker)) add(word);
  return hash;
}

std::vector<std::uint8_t> App::saveFo() const {
  State& s = *state_;
  std::vector<int> types;
  std::vector<float> lengths;
  if (s.groomed) lengths = groom::vertexLengths(s.groom.map, s.surface, s.ground().points);
  if (s.groomed)
    for (const auto& vertex : s.surface.vertices) types.push_back(s.groom.map.typeAt(vertex.atlas) - 1);
  if (!s.surface.turned) return scene::writeFo(scene::foFromSurface(s.surface, s.settings.repeat, lengths, types));
  const geometry::OwnSurface own = geometry::ownSurface(s.surface, s.mesh);
  return scene::writeFo(scene::foFromSurface(own.surface, s.settings.repeat, ofVertices(lengths, own.vertexOf), ofVertices(types, own.vertexOf)));
}

Warnings App::lostBySaving() const {
  const State& s = *state_;
  Warnings lost = s.lostOfFile;
  if (s.given) lost.push_back("the coat that was read from a .fts file");
  return lost;
}

std::vector<std::uint8_t> App::saveScene() const {
  State& s = *state_;
  s.refreshGroom();
  const geometry::OwnSurface own = geometry::ownSurface(s.surface, s.mesh);
  geometry::Mesh mesh;
  mesh.indices = own.surface.indices;
  for (const geometry::SurfaceVertex& v : own.surface.vertices) {
    mesh.positions.push_back(v.position);
    mesh.normals.push_back(v.normal);
    if (!s.mesh.uv.empty()) mesh.uv.push_back(v.uv);
    mesh.atlas.push_back(v.atlas);
    if (!s.mesh.furUv.empty()) mesh.furUv.push_back(v.fur);
  }
  scene::FurData fur;
  fur.state = state();
  fur.mapSize = s.groom.map.size();
  if (!s.groom.map.isPlain()) fur.map = s.groom.map.texels();
  if (!s.upright()) {
    fur.comb = ofVertices(groom::restBends(s.groom, s.surface, s.ground().points), own.vertexOf);
  }
  fur.whiskers = s.groom.whiskers;
  fur.wetnessSize = s.mask.size();
  if (!s.mask.isDry()) fur.wetness = s.mask.texels();
  return scene::exportScene(mesh, s.modelName, fur, {s.sourceImage.bytes.empty() ? s.pendingImage : s.sourceImage, s.baseColorFactor});
}

// The layout, the map's size and the number of whiskers, texels, comb, whiskers.
std::vector<std::uint8_t> App::saveGroom() const {
  State& s = *state_;
  s.ground();
  const std::uint32_t counts[3] = {kSavedLayout, static_cast<std::uint32_t>(s.groom.map.size()), static_cast<std::uint32_t>(s.groom.whiskers.size())};
  std::vector<std::uint8_t> bytes;
  const auto append = [&](const void* from, std::size_t count) {
    const auto* first = static_cast<const std::uint8_t*>(from);
    bytes.insert(bytes.end(), first, first + count);
  };
  append(counts, sizeof counts);
  append(s.groom.map.texels().data(), s.groom.map.texels().size() * sizeof(groom::GroomMap::Texel));
  append(s.groom.comb.data(), s.groom.comb.size() * sizeof(Vec3));
  append(s.groom.whiskers.data(), s.groom.whiskers.size() * groom::kWhiskerBytes);
  return bytes;
}

Status App::restoreGroom(std::span<const std::uint8_t> bytes, bool undoable) {
  State& s = *state_;
  const groom::Ground ground = s.ground();
  std::uint32_t counts[3] = {};
  if (bytes.size() >= sizeof counts) std::memcpy(counts, bytes.data(), sizeof counts);
  const std::uint32_t size = counts[1];
  const std::size_t texels = std::size_t{size} * size;
  const std::size_t mapAt = sizeof counts, combAt = mapAt + texels * sizeof(groom::GroomMap::Texel);
  const std::size_t whiskersAt = combAt + ground.points.count() * sizeof(Vec3);
  const bool sound = counts[0] == kSavedLayout && size >= groom::GroomMap::kLeastSize && size <= groom::GroomMap::kMostSize &&
                     counts[2] <= groom::kMostWhiskers && bytes.size() == whiskersAt + counts[2] * groom::kWhiskerBytes;
  if (!sound) return Error{ErrorId::BadFile, "a groom of " + std::to_string(bytes.size()) + " bytes is not of this model"};
  if (undoable) s.beginGroomStroke();
  std::vector<groom::GroomMap::Texel> map(texels);
  std::memcpy(map.data(), &bytes[mapAt], combAt - mapAt);
  s.groom.map = groom::GroomMap(static_cast<int>(size));
  s.groom.map.restore(std::move(map));
  std::memcpy(s.groom.comb.data(), &bytes[combAt], whiskersAt - combAt);
  s.groom.whiskers = groom::readWhiskers(bytes.subspan(whiskersAt));
  groom::keepSound(s.groom.whiskers, s.query);
  s.groomTouched();
  s.endGroomStroke();
  return Done{};
}

}  // namespace fur::app
