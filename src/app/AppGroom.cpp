// The half of App that dresses the fur.
#include <algorithm>
#include <array>
#include <cstring>

#include "app/AppState.h"
#include "core/Fnv1a.h"
#include "groom/GroomBrush.h"
#include "groom/GroomFilters.h"
#include "groom/Selection.h"
#include "settings/Presets.h"

namespace fur::app {

namespace {

// Patches of the length noise, in model units: a few locks wide.
constexpr float kGrain = 0.09f;
// So far apart the two sides of a model may be that one mirrors, model units.
constexpr float kUneven = 0.1f;

const App::EditorGroom* editorGroom = nullptr;

// One dab of `tool`; combing goes along `way`.
void dab(Tool tool, groom::Groom& groom, const groom::GroomSurface& skin, const groom::Brush& brush,
         const settings::Settings& settings, const std::optional<Vec3>& way) {
  switch (tool) {
    case Tool::Comb:
      if (way) groom::comb(groom, skin, brush, *way);
      break;
    case Tool::Smooth: groom::smooth(groom, skin, brush); break;
    case Tool::Raise: groom::raise(groom, skin, brush); break;
    case Tool::Trim: groom::trim(groom, skin, brush); break;
    case Tool::Grow: groom::grow(groom, skin, brush); break;
    case Tool::Type: groom::paintType(groom, skin, brush, settings.groomType + 1); break;
    case Tool::Pluck: groom::pluck(groom, skin, brush); break;
    default:
      if (editorGroom) editorGroom->dab(tool, groom, skin, brush, settings);
  }
}

// Values of points as values of true vertices; none stay none.
template <class T>
std::vector<T> perVertex(const std::vector<T>& ofPoints, const groom::GroomSurface& skin) {
  std::vector<T> out;
  for (std::size_t i = 0; !ofPoints.empty() && i < skin.surface.trueVertexCount; ++i)
    out.push_back(ofPoints[skin.points.pointOf[i]]);
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

groom::GroomSurface App::State::groomSurface() {
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
  vertexLengths = groomed ? groom::vertexLengths(groom.map, surface, groomSurface().points, typeHeights) : std::vector<float>();
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
  refreshPaint();
  if (const geometry::TexelRect reshaped = groom.shape.takeChanged(); renderer && !reshaped.empty()) uploadShape(reshaped);
  if (renderer && shownWhiskers != groom.whiskers) uploadWhiskers();
  std::vector<Vec3> rests, lay;
  if (!upright()) rests = groom::restBends(groom, surface, groomSurface().points);
  for (const Vec3& rest : rests) lay.push_back(rest / groom::kMaxComb);
  water.setLay(std::move(lay));
  bends.setRest(std::move(rests), vertexLengths);
}

void App::State::uploadGroom(const geometry::TexelRect& changed) {
  constexpr int kLeast = groom::GroomMap::kLeastSize;
  if (groomed) {
    renderer->updateGroom(groom.map, changed);
    const auto remaining = [&](const std::vector<std::uint32_t>& all) { return groom::furryTriangles(all, vertexLengths); };
    renderer->setFurry(geometry::remainingPatches(surface, remaining(surface.furIndices), remaining(surface.ownFurIndices)),
                       vertexLengths);
  } else {
    // Of a plain map the least says it all.
    renderer->updateGroom(groom::GroomMap(kLeast), {0, 0, kLeast, kLeast});
    renderer->setFurry({surface.furIndices, surface.ownFurIndices, surface.furClusters}, {});
  }
}

bool App::State::showsMask() const { return editorGroom && !saved && grooms(tool) && !groom.mask.isPlain(); }

void App::State::refreshPaint() {
  const bool shows = showsMask();
  geometry::TexelRect changed = unite(groom.paint.takeChanged(), groom.mask.takeChanged());
  if (std::exchange(shownMask, shows) != shows) changed = {0, 0, groom.map.size(), groom.map.size()};
  if (changed.empty()) return;
  pictureChanged = true;
  if (renderer) uploadPaint(changed);
}

void App::State::uploadPaint(const geometry::TexelRect& changed) {
  shownMask = showsMask();
  const bool before = std::exchange(painted, shownMask || !groom.paint.isPlain());
  // What has been painted before is taken away, too.
  if (painted || before) renderer->updatePaint(shownMask ? editorGroom->paintUnderMask(groom) : groom.paint, changed);
}

void App::State::uploadShape(const geometry::TexelRect& changed) {
  const bool before = std::exchange(shaped, !groom.shape.isPlain());
  if (shaped || before) renderer->updateShape(groom.shape, changed);
}

void App::State::uploadWhiskers() {
  shownWhiskers = groom.whiskers;
  auto hairs = groom::whiskerHairs(groom.whiskers, surface, query);
  carry(hairs);
  renderer->setWhiskers(hairs);
}

void App::State::beginGroomStroke() {
  endStroke();
  groomSurface();
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
  whisker.direction = normalAt(surface, at);
  whisker.length = settings.whiskerLength;
  whisker.width = settings.whiskerWidth;
  whisker.spread = settings.whiskerSpread;
  whisker.stiffness = settings.whiskerStiffness;
  whisker.hairs = static_cast<std::uint32_t>(settings.whiskerHairs);
  whisker.seed = sprayRandom.next();
  whisker.color = settings.whiskerColor;
}

void App::State::aimWhisker(Vec2 pixel) {
  if (!groomBefore || groom.whiskers.size() <= groomBefore->whiskers.size()) return;
  groom::Whisker* whisker = &groom.whiskers[groomBefore->whiskers.size()];
  const ModelRay ray = rayThrough(pixel);
  const Vec3 way = ray.origin - whisker->root;
  // Where the ray passes the root, as far from the eye.
  Vec3 pull = way - ray.direction * glm::dot(way, ray.direction);
  for (; whisker != groom.whiskers.data() + groom.whiskers.size(); ++whisker) {
    const auto at = groom::rootOf(*whisker, query);
    if (at) whisker->direction = groom::pulledDirection(normalAt(surface, *at), whisker->length, pull);
    pull = mirroredWay(pull);
  }
  groomTouched();
}

std::optional<geometry::SurfacePoint> App::State::mirrored(const geometry::SurfacePoint& at) const {
  if (settings.mirror == 0) return std::nullopt;
  const Vec3 place = positionAt(surface, at), there = mirroredWay(place);
  // In the middle it is the same place.
  if (glm::distance(place, there) < 0.2f * settings.brushRadius) return std::nullopt;
  return nearestPoint(surface, query, there, settings.brushRadius + kUneven, mirroredWay(normalAt(surface, at)));
}

Vec3 App::State::mirroredWay(Vec3 way) const {
  if (settings.mirror > 0) way[settings.mirror - 1] *= -1;
  return way;
}

void App::State::groomAt(const geometry::SurfacePoint& at) {
  const auto other = mirrored(at);
  if (tool == Tool::Whisker) {
    plantWhisker(at);
    if (other) plantWhisker(*other);
    return groomTouched();
  }
  const Vec3 centre = positionAt(surface, at);
  const std::optional<Vec3> way = lastDab ? std::optional(centre - *lastDab) : std::nullopt;
  groom::Brush brush{centre, normalAt(surface, at), settings.brushRadius, settings.groomStrength, static_cast<groom::Falloff>(settings.brushFalloff)};
  dab(tool, groom, groomSurface(), brush, settings, way);
  if (other) {
    brush.centre = positionAt(surface, *other);
    brush.normal = normalAt(surface, *other);
    dab(tool, groom, groomSurface(), brush, settings, way ? std::optional(mirroredWay(*way)) : std::nullopt);
  }
  lastDab = centre;
  groomTouched();
}

std::optional<geometry::SurfacePoint> App::State::nearest(const Vec3& place) const {
  // Either side will do: the point is on the surface, or nearly.
  for (const float radius : {0.01f, 0.1f, 4.0f})
    for (const Vec3& side : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
      if (const auto at = nearestPoint(surface, query, place, radius, side)) return at;
  return std::nullopt;
}

void App::State::applyGroomStep(const GroomStep& step, bool undo) {
  groomSurface();
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
  if (!fur.map.empty()) groom::resize(groom, fur.mapSize);
  const std::vector<groom::GroomMap::Texel>* maps[] = {&fur.map, &fur.paint, &fur.mask, &fur.shape};
  for (std::size_t i = 0; i < std::size(maps); ++i)
    if (!maps[i]->empty()) (groom.*groom::kMaps[i]).restore(*maps[i]);
  const groom::GroomSurface at = groomSurface();
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
  const groom::GroomSurface skin = s.groomSurface();
  switch (edit) {
    case GroomEdit::Clear: return clearGroom();
    case GroomEdit::Length: groom::setLength(s.groom.map, value); break;
    case GroomEdit::Invert: groom::invertLength(s.groom.map); break;
    case GroomEdit::Vary:
      groom::varyLength(s.groom, skin, value, kGrain, static_cast<std::uint32_t>(s.settings.seed));
      break;
    case GroomEdit::Type: groom::setType(s.groom.map, static_cast<int>(glm::clamp(value, 1.0f, 4.0f))); break;
    case GroomEdit::Comb: groom::combAlong(s.groom, skin.points, direction, value); break;
    case GroomEdit::Raise: groom::raiseAll(s.groom); break;
    case GroomEdit::Size: groom::resize(s.groom, static_cast<int>(glm::clamp(value, 0.0f, 1e4f))); break;
    case GroomEdit::Paint: groom::paintAll(s.groom, static_cast<std::uint32_t>(glm::clamp(value, 0.0f, 16777215.0f))); break;
    case GroomEdit::ClearPaint: s.groom.paint = groom::GroomMap(s.groom.map.size(), groom::GroomMap::kBlank); break;
    case GroomEdit::ClearMask: s.groom.mask = groom::GroomMap(s.groom.map.size(), groom::GroomMap::kBlank); break;
    case GroomEdit::InvertMask: groom::invertMask(s.groom.mask); break;
    case GroomEdit::SelectConnected:
      if (const auto at = s.nearest(direction)) groom::selectConnected(s.groom, skin, at->triangle);
      if (s.groom.mask.isPlain()) s.warnings.push_back("the whole model hangs together: all of it is selected, nothing is masked");
      break;
    case GroomEdit::SelectType: groom::selectType(s.groom, skin, static_cast<int>(glm::clamp(value, 1.0f, 4.0f))); break;
    case GroomEdit::SelectLength: groom::selectLength(s.groom, skin, direction.x, direction.y); break;
    case GroomEdit::SelectPaint:
      if (const auto at = s.nearest(direction)) groom::selectPaint(s.groom, skin, atlasAt(s.surface, *at), value);
      break;
    case GroomEdit::GrowMask: groom::growMask(s.groom, skin, value); break;
    case GroomEdit::ShrinkMask: groom::shrinkMask(s.groom, skin, value); break;
    case GroomEdit::SmoothMask: groom::smoothMask(s.groom, skin, value); break;
    case GroomEdit::ClearShape: s.groom.shape = groom::GroomMap(s.groom.map.size(), groom::GroomMap::kBlank); break;
  }
  if (keepsMasked(edit)) groom::keepProtected(s.groom, *s.groomBefore, skin);
  s.groomTouched();
  s.endGroomStroke();
}

void App::clearGroom() {
  State& s = *state_;
  s.beginGroomStroke();
  s.groom = groom::plainGroom(s.groom.map.size(), s.groomSurface().points);
  s.groomTouched();
  s.endGroomStroke();
}

void App::groomFromImage(groom::ImageOf what, int width, int height, std::span<const std::uint8_t> rgba) {
  State& s = *state_;
  s.beginGroomStroke();
  groom::paintFromImage(what, s.groom, s.groomSurface(), width, height, rgba);
  groom::keepProtected(s.groom, *s.groomBefore, s.groomSurface());
  s.groomTouched();
  s.endGroomStroke();
}

groom::Coverage App::groomCoverage() const {
  // A plain one needs no atlas.
  State& s = *state_;
  return s.groom.map.isPlain() ? groom::Coverage{} : groom::coverage(s.groom.map, s.groomSurface().atlas);
}

std::uint64_t App::groomRevision() const { return state_->groomRevision; }
bool App::groomed() const { return !state_->groom.isPlain(); }
std::size_t App::whiskerCount() const { return state_->groom.whiskers.size(); }
const groom::GroomMap& App::groomMap() const { return state_->groom.map; }
const groom::Groom& App::groom() const { return state_->groom; }
void App::groomWith(const EditorGroom* given) { editorGroom = given; }

std::uint64_t App::groomHash() const {
  state_->groomSurface();
  Fnv1a hash;
  for (const auto map : groom::kMaps) hash.add((state_->groom.*map).hash());
  for (const Vec3& comb : state_->groom.comb) hash.add(comb + 0.0f);  // -0 is 0
  for (const groom::Whisker& whisker : state_->groom.whiskers) hash.addAll(wordsOf(whisker));
  return hash.value();
}

}  // namespace fur::app
