#include "app/stages/GroomStage.h"

#include <algorithm>
#include <cstring>

#include "app/stages/Brushes.h"
#include "app/stages/Mirror.h"
#include "core/NoteChange.h"
#include "groom/FromPicture.h"
#include "groom/GroomFilters.h"
#include "groom/MapPictures.h"
#include "groom/Patterns.h"
#include "groom/Selection.h"
#include "settings/FurTypes.h"
#include "settings/Presets.h"

namespace fur::app {

namespace {

// Patches of the length noise, in model units: a few locks wide.
constexpr float kGrain = 0.09f;

const GroomStage::EditorBrushes* brushesOfEditor = nullptr;

// One dab of `tool`; combing goes along `way`.
void brush(Tool tool, groom::Groom& groom, const groom::GroomSurface& skin, const groom::Brush& brush,
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
      if (brushesOfEditor) brushesOfEditor->dab(tool, groom, skin, brush, settings);
  }
}

groom::TypeHeights heightsOf(const GroomStage::Inputs& inputs) {
  const float length = settings::coatLength(inputs.settings, inputs.grownTypes);
  groom::TypeHeights heights;
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = settings::typeHeight(inputs.settings, static_cast<int>(i), length);
  return heights;
}

// Strands lean towards normal + this (Bilbao 2019, 3.1).
Vec3 combOfAll(const settings::Settings& settings) { return settings.combStrength * Vec3(settings.combX, settings.combY, settings.combZ); }

// The bend of such a strand: an arc whose ends lie in that direction, twice the angle between that and the normal.
Vec3 leanedTo(const Vec3& vector, const Vec3& normal) {
  const float along = glm::dot(vector, normal);
  const Vec3 across = vector - normal * along;
  const float tangent = glm::length(across) / std::max(1 + along, 0.1f);
  // The arctangent, off by 0.005 rad at most as far as it is used.
  const float angle = 2 * tangent / (1 + 0.28f * tangent * tangent);
  return normalizeOr(across, Vec3(0)) * (tangent < 1 ? std::min(angle, groom::kMaxComb) : groom::kMaxComb);
}

geometry::TexelRect whole(const groom::GroomMap& map) { return {0, 0, map.size(), map.size()}; }

}  // namespace

void GroomStage::setEditorBrushes(const EditorBrushes* brushes) { brushesOfEditor = brushes; }
const GroomStage::EditorBrushes* GroomStage::editorBrushes() { return brushesOfEditor; }

void GroomStage::reset(std::vector<std::uint8_t> bare) {
  bareAtFirst_ = bare;
  groom_ = {groom::GroomMap(), {}, {}, std::move(bare)};
  isLying_ = true;
  lie_.clear();
  lieFor_ = {};
  before_.reset();
  lastDab_.reset();
  touch();
}

void GroomStage::needComb(const ShapeStage& shape) {
  if (groom_.comb.empty()) groom_.comb.assign(shape.points().count(), Vec3(0));
}

groom::GroomSurface GroomStage::groomSurface(const ShapeStage& shape) {
  if (noteChange(atlasFor_, shape.surfaceRevision())) atlas_.reset();
  if (!atlas_ || atlas_->size() != groom_.map.size()) atlas_.emplace(shape.surface(), groom_.map.size());
  needComb(shape);
  return {shape.surface(), shape.query(), *atlas_, shape.points(), lie_};
}

bool GroomStage::upright() const {
  return std::all_of(groom_.comb.begin(), groom_.comb.end(), [](const Vec3& comb) { return comb == Vec3(0); });
}

// --- of the vertices ---

bool GroomStage::active(const Inputs& inputs) const {
  return updatedFor_ != revision_ || surfaceFor_ != inputs.shape.surfaceRevision() || (types_ > 1 && heightsOf(inputs) != heights_) ||
         combOfAll(inputs.settings) != combOfAll_ || lieFor(inputs.settings) != lieFor_;
}

bool GroomStage::update(const Inputs& inputs) {
  if (!active(inputs)) return false;
  const bool otherSurface = noteChange(surfaceFor_, inputs.shape.surfaceRevision());
  const bool otherHeights = noteChange(heights_, heightsOf(inputs)), otherBare = noteChange(bareFor_, groom_.bare);
  updatedFor_ = revision_;
  ++verticesRevision_;
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    groom::GroomMap& map = groom_.*groom::kMaps[i];
    const geometry::TexelRect now = map.takeChanged();
    if (!otherSurface && !(i == 0 && (otherHeights || otherBare)) && now.empty()) continue;
    changed_[i] = otherSurface || (i == 0 && otherBare) ? whole(map) : unite(changed_[i], now);
    plain_[i] = map.isPlain();
    if (i == 0) readLengths(inputs.shape);
  }
  combOfAll_ = combOfAll(inputs.settings);
  followLie(inputs.shape, inputs.settings);
  readRests(inputs.shape);
  return true;
}

