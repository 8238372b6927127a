#include "app/stages/WaterStage.h"

#include <algorithm>
#include <cmath>

#include "core/Clock.h"
#include "core/NoteChange.h"
#include "core/PortableMath.h"
#include "geometry/Adjacency.h"

namespace fur::app {

namespace {

// Places that find their neighbours between two looks at the clock.
constexpr std::uint32_t kPlacesAtOnce = 1000;
// Model radii a second in the strongest wind.
constexpr float kWindSpeed = 1.5f;
// Wetness a second under the middle of a hair dryer.
constexpr float kDryerRate = 1.6f;
// Of save(), which browsers keep from visit to visit: another one whenever that changes.
constexpr std::uint32_t kWaterLayout = 4;
constexpr std::size_t kMostLanded = 64;
// Water that creeps and dries in the fur does so all the time: nobody sees it change by less than this, nor how it gets there within some seconds.
constexpr float kSeenChange = 1.0f / 64;
constexpr std::uint32_t kMostUnseenSteps = 8 * 60;
// Nor does fur hang lower by less than this, and it would sway at each change.
constexpr float kFeltChange = 1.0f / 32;

// What files may hold: more is no water.
bool areAmounts(std::span<const float> values) {
  return std::all_of(values.begin(), values.end(), [](float value) { return value >= 0 && value <= wet::Water::kMostAmount; });
}
bool isTexel(const Vec4& texel) {
  return std::abs(texel.x) <= 4 && std::abs(texel.y) <= 4 && texel.z >= 0 && texel.z <= 4 && texel.w >= 0 && texel.w <= wet::Water::kMostAmount;
}

}  // namespace

void WaterStage::touch() {
  ++revision_;
  unseen_ = 0;
  unseenSteps_ = 0;
}

void WaterStage::noteStep(float change) {
  unseen_ += change;
  ++unseenSteps_;
  if (unseen_ > 0 && (working() || unseen_ >= kSeenChange || unseenSteps_ >= kMostUnseenSteps)) touch();
}

void WaterStage::noteLanded(std::span<const std::uint32_t> triangles) {
  for (const std::uint32_t triangle : triangles)
    if (landed_.size() < kMostLanded) landed_.push_back(triangle);
}

void WaterStage::reset() {
  mask_.clear();
  water_.reset();
  strokes_.clear();
  before_.reset();
  held_.reset();
  landed_.clear();
  due_ = 0;
  steps_ = 0;
  layFor_ = 0;
  touch();
}

const wet::SurfaceWetting& WaterStage::wetting(const ShapeStage& shape) {
  const bool otherBare = groom_ && noteChange(bareFor_, groom_->groom().bare);
  const bool isAnew = noteChange(wettingFor_, shape.surfaceRevision()) || !wetting_;
  if (!isAnew && !otherBare) return *wetting_;
  std::vector<std::uint8_t> bare;
  for (std::uint32_t t = 0; t < shape.surface().triangleCount() && !bareFor_.empty(); ++t) bare.push_back(groom_->isBare(shape.materialAt(t)));
  wetting_.emplace(shape.surface(), mask_.size(), bare);
  around_.reset();
  borders_.reset();
  if (!isAnew) water_.forgetPlaces();  // of a new model it knows none
  return *wetting_;
}

void WaterStage::layDown(const GroomStage& groom) {
  if (!noteChange(layFor_, groom.verticesRevision())) return;
  std::vector<Vec3> lay;
  lay.reserve(groom.rests().size());
  for (const Vec3& rest : groom.rests()) lay.push_back(rest / groom::kMaxComb);
  water_.setLay(std::move(lay));
  water_.setLengths(groom.vertexLengths());
}

wet::Climate WaterStage::climate(const Inputs& inputs) const {
  const settings::Settings& settings = inputs.settings;
  wet::Climate c;
  c.worldFromModel = inputs.worldFromModel;
  c.wind = kWindSpeed * inputs.wind * Vec3(portableSin(settings.windYaw), 0, portableCos(settings.windYaw));
  c.dryRate = settings.stayWet ? 0 : settings.dryRate;
  c.furLength = inputs.coatLength;
  c.clumpSize = settings.clumpSize;
  c.groundHeight = inputs.shape.groundHeight();
  c.rain = holds(Tool::Rain) ? std::max(settings.rain, strokes_.back().flow) : settings.rain;
  c.shaking = inputs.shaking;
  if (!holds(Tool::Dryer)) return c;
  const WaterStroke& stroke = strokes_.back();
  c.blowCentre = held_->height > 0 ? placeOfHeld(inputs.shape) : positionAt(inputs.shape.surface(), held_->at);
  c.blowRadius = traitsOf(Tool::Dryer).reach * stroke.radius;
  c.blow = kDryerRate * stroke.flow * held_->pressure;
  return c;
}

bool WaterStage::update(const Inputs& inputs) {
  layDown(inputs.groom);
  wet::WetSurface on{inputs.shape.surface(), inputs.shape.query(), wetting(inputs.shape)};
  if (const auto* skin = inputs.shape.skin()) on.positions = skin->positions, on.normals = skin->normals;
  if (const ShapeStage::Before before = inputs.shape.before(); inputs.bySkin && inputs.shape.skin()) {
    on.before = before.seconds > 0 ? before.positions : on.positions;
    on.seconds = before.seconds > 0 ? before.seconds : 1;
  }
  on.hair = wetHair();
  const std::uint64_t before = revision_;
  // A hair early rather than a step late, as Water::step().
  for (due_ = std::min(due_ + inputs.seconds, 1.0f); due_ > wet::Water::kStep * 0.999f; due_ -= wet::Water::kStep) {
    if (!working() && !flows(climate(inputs))) continue;
    for (const double begun = secondsNow(); !water_.prepare(on, kPlacesAtOnce, inputs.settings.clumpSize);)
      if (secondsNow() - begun >= inputs.budget) {
        due_ = 0;
        return revision_ != before;
      }
    if (working()) work(inputs);
    const wet::Climate now = climate(inputs);
    if (!flows(now)) continue;
    if (inputs.shape.skin() && !water_.drops().empty()) on.shown = &inputs.shape.shownQuery();
    noteStep(water_.step(on, mask_, now) ? water_.change() : 0);
    noteLanded(water_.landed());
    ++steps_;
  }
  return revision_ != before;
}

// --- what there is ---

// None while nothing has been wet: a model that nobody wets needs no means.
wet::WaterAround* WaterStage::around(const ShapeStage& shape) {
  const wet::WetSurface on{shape.surface(), shape.query(), wetting(shape)};  // may drop those of another model
  if (!around_ && !mask_.isDry()) {
    around_.emplace(water_.texelsOf(on));
    borders_.emplace(shape.surface(), *wetting_);
    bordersAnew_ = true;
  }
  return around_ ? &*around_ : nullptr;
}

const wet::ChartBorders* WaterStage::takeBorders(const ShapeStage& shape, bool all) {
  around(shape);
  return (std::exchange(bordersAnew_, false) || all) && borders_ ? &*borders_ : nullptr;
}

std::vector<wet::TexelRect> WaterStage::takeChanged(const ShapeStage& shape, bool all) {
  std::vector<wet::TexelRect> parts = mask_.takeChangedParts(), bands;
  if (wet::WaterAround* const round = around(shape)) {
    round->update(mask_, parts);
    parts = round->takeChanged();
  }
  if (all) parts = {{0, 0, mask_.size(), mask_.size()}};
  for (const wet::TexelRect& part : parts) {
    if (part.empty()) continue;
    const int rows = std::max(kBandTexels / (part.x1 - part.x0), 1);
    for (int y = part.y0; y < part.y1; y += rows) bands.push_back({part.x0, y, part.x1, std::min(y + rows, part.y1)});
  }
  return bands;
}

wet::MaskTexels WaterStage::texels(const ShapeStage& shape, const wet::TexelRect& part, bool softened) {
  return wet::encodeMask(mask_, part, wetting(shape).chartOfTexel(), softened ? around(shape) : nullptr, borders_ ? &*borders_ : nullptr);
}

wet::MaskTexels WaterStage::texels(const ShapeStage& shape) {
  const wet::TexelRect whole{0, 0, mask_.size(), mask_.size()};
  wet::WaterAround* const round = around(shape);
  if (round) round->update(mask_, {&whole, 1});
  return wet::encodeMask(mask_, whole, wetting(shape).chartOfTexel(), round);
}

// Where the vertices lie, and how many of them there are at a point.
void WaterStage::placeVertices(const ShapeStage& shape) {
  const groom::SurfacePoints& points = shape.points();
  vertexTexels_.clear();
  pointVertices_.assign(points.count(), 0);
  for (const geometry::SurfaceVertex& vertex : shape.surface().vertices) {
    pointVertices_[points.pointOf[vertexTexels_.size()]] += 1;
    vertexTexels_.push_back(static_cast<std::uint32_t>(mask_.indexAt(vertex.atlas.x, vertex.atlas.y)));
  }
}

const std::vector<float>& WaterStage::vertexWetness(const ShapeStage& shape) {
  const bool other = noteChange(vertexSurfaceFor_, shape.surfaceRevision());
  if (other) placeVertices(shape);
  if (!noteChange(vertexWetnessFor_, revision_) && !other) return vertexWetness_;
  // Vertices of one point weigh the same, whichever charts they are of: where they bent apart, the coat would crack.
  const std::vector<std::uint32_t>& pointOf = shape.points().pointOf;
  pointSums_.assign(pointVertices_.size(), 0);
  for (std::size_t i = 0; i < vertexTexels_.size(); ++i) pointSums_[pointOf[i]] += mask_.texels()[vertexTexels_[i]].w;
  for (std::size_t i = 0; i < pointSums_.size(); ++i) pointSums_[i] /= pointVertices_[i];
  bool felt = vertexWetness_.size() != vertexTexels_.size();
  for (std::size_t i = 0; i < vertexTexels_.size() && !felt; ++i) {
    const float now = pointSums_[pointOf[i]];
    felt = std::abs(now - vertexWetness_[i]) > kFeltChange || (now > 0) != (vertexWetness_[i] > 0);
  }
  if (!felt) return vertexWetness_;
  vertexWetness_.resize(vertexTexels_.size());
  for (std::size_t i = 0; i < vertexTexels_.size(); ++i) vertexWetness_[i] = pointSums_[pointOf[i]];
  ++vertexRevision_;
  return vertexWetness_;
}

float WaterStage::meanWetness(const ShapeStage& shape) {
  if (mask_.isDry()) return 0;
  double sum = 0;
  long texels = 0;
  const auto& triangles = wetting(shape).atlas().triangleOf();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] == geometry::kNoTriangle) continue;
    sum += mask_.texels()[i].w;
    ++texels;
  }
  return static_cast<float>(sum / static_cast<double>(std::max(texels, 1l)));
}

