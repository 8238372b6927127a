#include <cmath>

#include "core/NoteChange.h"
#include "render/passes/hair/HairScalp.h"
#include "render/passes/hairview/HairViews.h"
#include "render/passes/skin/SkinPass.h"

namespace fur::render {

namespace {

using hair::ViewLine;

constexpr gl::Attribute kLineAttributes[] = {
    {FUR_LINE_FROM, 4, offsetof(ViewLine, a)}, {FUR_LINE_TO, 4, offsetof(ViewLine, b)}, {FUR_LINE_COLOR, 4, offsetof(ViewLine, color)}};
static_assert(sizeof(ViewLine) == 12 * sizeof(float));

class DrawnHairViews final : public HairViews {
 public:
  void show(const hair::HairView* view) override { view_ = view; }
  bool instead() const override { return view_ && view_->instead; }
  bool draw(const Drawing& drawing, HairPass& hair) override;
  bool drawLines(const Drawing& drawing) override;
  std::size_t bytes() const override;

 private:
  void uploadLines(const Drawing& drawing);
  void uploadColors(const Drawing& drawing);
  bool colored(std::size_t scalp) const { return scalp < wispColors_.size() && wispColors_[scalp].bytes() > 0; }
  bool drawMap(const Drawing& drawing);
  bool drawWisps(const Drawing& drawing, const HairPass& hair);
  bool drawLines(const Drawing& drawing, Shader shader, bool depthTest);

  const hair::HairView* view_ = nullptr;
  std::uint64_t linesFor_ = 0, colorsFor_ = 0;
  gl::Buffer lines_;
  gl::VertexArray array_;
  gl::Texture map_;
  std::vector<gl::Texture> wispColors_;
};

void DrawnHairViews::uploadLines(const Drawing& drawing) {
  if (view_->lines.empty() || !noteChange(linesFor_, view_->lineRevision)) return;
  if (lines_.bytes() == 0) {
    lines_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(view_->lines), true);
    array_ = gl::VertexArray(lines_, sizeof(ViewLine), kLineAttributes, 1, nullptr);
  } else {
    lines_.update(gl::bytesOf(view_->lines));
  }
  drawing.uploadedBytes += gl::bytesOf(view_->lines).size();
}

void DrawnHairViews::uploadColors(const Drawing& drawing) {
  if (!noteChange(colorsFor_, view_->colorRevision)) return;
  map_ = {};
  if (!view_->mapColors.empty()) {
    const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(view_->mapColors.size()))));
    map_ = gl::Texture({gl::TexelFormat::RGBA8, side, side}, gl::bytesOf(view_->mapColors));
  }
  wispColors_.clear();
  for (const auto& colors : view_->wispColors) {
    wispColors_.emplace_back();
    if (!colors.empty()) wispColors_.back() = gl::Texture({gl::TexelFormat::RGBA8, 2, static_cast<int>(colors.size() / 2), 0, gl::Filter::Nearest}, gl::bytesOf(colors));
    drawing.uploadedBytes += wispColors_.back().bytes();
  }
  drawing.uploadedBytes += map_.bytes();
}

bool DrawnHairViews::draw(const Drawing& drawing, HairPass& hair) {
  if (!view_) return hair.draw(drawing);
  uploadColors(drawing);
  const bool tinted = !view_->wispColors.empty();
  if (!view_->instead) return tinted ? drawWisps(drawing, hair) : hair.draw(drawing);
  return drawMap(drawing) && (!tinted || drawWisps(drawing, hair)) && drawLines(drawing);
}

bool DrawnHairViews::drawMap(const Drawing& drawing) {
  if (map_.bytes() == 0) return drawSkin(drawing, drawing.look.bareSkin(kViewDim));
  if (!drawing.programs.use(Shader::HairMap, kPlain)) return false;
  map_.bind(FUR_UNIT_HAIR_COLORS);
  gl::apply({.cullBack = !drawing.surface.twoSided()});
  drawing.surface.draw(1);
  return true;
}

bool DrawnHairViews::drawWisps(const Drawing& drawing, const HairPass& hair) {
  for (std::size_t i = 0; i < hair.scalpCount(); ++i) {
    const HairScalp& scalp = *hair.scalp(i);
    if (scalp.wisps() == 0 || !colored(i)) continue;
    if (!drawing.programs.use(Shader::HairWisp, kPlain)) return false;
    shared::HairBlock block = scalp.block();
    block.pointStep = 1;
    scalp.bind(block);
    wispColors_[i].bind(FUR_UNIT_HAIR_COLORS);
    gl::apply({.cullBack = false, .alphaToCoverage = true, .alpha = false});
    gl::drawInstancesWithoutVertices(gl::Shape::Triangles, 6 * FUR_WISP_SEGMENTS, scalp.wispsDrawn());
  }
  return true;
}

bool DrawnHairViews::drawLines(const Drawing& drawing) {
  if (!view_ || view_->lines.empty()) return true;
  uploadLines(drawing);
  return drawLines(drawing, Shader::HiddenHairLine, false) && drawLines(drawing, Shader::HairLine, true);
}

bool DrawnHairViews::drawLines(const Drawing& drawing, Shader shader, bool depthTest) {
  if (!drawing.programs.use(shader, kPlain)) return false;
  gl::apply({.depthTest = depthTest, .depthWrite = false, .cullBack = false, .blend = gl::Blend::Over});
  array_.drawStrips(4, static_cast<int>(view_->lines.size()));
  return true;
}

std::size_t DrawnHairViews::bytes() const {
  std::size_t sum = lines_.bytes() + map_.bytes();
  for (const gl::Texture& colors : wispColors_) sum += colors.bytes();
  return sum;
}

}  // namespace

std::unique_ptr<HairViews> makeHairViews() { return std::make_unique<DrawnHairViews>(); }

}  // namespace fur::render