void GroomStage::readLengths(const ShapeStage& shape) {
  types_ = hasLengths() ? groom::typesPresent(groom_.map) : 1u;
  vertexLengths_.clear();
  if (hasLengths()) vertexLengths_ = groom::vertexLengths(groom_.map, shape.surface(), shape.points(), heights_);
  if (std::find(groom_.bare.begin(), groom_.bare.end(), 1) != groom_.bare.end()) groom::keepBare(vertexLengths_, shape.points(), shape.materialOf(), groom_.bare);
  vertexTypes_.clear();
  if (types_ == 1) return;
  for (const geometry::SurfaceVertex& vertex : shape.surface().vertices)
    vertexTypes_.push_back(static_cast<std::uint8_t>(groom_.map.typeAt(vertex.atlas) - 1));
}

// What is combed by the vector of the settings lies less by itself.
float GroomStage::lieFor(const settings::Settings& settings) const { return isLying_ ? settings.lie * (1 - settings.combStrength) : 0; }

void GroomStage::followLie(const ShapeStage& shape, const settings::Settings& settings) {
  const bool otherSurface = noteChange(lieSurfaceFor_, shape.surfaceRevision());
  if (!noteChange(lieFor_, lieFor(settings)) && !otherSurface) return;
  lie_.clear();
  if (lieFor_ <= 0) return;
  lie_ = shape.naturalLie();
  for (Vec3& way : lie_) way *= lieFor_ * groom::kMaxComb;
}

void GroomStage::readRests(const ShapeStage& shape) {
  rests_.clear();
  if (!lie_.empty()) needComb(shape);
  if (!lie_.empty() || !upright()) rests_ = groom::restBends(groom_, shape.surface(), shape.points(), lie_);
  if (combOfAll_ == Vec3(0)) return;
  rests_.resize(shape.surface().vertices.size(), Vec3(0));
  for (std::size_t i = 0; i < rests_.size(); ++i) {
    const Vec3 bend = rests_[i] + leanedTo(combOfAll_, shape.points().normals[shape.points().pointOf[i]]);
    const float angle = glm::length(bend);
    const Vec3 limited = angle > groom::kMaxComb ? bend * (groom::kMaxComb / angle) : bend;
    const Vec3& normal = shape.surface().vertices[i].normal;
    rests_[i] = limited - normal * glm::dot(limited, normal);
  }
}

geometry::TexelRect GroomStage::takeChanged(groom::MapKind map) { return std::exchange(changed_[map], {}); }

// Hairs stand on the surface as it was made; they go along with their triangles.
std::vector<groom::WhiskerHair> GroomStage::hairsOf(const ShapeStage& shape, std::span<const groom::Whisker> whiskers) const {
  return posed(shape, groom::whiskerHairs(whiskers, shape.surface(), shape.query()));
}

// Where they are rooted takes longer than where that is now.
std::vector<groom::WhiskerHair> GroomStage::hairs(const ShapeStage& shape) const {
  if (noteChange(hairsFor_, shape.surfaceRevision()) || hairsOf_ != groom_.whiskers) {
    hairsOf_ = groom_.whiskers;
    hairs_ = groom::whiskerHairs(hairsOf_, shape.surface(), shape.query());
  }
  return posed(shape, hairs_);
}

std::vector<groom::WhiskerHair> GroomStage::posed(const ShapeStage& shape, std::vector<groom::WhiskerHair> hairs) {
  const ShapeStage::Skin* skin = shape.skin();
  if (!skin) return hairs;
  for (groom::WhiskerHair& hair : hairs) {
    const auto corner = [&](int k) { return static_cast<std::size_t>(hair.vertices[k]); };
    const std::size_t v = corner(0);
    const auto frame = [](const Vec3& n, const Vec3& t) { return Mat3(n, t, glm::cross(n, t)); };
    const Mat3 turn = frame(skin->normals[v], skin->tangents[v]) *
                      glm::transpose(frame(shape.surface().vertices[v].normal, shape.firstTangents()[v]));
    hair.root = Vec3(0);
    for (int k = 0; k < 3; ++k) hair.root += skin->positions[corner(k)] * hair.weights[k];
    hair.direction = turn * hair.direction;
    hair.curve = turn * hair.curve;
    hair.normal = turn * hair.normal;
  }
  return hairs;
}

// --- strokes ---

void GroomStage::beginStroke(const ShapeStage& shape) {
  groomSurface(shape);
  before_ = groom_;
  lastDab_.reset();
}