void WaterStage::readPuddles() {
  if (!noteChange(puddlesFor_, water_.groundRevision())) return;
  std::vector<std::uint8_t> now;
  bool wet = false, seen = false;
  for (const float amount : water_.ground()) {
    wet |= amount > 0;
    now.push_back(static_cast<std::uint8_t>(255.0f * wet::seenOfPuddle(amount)));
    // Nobody sees a ground that is drier by a step of a byte.
    const int was = puddles_.empty() ? 0 : puddles_[now.size() - 1];
    seen |= std::abs(now.back() - was) > 1;
  }
  if (!wet) now.clear();
  if (!seen && wet != puddles_.empty()) return;
  puddles_ = std::move(now);
  ++puddlesRevision_;
}

// --- files ---

void WaterStage::restoreMask(std::vector<Vec4> texels, std::vector<float> film) {
  mask_.restore(std::move(texels), std::move(film));
  touch();
}

void WaterStage::readMask(const std::vector<Vec4>& from, int size) {
  std::vector<Vec4> texels;
  texels.reserve(mask_.texels().size());
  for (int i = 0; i < kMaskSize * kMaskSize; ++i) {
    const int x = i % kMaskSize * size / kMaskSize, y = i / kMaskSize * size / kMaskSize;
    texels.push_back(from[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)]);
  }
  restoreMask(std::move(texels));
}

