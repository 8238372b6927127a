// What a person does to long hair: strokes of tools, edits of all of it, and what goes into files and undo.
#include <algorithm>

#include "app/stages/GrownHair.h"
#include "core/Bytes.h"
#include "core/NumberText.h"
#include "hair/HairFields.h"
#include "hair/PlantGuides.h"
#include "scene/MapPlanes.h"

namespace fur::app {

namespace {

// Of what save() gives, which browsers keep from visit to visit: another one whenever that changes.
constexpr std::uint32_t kHairLayout = 2;

bool read(ByteReader& from, hair::Scalp& scalp) {
  std::uint32_t size = 0;
  std::int32_t nodes = 0;
  std::vector<std::uint8_t> map;
  scalp.name = from.text();
  const std::string values(from.text());
  from(size, map, nodes, scalp.guides.flags, scalp.guides.positions);
  const std::vector<Json> json = parseJson(values);
  if (!from.sound() || json.empty() || !json[0].isObject() || size < groom::GroomMap::kLeastSize || size > groom::GroomMap::kMostSize) return false;
  Warnings ignored;
  scalp.values = hair::readHairValues(json[0], ignored);
  scalp.map = groom::GroomMap(static_cast<int>(size), groom::GroomMap::kBlank);
  scalp.guides.nodes = nodes;
  const bool fits = nodes >= hair::kLeastNodes && nodes <= hair::kMostNodes && scalp.guides.count() <= hair::kMostGuides &&
                    scalp.guides.positions.size() == scalp.guides.count() * static_cast<std::size_t>(nodes);
  std::vector<groom::GroomMap::Texel> texels(scalp.map.texels().size());
  if (!fits || !scene::unpackMap(map, texels) || !hair::makeSound(scalp.guides)) return false;
  scalp.map.restore(std::move(texels));
  return true;
}

}  // namespace

std::vector<std::uint8_t> GrownHair::save() const {
  if (style_.empty()) return {};
  ByteWriter to;
  to(kHairLayout, static_cast<std::uint32_t>(style_.scalps.size()), static_cast<std::uint32_t>(selected_));
  for (const hair::Scalp& scalp : style_.scalps)
    to(std::string_view(scalp.name), std::string_view(hair::writeHairValues(scalp.values)), static_cast<std::uint32_t>(scalp.map.size()),
       scene::packMap(scalp.map.texels()), static_cast<std::int32_t>(scalp.guides.nodes), scalp.guides.flags, scalp.guides.positions);
  to(style_.bodies);
  return std::move(to.bytes);
}

bool GrownHair::restore(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) {
    selected_ = 0;
    setStyle({});
    return true;
  }
  ByteReader from(bytes);
  std::uint32_t layout = 0, count = 0, selected = 0;
  from(layout, count, selected);
  if (!from.sound() || layout != kHairLayout || count > hair::kMostScalps) return false;
  hair::Hairstyle style;
  for (; count > 0; --count)
    if (!read(from, style.scalps.emplace_back())) return false;
  from(style.bodies);
  if (!from.sound() || !from.atEnd() || style.bodies.size() > hair::kMostBodies) return false;
  setStyle(std::move(style));
  selected_ = std::min<std::size_t>(selected, style_.scalps.empty() ? 0 : style_.scalps.size() - 1);
  return true;
}

void GrownHair::beginStroke() {
  before_ = save();
  guideStroke_.reset();
  bodyStroke_.reset();
}

std::optional<HairStep> GrownHair::endStroke() {
  const auto before = std::exchange(before_, std::nullopt);
  if (!before) return std::nullopt;
  if (std::any_of(scalps_.begin(), scalps_.end(), [](const LiveScalp& live) { return live.lightStale; })) touch();
  HairStep step{*before, save()};
  if (step.before == step.after) return std::nullopt;
  return step;
}

void GrownHair::apply(const HairStep& step, bool undo) {
  const bool sound = restore(undo ? step.before : step.after);
  FUR_ASSERT(sound, "GrownHair::apply()", "bytes of save()", step.before.size());
}

// What needs no scalp; false: it is another edit.
bool GrownHair::editAll(const groom::GroomSurface& skin, const Edit& edit, Warnings& warnings) {
  switch (edit.what) {
    case HairEdit::Clear:
      style_ = {};
      selected_ = 0;
      selectedBody_ = -1;
      return true;
    case HairEdit::AddScalp:
      if (style_.scalps.size() >= hair::kMostScalps) return warnings.push_back("a model has at most " + decimal(hair::kMostScalps) + " scalps"), true;
      style_.scalps.emplace_back().map = groom::GroomMap(skin.atlas.size(), kFreshScalp);
      style_.scalps.back().name = "hair " + decimal(style_.scalps.size());
      selected_ = style_.scalps.size() - 1;
      return true;
    default: return false;
  }
}

