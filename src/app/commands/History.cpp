#include "app/commands/History.h"

#include <algorithm>
#include <type_traits>

namespace fur::app {

namespace {

template <class T>
std::size_t bytesIn(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

std::size_t bytesOf(const Step& step) {
  if (const auto* mask = std::get_if<MaskStep>(&step)) return sizeof(Step) + bytesIn(mask->before.texels) + bytesIn(mask->after.texels) + bytesIn(mask->before.film) + bytesIn(mask->after.film) +
           bytesIn(mask->wet) + bytesIn(mask->hairBefore) + bytesIn(mask->hairAfter) + bytesIn(mask->groundBefore) + bytesIn(mask->groundAfter);
  if (const auto* hair = std::get_if<HairStep>(&step)) return sizeof(Step) + bytesIn(hair->before) + bytesIn(hair->after);
  if (std::holds_alternative<SettingsStep>(step)) return sizeof(Step) + sizeof(SettingsStep::Both);
  const auto* groom = std::get_if<GroomStep>(&step);
  if (!groom) return sizeof(Step);
  std::size_t bytes = sizeof(Step) + bytesIn(groom->points) + bytesIn(groom->combBefore) + bytesIn(groom->combAfter) +
                      bytesIn(groom->whiskersBefore) + bytesIn(groom->whiskersAfter) + bytesIn(groom->bareBefore) + bytesIn(groom->bareAfter) +
                      bytesIn(groom->dried.texels) + bytesIn(groom->dried.held) + bytesIn(groom->dried.film);
  for (const GroomStep::Map& map : groom->maps) bytes += bytesIn(map.before) + bytesIn(map.after);
  return bytes;
}

template <class Texel>
std::vector<Texel> cut(int size, const std::vector<Texel>& texels, const geometry::TexelRect& rect) {
  std::vector<Texel> part;
  for (int y = rect.y0; y < rect.y1; ++y)
    part.insert(part.end(), texels.begin() + y * size + rect.x0, texels.begin() + y * size + rect.x1);
  return part;
}

template <class Texel>
geometry::TexelRect difference(int size, const std::vector<Texel>& before, const std::vector<Texel>& after) {
  geometry::TexelRect rect{size, size, 0, 0};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (before[static_cast<std::size_t>(y) * size + x] != after[static_cast<std::size_t>(y) * size + x])
        rect = {std::min(rect.x0, x), std::min(rect.y0, y), std::max(rect.x1, x + 1), std::max(rect.y1, y + 1)};
  return rect;
}

// Between a step and its bytes, either way.
template <class Io, class S>
void carry(Io& io, S& step) {
  using Kind = std::remove_const_t<S>;
  if constexpr (std::is_same_v<Kind, SettingsStep>) {
    io(step.both->before, step.both->after);
  } else if constexpr (std::is_same_v<Kind, MaskStep>) {
    io(step.rect, step.before.texels, step.before.film, step.after.texels, step.after.film, step.wet, step.hairBefore, step.hairAfter,
       step.groundBefore, step.groundAfter);
  } else if constexpr (std::is_same_v<Kind, HairStep>) {
    io(step.before, step.after);
  } else if constexpr (std::is_same_v<Kind, GroomStep>) {
    for (auto& map : step.maps) io(map.rect, map.before, map.after);
    io(step.sizeBefore, step.sizeAfter, step.points, step.combBefore, step.combAfter, step.whiskersBefore, step.whiskersAfter, step.bareBefore, step.bareAfter,
       step.dried.texels, step.dried.held, step.dried.film);
  }
}

// Of each alternative of Step.
constexpr Command kCommandOf[] = {Command::Settings, Command::Water, Command::Groom, Command::Hair, Command::Model};
static_assert(std::size(kCommandOf) == std::variant_size_v<Step>);

// Makes it an empty one of that name; false: there is none.
bool become(Step& step, std::string_view name) {
  if (name == nameOf(Command::Settings)) step.emplace<SettingsStep>();
  else if (name == nameOf(Command::Water)) step.emplace<MaskStep>();
  else if (name == nameOf(Command::Groom)) step.emplace<GroomStep>();
  else if (name == nameOf(Command::Hair)) step.emplace<HairStep>();
  else if (name == nameOf(Command::Model)) step.emplace<ModelStep>();
  else return false;
  return true;
}

}  // namespace

std::optional<MaskStep> maskStep(const MaskImage& before, const wet::WetnessMask& after, bool always) {
  const int size = after.size();
  geometry::TexelRect rect = difference(size, before.texels, after.texels());
  const std::vector<float> none(before.film.empty() && after.film().empty() ? 0 : after.texels().size());
  const std::vector<float>& filmBefore = before.film.empty() ? none : before.film;
  const std::vector<float>& filmAfter = after.film().empty() ? none : after.film();
  if (!none.empty()) rect = unite(rect, difference(size, filmBefore, filmAfter));
  if (rect.empty() && !always) return std::nullopt;
  if (rect.empty()) rect = {0, 0, 0, 0};
  MaskStep step{rect, {}, {cut(size, after.texels(), rect), {}}, std::vector<std::uint32_t>((before.texels.size() + 31) / 32)};
  bool wet = false;
  for (std::size_t i = 0; i < before.texels.size(); ++i) {
    if (before.texels[i].w <= 0 && (before.film.empty() || before.film[i] <= 0)) continue;
    step.wet[i / 32] |= 1u << i % 32;
    wet = true;
  }
  if (wet) step.before.texels = cut(size, before.texels, rect);
  if (none.empty()) return step;
  step.before.film = cut(size, filmBefore, rect);
  step.after.film = cut(size, filmAfter, rect);
  return step;
}

void apply(const MaskStep& step, bool undo, wet::WetnessMask& mask) {
  const MaskImage& side = undo ? step.before : step.after;
  const int size = mask.size();
  std::vector<float> film = mask.film();
  if (!side.film.empty()) {
    film.resize(mask.texels().size());
    film = withRect(size, std::move(film), step.rect, side.film);
  }
  std::vector<Vec4> texels = mask.texels();
  if (!side.texels.empty()) texels = withRect(size, std::move(texels), step.rect, side.texels);
  for (std::size_t i = 0; undo && i < texels.size(); ++i) {
    if (step.wet[i / 32] >> i % 32 & 1) continue;
    texels[i] = Vec4(0);
    if (!film.empty()) film[i] = 0;
  }
  mask.restore(std::move(texels), std::move(film));
}

std::optional<GroomStep> groomStep(const groom::Groom& before, const groom::Groom& after) {
  GroomStep step;
  step.sizeBefore = before.map.size();
  step.sizeAfter = after.map.size();
  bool changed = step.sizeBefore != step.sizeAfter;
  for (std::size_t i = 0; i < std::size(groom::kMaps); ++i) {
    GroomStep::Map& map = step.maps[i];
    const auto &was = (before.*groom::kMaps[i]).texels(), &is = (after.*groom::kMaps[i]).texels();
    if (step.sizeBefore != step.sizeAfter) {
      map.before = was;
      map.after = is;
    } else if (map.rect = difference(step.sizeAfter, was, is); !map.rect.empty()) {
      map.before = cut(step.sizeBefore, was, map.rect);
      map.after = cut(step.sizeAfter, is, map.rect);
      changed = true;
    }
  }
  for (std::uint32_t i = 0; i < after.comb.size(); ++i) {
    const Vec3 was = before.comb.empty() ? Vec3(0) : before.comb[i];
    if (was == after.comb[i]) continue;
    step.points.push_back(i);
    step.combBefore.push_back(was);
    step.combAfter.push_back(after.comb[i]);
  }
  const bool planted = before.whiskers != after.whiskers;
  if (planted) {
    step.whiskersBefore = before.whiskers;
    step.whiskersAfter = after.whiskers;
  }
  if (before.bare != after.bare) {
    step.bareBefore = before.bare;
    step.bareAfter = after.bare;
    changed = true;
  }
  if (!changed && step.points.empty() && !planted) return std::nullopt;
  return step;
}

void apply(const GroomStep& step, bool undo, groom::Groom& groom) {
  const bool resized = step.sizeBefore != step.sizeAfter;
  if (resized) groom::resize(groom, undo ? step.sizeBefore : step.sizeAfter);
  for (std::size_t i = 0; i < std::size(groom::kMaps); ++i) {
    const auto& texels = undo ? step.maps[i].before : step.maps[i].after;
    groom::GroomMap& map = groom.*groom::kMaps[i];
    if (resized) map.restore(texels);
    else if (!step.maps[i].rect.empty()) map.restore(withRect(map.size(), map.texels(), step.maps[i].rect, texels));
  }
  for (std::size_t i = 0; i < step.points.size(); ++i)
    groom.comb[step.points[i]] = (undo ? step.combBefore : step.combAfter)[i];
  if (step.bareBefore != step.bareAfter) groom.bare = undo ? step.bareBefore : step.bareAfter;
  if (step.whiskersBefore != step.whiskersAfter) groom.whiskers = undo ? step.whiskersBefore : step.whiskersAfter;
}

void putBack(const DriedParts& parts, wet::WetnessMask& mask) {
  std::vector<Vec4> texels = mask.texels();
  std::vector<float> film = mask.film();
  if (film.empty() && std::any_of(parts.film.begin(), parts.film.end(), [](float amount) { return amount > 0; })) film.resize(texels.size());
  for (std::size_t i = 0; i < parts.texels.size(); ++i) {
    const std::size_t at = parts.texels[i];
    if (at >= texels.size() || texels[at].w > 0) continue;
    texels[at] = parts.held[i];
    if (!film.empty()) film[at] = parts.film[i];
  }
  mask.restore(std::move(texels), std::move(film));
}

void History::push(Step step, bool mergeable) {
  ++revision_;
  steps_.resize(done_);
  auto* last = steps_.empty() ? nullptr : std::get_if<SettingsStep>(&steps_.back());
  auto* now = std::get_if<SettingsStep>(&step);
  if (mergeable && last && now) {
    last->both->after = now->both->after;
    return;
  }
  steps_.push_back(std::move(step));
  std::size_t bytes = 0, keep = steps_.size();
  while (keep > 0 && (bytes += bytesOf(steps_[keep - 1])) <= kMaxBytes) --keep;
  // The newest step always stays, however large.
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(std::min(keep, steps_.size() - 1)));
  done_ = steps_.size();
}

const Step* History::undo() {
  ++revision_;
  return canUndo() ? &steps_[--done_] : nullptr;
}

const Step* History::redo() {
  ++revision_;
  return canRedo() ? &steps_[done_++] : nullptr;
}

void History::clear() {
  ++revision_;
  steps_.clear();
  done_ = 0;
}

Command commandOf(const Step& step) { return kCommandOf[step.index()]; }

void History::save(ByteWriter& to, bool leaves) const {
  const std::size_t count = leaves ? done_ : steps_.size();
  to(static_cast<std::uint32_t>(count + leaves), static_cast<std::uint32_t>(done_));
  for (std::size_t i = 0; i < count; ++i) {
    to(nameOf(commandOf(steps_[i])));
    std::visit([&](const auto& step) { carry(to, step); }, steps_[i]);
  }
  if (leaves) to(nameOf(Command::Model));
}

bool History::restore(std::span<const std::uint8_t> bytes) {
  ByteReader from(bytes);
  std::uint32_t count = 0, done = 0;
  std::vector<Step> steps;
  if (!bytes.empty()) from(count, done);
  for (; count > 0 && from.sound(); --count) {
    Step& step = steps.emplace_back();
    if (!become(step, from.text())) return false;
    std::visit([&](auto& one) { carry(from, one); }, step);
  }
  if (!from.sound() || !from.atEnd() || done > steps.size()) return false;
  ++revision_;
  steps_ = std::move(steps);
  done_ = done;
  return true;
}

}  // namespace fur::app