std::optional<GroomStep> GroomStage::endStroke() {
  const auto before = std::exchange(before_, std::nullopt);
  return before ? groomStep(*before, groom_) : std::nullopt;
}

void GroomStage::dab(const ShapeStage& shape, const settings::Settings& settings, Tool tool, const geometry::SurfacePoint& at, Warnings& warnings) {
  const std::size_t material = shape.materialAt(at.triangle);
  if (tool == Tool::Furry) return turnOver(material, warnings);
  // Nothing to groom, but whiskers may stand there.
  if (isBare(material) && tool != Tool::Whisker && tool != Tool::Pluck) return;
  const auto other = mirrored(settings, shape, at);
  touch();
  if (tool == Tool::Whisker) {
    plant(shape, settings, at, warnings);
    if (other) plant(shape, settings, *other, warnings);
    return;
  }
  const geometry::Surface& surface = shape.surface();
  const Vec3 centre = positionAt(surface, at);
  const std::optional<Vec3> way = lastDab_ ? std::optional(centre - *lastDab_) : std::nullopt;
  groom::Brush size = brushAt(settings, centre, normalAt(surface, at));
  brush(tool, groom_, groomSurface(shape), size, settings, way);
  if (other) {
    size.centre = positionAt(surface, *other);
    size.normal = normalAt(surface, *other);
    brush(tool, groom_, groomSurface(shape), size, settings, way ? std::optional(mirrored(settings, *way)) : std::nullopt);
  }
  lastDab_ = centre;
}

// Once a stroke.
void GroomStage::turnOver(std::size_t material, Warnings& warnings) {
  if (groom_.bare.empty()) warnings.push_back("the model has one material: fur grows on all of it");
  else if (before_ && before_->bare == groom_.bare) setBare(material, !isBare(material));
}

void GroomStage::plant(const ShapeStage& shape, const settings::Settings& settings, const geometry::SurfacePoint& at, Warnings& warnings) {
  if (groom_.whiskers.size() >= groom::kMostWhiskers) {
    warnings.push_back("512 whiskers stand, which is the limit");
    return;
  }
  groom_.whiskers.resize(groom_.whiskers.size() + 1);
  groom::Whisker& whisker = groom_.whiskers.back();
  whisker.root = positionAt(shape.surface(), at);
  whisker.direction = normalAt(shape.surface(), at);
  whisker.length = settings.whiskerLength;
  whisker.width = settings.whiskerWidth;
  whisker.spread = settings.whiskerSpread;
  whisker.stiffness = settings.whiskerStiffness;
  whisker.hairs = static_cast<std::uint32_t>(settings.whiskerHairs);
  whisker.seed = random_.next();
  whisker.color = settings.whiskerColor;
}

Vec3 GroomStage::pullAt(const Vec3& root, const Vec3& origin, const Vec3& direction) {
  const Vec3 way = origin - root;
  return way - direction * glm::dot(way, direction);
}

void GroomStage::aimWhiskers(const ShapeStage& shape, const settings::Settings& settings, const Vec3& origin, const Vec3& direction) {
  if (!before_ || groom_.whiskers.size() <= before_->whiskers.size()) return;
  groom::Whisker* whisker = &groom_.whiskers[before_->whiskers.size()];
  Vec3 pull = pullAt(whisker->root, origin, direction);
  for (; whisker != groom_.whiskers.data() + groom_.whiskers.size(); ++whisker) {
    const auto at = groom::rootOf(*whisker, shape.query());
    if (at) whisker->direction = groom::pulledDirection(normalAt(shape.surface(), *at), whisker->length, pull);
    pull = mirrored(settings, pull);
  }
  touch();
}

void GroomStage::clear(const ShapeStage& shape) {
  groom_ = groom::plainGroom(groom_.map.size(), shape.points());
  groom_.bare = bareAtFirst_;
  touch();
}

void GroomStage::setBare(std::size_t material, bool bare) {
  if (material >= groom_.bare.size()) return;
  groom_.bare[material] = bare;
  touch();
}