bool WaterStage::isWet() const {
  const auto isSome = [](float amount) { return amount > 0; };
  const auto any = [&](const auto& amounts) { return std::any_of(amounts.begin(), amounts.end(), isSome); };
  return !mask_.isDry() || any(mask_.film()) || !water_.drops().empty() || any(water_.ground()) || (hair_ && any(hair_->waterState()));
}

std::vector<std::uint8_t> WaterStage::save(bool forFile) const {
  ByteWriter to;
  // Mask, film and what comes in, and some drops: growing step by step it would be there three times.
  to.bytes.reserve(mask_.texels().size() * (sizeof(Vec4) + 2 * sizeof(float)) + (std::size_t{1} << 16));
  to(kWaterLayout, mask_.texels(), mask_.film());
  water_.save(to);
  to(steps_, hair_ ? hair_->waterState() : std::vector<float>());
  saveStrokes(to, forFile ? std::vector<WaterStroke>() : strokes_);
  return std::move(to.bytes);
}

bool WaterStage::restore(std::span<const std::uint8_t> bytes) {
  ByteReader from(bytes);
  std::vector<Vec4> texels;
  std::vector<float> film;
  wet::Water water;
  std::uint32_t layout = 0, steps = 0;
  from(layout, texels, film);
  if (layout != kWaterLayout) return false;
  std::vector<float> hair;
  water.restore(from);
  from(steps, hair);
  std::vector<WaterStroke> strokes = restoreStrokes(from);
  const std::size_t all = mask_.texels().size();
  if (!from.sound() || !from.atEnd() || texels.size() != all || (!film.empty() && film.size() != all)) return false;
  if (!areAmounts(film) || !areAmounts(hair) || !std::all_of(texels.begin(), texels.end(), isTexel)) return false;
  water_ = std::move(water);
  layFor_ = 0;
  puddlesFor_ = water_.groundRevision() - 1;
  steps_ = steps;
  strokes_ = std::move(strokes);
  if (hair_) hair_->setWaterState(std::move(hair));
  restoreMask(std::move(texels), std::move(film));
  return true;
}

}  // namespace fur::app
