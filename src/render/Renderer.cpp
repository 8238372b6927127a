#include "render/Renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/passes/background/BackgroundPass.h"
#include "render/passes/ball/BallPass.h"
#include "render/passes/bare/BarePass.h"
#include "render/passes/skin/SkinPass.h"

namespace fur::render {

namespace {

// In the size in which it is drawn.
Frame asDrawn(const Frame& frame) {
  Frame drawn = frame;
  if (frame.pixelScale >= 1) return drawn;
  for (int* side : {&drawn.width, &drawn.height})
    *side = std::max(1, static_cast<int>(std::lround(static_cast<float>(*side) * frame.pixelScale)));
  return drawn;
}

// Texels along the map of the fur's shadow: as many as the setting has, but none smaller than half a pixel. `radius`: of what it shows.
int shadowTexels(const Frame& frame, float radius) {
  constexpr int kFewest = 32;
  const float pixels = 2 * radius * pixelsPerUnit(frame) / std::max(glm::length(eyeInModel(frame)) - radius, 0.1f);
  int texels = kFewest << frame.settings.shadowSize;  // "32" of the setting is its first choice
  while (texels > kFewest && static_cast<float>(texels) > 2 * pixels) texels /= 2;
  return texels;
}

// Variant of the shader that draws the coat into the fur's shadow map.
VariantBits shadowedCoat(const Frame& frame) {
  return curveVariant(frame.settings) | (frame.groomed || frame.types ? kGroomed : kPlain) | (frame.types ? kTypes : kPlain);
}

// Rows of the framebuffer that the band has.
struct Rows {
  int bottom, count;
};
int allRows(const Frame& frame) { return frame.rows > 0 ? frame.rows : frame.height - frame.bottomRow; }
Rows rowsOf(const Frame& frame) {
  const auto edge = [&](int band) { return allRows(frame) * band / frame.bands; };
  return {edge(frame.band), edge(frame.band + 1) - edge(frame.band)};
}

// The viewport, or the band of it, empty.
void beginPicture(const Frame& frame) {
  gl::setViewport(frame.width, frame.height, frame.bottomRow);
  if (const Rows rows = rowsOf(frame); frame.bands > 1) gl::drawOnlyRows(rows.bottom, rows.count, frame.width);
  gl::clear(Vec4(0, 0, 0, 1));
}

}  // namespace

Result<Renderer> Renderer::create(std::shared_ptr<ContextObjects> shared) {
  const auto capabilities = gl::queryCapabilities();
  if (!capabilities) return capabilities.error();
  Renderer r;
  r.shared_ = shared ? std::move(shared) : std::make_shared<ContextObjects>();
  for (const Shader shader : {Shader::Ground, Shader::Background}) r.programs().begin(shader, kPlain);
  const shared::FrameBlock frame{};
  r.frameBlock_ = gl::Buffer(gl::BufferKind::Uniform, gl::bytesOf(frame), true);
  r.groundShadow_.create();
  r.uploadedBytes_ += r.maps_.create() + r.materials_.create();
  return r;
}

void Renderer::setSurface(const geometry::Surface& surface, std::span<const Vec3> tangents, std::span<const std::uint8_t> materialOf) {
  uploadedBytes_ += surface_.set(surface, tangents, materialOf);
  uploadedBytes_ += shells_.set(surface, surface_);
  uploadedBytes_ += fins_.set(surface, !tangents.empty());
  arrows_.set(surface_);
  beads_.set(surface);
  updateBends(std::vector<Vec4>(surface.vertices.size(), Vec4(0, 0, 0, 1)));
}

void Renderer::setSkin(const Skin& skin) {
  uploadedBytes_ += surface_.follow(skin);
  shells_.follow(skin);
  fins_.follow(skin);
  beads_.follow(skin);
}

void Renderer::setFurry(geometry::FurPatches patches, std::span<const float> vertexLengths) {
  shells_.setPatches(std::move(patches));
  fins_.setLengths(vertexLengths);
}

FurShadow::Key Renderer::furShadowKey(const Frame& frame) const {
  settings::Settings s = frame.settings;
  s.furLength = shells_.empty() ? 0 : frame.coatLength;
  const Vec3 light(glm::inverse(frame.worldFromModel) * Vec4(lightDirection(frame), 0));
  // In steps, so that texels stay where they are while hair swings.
  constexpr float kStep = 0.25f;
  const float reach = std::max(frame.reach, std::ceil(hair_->reach() / kStep) * kStep);
  const float radius = shadowRadius(s.furLength, reach);
  return {static_cast<Shadows>(s.shadows), shadowTexels(frame, radius), lightFromModel(light, radius),
          volumeShadow(s, fur_.density(), reach),
          shadowedCoat(frame),
          surface_.revision() + maps_.revision() + fur_.revision() + hair_->revision(),
          frame.ball, frame.ball.w > 0 ? frame.worldFromModel : Mat4(1.0f), frame.castsShadows};
}

void Renderer::uploadBlocks(const Frame& frame, const FurShadow::Key& shadow) {
  Frame of = frame;
  for (std::size_t i = 0; i < materials_.count(); ++i) {
    if (materials_.isBare(i) && i != materials_.main()) continue;
    of.baseColorFactor = materials_.at(i).baseColor;
    materials_.updateCoat(i, furBlock(of, fur_.shape(), fur_.densities(), maps_.maskSize(), maps_.typePictures()));
    uploadedBytes_ += sizeof(shared::FurBlock);
  }
  shared::FrameBlock block = frameBlock(frame);
  shadow.fill(block);
  block.samples = static_cast<float>(std::max(1, gl::platformSamples()));
  frameBlock_.update(gl::bytesOf(block));
  frameBlock_.bindAsBlock(FUR_FRAME_BINDING);
  materials_.bind(materials_.main());
  uploadedBytes_ += sizeof block;
}

void Renderer::begin(const Frame& frame, const Parts& parts) {
  beginPrograms(frame, parts);
  // Or the driver hears of them with the next picture.
  gl::flush();
}

void Renderer::beginPrograms(const Frame& frame, const Parts& parts) {
  const settings::Settings& s = frame.settings;
  const bool furry = frame.coatLength > 0;
  const Look look(frame, furry, parts.textured, parts.skinPictured);
  if (static_cast<View>(s.view) != View::Final) return;  // those are for study
  // What takes longest first.
  if (furry && s.shells) programs().begin(look.classic() ? Shader::ClassicShell : Shader::Shell, look.classic() ? look.classicFur() : look.shells(kPlain));
  if (furry && s.fins) programs().begin(Shader::Fin, look.classic() ? look.classicFur() : look.fins(kPlain));
  if (s.skin) programs().begin(Shader::Skin, look.skin(kPlain));
  if (parts.bare) programs().begin(Shader::Bare, shadowVariant(s));
  if (parts.whiskers) programs().begin(Shader::Whisker, look.whiskers());
  if (!frame.castsShadows) return;
  if (s.ground)
    for (const Shader shader : {Shader::GroundShadow, Shader::Blur}) programs().begin(shader, kPlain);
  if (static_cast<Shadows>(s.shadows) == Shadows::None) return;
  programs().begin(Shader::ShadowMap, shadowedCoat(frame));
  if (static_cast<Shadows>(s.shadows) == Shadows::Depth) programs().begin(Shader::ShadowBlur, kShadowDepth);
}

void Renderer::begin(const Frame& frame) {
  const bool skinPictured = maps_.typePictures()[FUR_TYPES] >= 0;
  begin(frame, {.textured = materials_.hasPicture() || maps_.hasTypePictures(), .skinPictured = skinPictured, .bare = materials_.anyBare(), .whiskers = whiskers_.bytes() > 0});
}

void Renderer::warmUp(const Frame& frame) {
  fur_.showTexel(1);
  Frame pixel = frame;
  pixel.width = pixel.height = 1;
  (void)draw(pixel);  // whoever draws next has the error, too
  fur_.showTexel(0);
  gl::flush();
  // Drivers put off a pass that is flushed until another begins.
  groundShadow_.drawNothing();
  gl::flush();
}

Status Renderer::draw(const Frame& frame) {
  FUR_ASSERT(surface_.indexCount() > 0, "Renderer::draw()", "a surface", surface_.indexCount());
  const Frame drawn = asDrawn(frame);
  drawnPixels_ = static_cast<long>(drawn.width) * drawn.height;
  const bool furry = fur_.density() > 0 && frame.coatLength > 0 && !shells_.empty();
  const Look look(drawn, furry, materials_.hasPicture() || maps_.hasTypePictures(), maps_.typePictures()[FUR_TYPES] >= 0);
  const Drawing drawing{drawn, look, surface_, materials_, maps_.wetCells(), programs(), uploadedBytes_};
  hair_->fit(drawn);
  const FurShadow::Key shadow = furShadowKey(drawn);
  uploadBlocks(drawn, shadow);
  if (!hair_->update(programs()) || !groundShadow_.update(drawing, *hair_)) return programs().error();
  fur_.bind(frame.wet);
  maps_.bind(frame);
  uploadedBytes_ += strandTables_.use(frame.settings);
  if (!furShadow_.update(programs(), shadow, surface_.array(), surface_.indexCount(), *hair_)) return programs().error();
  const bool direct = frame.pixelScale >= 1;
  if (!direct)
    if (Status status = small_.begin(drawn.width, drawn.height); !status) return status;
  beginPicture(drawn);
  if (!drawPasses(drawing)) return programs().error();
  if (!direct) {
    gl::setViewport(frame.width, frame.height);
    if (!small_.show(programs())) return programs().error();
  }
  if (frame.gathers && !gather(drawing, frame)) return programs().error();
  return Done{};
}

bool Renderer::gather(const Drawing& drawing, const Frame& frame) {
  const Rows rows = rowsOf(frame);
  if (!gathered_.add(programs(), frame.width, allRows(frame), rows.bottom, rows.count)) return false;
  if (!frame.flows) {
    if (frame.band + 1 == frame.bands) return gathered_.show(programs());
    gl::flush();
    return true;
  }
  // The framebuffer lacks the depth of what was drawn elsewhere, or in other bands: there the skin hides what is behind it.
  if (frame.bands > 1 || frame.pixelScale < 1) {
    gl::clear(Vec4(0, 0, 0, 1));
    if (!drawSkin(drawing, drawing.look.skin(kPlain))) return false;
  }
  if (!gathered_.show(programs(), true)) return false;
  // From the middle of the pixels, or drops that hang would tremble.
  Frame middle = frame;
  middle.sample = 0;
  frameBlock_.update(gl::bytesOf(frameBlock(middle)));
  return drops_.draw(drawing);
}

Status Renderer::showGathered(const Frame& frame) {
  shared::FrameBlock block = frameBlock(frame);
  frameBlock_.update(gl::bytesOf(block));
  frameBlock_.bindAsBlock(FUR_FRAME_BINDING);
  if (!gathered_.show(programs())) return programs().error();
  return Done{};
}

void Renderer::rest() {
  small_ = {};
  gathered_.rest();
}

bool Renderer::drawPasses(const Drawing& drawing) {
  const auto view = static_cast<View>(drawing.frame.settings.view);
  const bool ofHair = view == View::Final && hairViews_ && hairViews_->instead();
  if (view == View::Final && !ofHair) return drawFinal(drawing);
  const bool counts = view == View::Overdraw || view == View::Steps, transparent = drawing.frame.transparent;
  return (counts || transparent || drawBackground(drawing)) && (counts ? drawCounts(drawing, view) : ofHair ? hairViews_->draw(drawing, *hair_) : drawView(drawing, view)) &&
         (!transparent || drawBackground(drawing));
}

bool Renderer::drawFinal(const Drawing& drawing) {
  const settings::Settings& s = drawing.frame.settings;
  const bool classic = drawing.look.classic();
  return drawBall(drawing) && (!classic ? drawModel(drawing, kPlain) : !s.skin || drawSkin(drawing, drawing.look.skin(kPlain))) &&
         (hairViews_ ? hairViews_->draw(drawing, *hair_) : hair_->draw(drawing)) && whiskers_.draw(drawing) && ground_.draw(drawing, groundShadow_) &&
         drawBackground(drawing) && drawBlended(drawing) && (!classic ? beads_.draw(drawing, whiskers_) : drawClassic(drawing)) &&
         (drawing.frame.flows || drops_.draw(drawing)) && (!hairViews_ || hairViews_->drawLines(drawing));
}

// The technique `shells`: what is blended comes over all that is not.
bool Renderer::drawClassic(const Drawing& drawing) {
  return fins_.drawClassic(drawing) && (!drawing.frame.settings.shells || shells_.drawClassic(drawing));
}

bool Renderer::drawModel(const Drawing& drawing, VariantBits view) {
  const settings::Settings& s = drawing.frame.settings;
  return (!s.shells || shells_.draw(drawing, view)) && fins_.draw(drawing, view) && (!s.skin || drawSkin(drawing, drawing.look.skin(view)));
}

// The picture leaves its depth behind, then fragments are counted that are no further.
bool Renderer::drawCounts(const Drawing& drawing, View view) {
  if (!drawModel(drawing, kPlain)) return false;
  gl::clearColor();
  return view == View::Steps ? shells_.draw(drawing, kViewSteps) : drawModel(drawing, kViewOverdraw);
}

bool Renderer::drawView(const Drawing& drawing, View view) {
  for (const ViewPart& part : kViewParts)
    if (part.view == view && !drawPart(drawing, part)) return false;
  return true;
}

bool Renderer::drawPart(const Drawing& drawing, const ViewPart& part) {
  switch (part.part) {
    case Part::Shells: return drawing.look.classic() ? shells_.drawClassic(drawing) : shells_.draw(drawing, part.bits);
    case Part::Fins:
      if (!drawing.look.classic()) return fins_.draw(drawing, part.bits);
      // On the skin, which hides those behind it: their own depth does not.
      return drawSkin(drawing, drawing.look.skin(kPlain)) && fins_.drawClassic(drawing);
    case Part::Arrows: return arrows_.draw(drawing, part.bits);
    case Part::BareSkin: return drawSkin(drawing, drawing.look.bareSkin(part.bits));
    case Part::Skin: break;
  }
  return drawSkin(drawing, drawing.look.skin(part.bits));
}

std::size_t Renderer::gpuBytes() const {
  return surface_.bytes() + maps_.bytes() + materials_.bytes() + fur_.bytes() + strandTables_.bytes() + groundShadow_.bytes() + furShadow_.bytes() + shells_.bytes() +
         fins_.bytes() + hair_->bytes() + (hairViews_ ? hairViews_->bytes() : 0) + whiskers_.bytes() + ground_.bytes() + beads_.bytes() + drops_.bytes() + small_.bytes() + gathered_.bytes();
}

std::size_t Renderer::takeUploadedBytes() { return std::exchange(uploadedBytes_, 0); }

}  // namespace fur::render