void GrownHair::edit(const ShapeStage& shape, const groom::GroomSurface& skin, std::span<const Vec3> comb, const Edit& edit, Warnings& warnings) {
  if (editAll(skin, edit, warnings) || editBodies(shape, edit, warnings)) return touch();
  if (style_.scalps.empty()) return warnings.push_back("there is no scalp yet: add one first");
  hair::Scalp& scalp = style_.scalps[selected_];
  if (edit.what == HairEdit::Select) {
    const auto last = static_cast<float>(style_.scalps.size() - 1);
    if (edit.value < 0 || edit.value > last) warnings.push_back("that scalp is not there: they are counted from 0, and there are " + decimal(style_.scalps.size()));
    selected_ = static_cast<std::size_t>(glm::clamp(edit.value, 0.0f, last));
  }
  if (edit.what == HairEdit::Remove) {
    style_.scalps.erase(style_.scalps.begin() + static_cast<std::ptrdiff_t>(selected_));
    if (selected_ < scalps_.size()) scalps_.erase(scalps_.begin() + static_cast<std::ptrdiff_t>(selected_));
    selected_ = selected_ > 0 ? selected_ - 1 : 0;
  }
  if (edit.what == HairEdit::Cover) {
    groom::GroomMap::Texel texel = kFreshScalp;
    texel[0] = static_cast<std::uint8_t>(saturate(edit.value) * 255 + 0.5f);
    scalp.map = groom::GroomMap(skin.atlas.size(), texel);
    for (std::uint32_t t = 0; t < shape.surface().triangleCount() && !edit.bare.empty(); ++t)
      if (edit.bare[shape.materialAt(t)]) skin.atlas.forTexelsOf(shape.surface(), t, [&](std::uint32_t at, const Vec3&) { scalp.map.set(at, kFreshScalp); });
    scalp.map.fillGutter(skin.atlas, {0, 0, scalp.map.size(), scalp.map.size()});
  }
  if (edit.what == HairEdit::Paint || edit.what == HairEdit::Erase) {
    if (scalp.map.size() != skin.atlas.size()) scalp.map = groom::resized(scalp.map, skin.atlas.size());
    const Vec4 ball(edit.direction, edit.value);
    hair::paintDensity(scalp.map, skin, {&ball, 1}, edit.what == HairEdit::Paint ? 1.0f : 0.0f);
  }
  if (edit.what == HairEdit::Plant) {
    const int count = edit.value >= 1 && edit.value <= static_cast<float>(hair::kMostGuides) ? static_cast<int>(edit.value) : 0;
    auto guides = hair::plantGuides({shape.surface(), scalp.map}, scalp.values, count, comb);
    if (!guides) return warnings.push_back(scalp.name + ": " + guides.error().message);
    scalp.guides = std::move(*guides);
  }
  editGuides(shape, edit, warnings);
  touch();
}

void GrownHair::setValues(std::size_t scalp, const hair::HairValues& values) {
  if (scalp >= style_.scalps.size() || style_.scalps[scalp].values == values) return;
  style_.scalps[scalp].values = values;
  touch();
}

std::string GrownHair::describe() const {
  std::string out = "[";
  for (std::size_t i = 0; i < style_.scalps.size(); ++i) {
    const hair::Scalp& scalp = style_.scalps[i];
    const std::size_t wisps = i < scalps_.size() ? scalps_[i].growth.wisps.size() : 0;
    out += (i ? "," : "") + std::string("{\"name\":") + jsonString(scalp.name) + ",\"guides\":" + decimal(scalp.guides.count()) +
           ",\"wisps\":" + decimal(wisps) + ",\"selected\":" + (i == selected_ ? "true" : "false") +
           ",\"values\":" + hair::writeHairValues(scalp.values, true) + "}";
  }
  return out + "]";
}

Status GrownHair::setValue(std::size_t scalp, std::string_view name, std::string_view text, Warnings& warnings) {
  if (scalp >= style_.scalps.size()) return Error{ErrorId::BadFile, "there is no scalp " + decimal(scalp) + "; there are " + decimal(style_.scalps.size())};
  if (name == "name") {
    style_.scalps[scalp].name = hair::soundName(text);
    return Done{};
  }
  const hair::HairField* field = hair::findHairField(name);
  if (!field) return Error{ErrorId::BadFile, "hair has no value \"" + std::string(name.substr(0, 64)) + '"'};
  if (settings::setFieldText(style_.scalps[scalp].values, *field, text, warnings)) touch();
  return Done{};
}

}  // namespace fur::app