void GroomStage::edit(const ShapeStage& shape, GroomEdit edit, float value, const Vec3& direction, const settings::Settings& settings, Warnings& warnings) {
  followLie(shape, settings);  // which may have changed since the last update
  const groom::GroomSurface skin = this->groomSurface(shape);
  const auto seed = static_cast<std::uint32_t>(settings.seed);
  const auto pattern = [&](groom::Pattern which) { groom::paintPattern(groom_, skin, which, value, settings.paintColor, seed); };
  const auto blank = [this] { return groom::GroomMap(groom_.map.size(), groom::GroomMap::kBlank); };
  switch (edit) {
    case GroomEdit::Clear: clear(shape); break;
    case GroomEdit::Length: groom::setLength(groom_.map, value); break;
    case GroomEdit::Invert: groom::invertLength(groom_.map); break;
    case GroomEdit::Vary: groom::varyLength(groom_, skin, value, kGrain, seed); break;
    case GroomEdit::Type: groom::setType(groom_.map, static_cast<int>(glm::clamp(value, 1.0f, 4.0f))); break;
    case GroomEdit::Comb: groom::combAlong(groom_, skin.points, direction, value, lie_); break;
    case GroomEdit::Raise: groom::raiseAll(groom_, lie_); break;
    case GroomEdit::Lie: groom::letLie(groom_); break;
    case GroomEdit::Size: groom::resize(groom_, static_cast<int>(glm::clamp(value, 0.0f, 1e4f))); break;
    case GroomEdit::Paint: groom::paintAll(groom_, static_cast<std::uint32_t>(glm::clamp(value, 0.0f, 16777215.0f))); break;
    case GroomEdit::Tabby: pattern(groom::Pattern::Tabby); break;
    case GroomEdit::Spots: pattern(groom::Pattern::Spots); break;
    case GroomEdit::Rosettes: pattern(groom::Pattern::Rosettes); break;
    case GroomEdit::Patches: pattern(groom::Pattern::Patches); break;
    case GroomEdit::ClearPaint: groom_.paint = blank(); break;
    case GroomEdit::ClearMask: groom_.mask = blank(); break;
    case GroomEdit::ClearShape: groom_.shape = blank(); break;
    case GroomEdit::InvertMask: groom::invertMask(groom_.mask); break;
    case GroomEdit::SelectConnected:
      if (const auto at = shape.nearest(direction)) groom::selectConnected(groom_, skin, at->triangle);
      if (groom_.mask.isPlain()) warnings.push_back("the whole model hangs together: all of it is selected, nothing is masked");
      break;
    case GroomEdit::SelectType: groom::selectType(groom_, skin, static_cast<int>(glm::clamp(value, 1.0f, 4.0f))); break;
    case GroomEdit::SelectLength: groom::selectLength(groom_, skin, direction.x, direction.y); break;
    case GroomEdit::SelectPaint:
      if (const auto at = shape.nearest(direction)) groom::selectPaint(groom_, skin, atlasAt(shape.surface(), *at), value);
      break;
    case GroomEdit::GrowMask: groom::growMask(groom_, skin, value); break;
    case GroomEdit::ShrinkMask: groom::shrinkMask(groom_, skin, value); break;
    case GroomEdit::SmoothMask: groom::smoothMask(groom_, skin, value); break;
  }
  if (keepsMasked(edit)) groom::keepProtected(groom_, *before_, skin);
  touch();
}

void GroomStage::readImage(const ShapeStage& shape, groom::ImageOf what, std::string_view file, int width, int height, std::span<const std::uint8_t> rgba) {
  const auto map = groom::mapOfFile(file);
  if (map) groom::readMapPicture(*map, groom_, width, height, rgba);
  else groom::paintFromImage(what, groom_, groomSurface(shape), width, height, rgba);
  if (!map || *map != groom::ImageOf::Mask) groom::keepProtected(groom_, *before_, groomSurface(shape));
  touch();
}

void GroomStage::usePicture(const ShapeStage& shape, const settings::Settings& settings, PictureUse use, int width, int height,
                            std::span<const std::uint8_t> rgba, Warnings& warnings) {
  const groom::GroomSurface skin = groomSurface(shape);
  const groom::Picture picture{width, height, rgba};
  switch (use) {
    case PictureUse::Color: groom::paintColors(groom_, skin, picture); break;
    case PictureUse::TypeColor:
    case PictureUse::Skin: break;
    case PictureUse::Length: groom::paintFromImage(groom::ImageOf::Length, groom_, skin, width, height, rgba); break;
    case PictureUse::Alpha:
      if (!groom::isOpaque(picture)) groom::lengthFromAlpha(groom_, skin, picture);
      else warnings.push_back("the picture is opaque all over, so that its transparency says nothing of the length");
      break;
    case PictureUse::Density:
      if (const int bald = settings::baldType(settings)) groom::thinByPicture(groom_, skin, picture, bald);
      else warnings.push_back("fur is thinned by a type that is bald: set one of the types 2 to 4 to bald");
      break;
    case PictureUse::Types: groom::paintFromImage(groom::ImageOf::Types, groom_, skin, width, height, rgba); break;
    case PictureUse::Direction: groom::combFromPicture(groom_, skin, picture); break;
  }
  groom::keepProtected(groom_, *before_, skin);
  touch();
}

void GroomStage::apply(const ShapeStage& shape, const GroomStep& step, bool undo) {
  groomSurface(shape);
  app::apply(step, undo, groom_);
  touch();
}

}  // namespace fur::app
