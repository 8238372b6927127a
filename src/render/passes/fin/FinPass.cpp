#include "render/passes/fin/FinPass.h"

#include <algorithm>
#include <utility>

#include "core/Sort.h"
#include "furgen/FinOpacity.h"
#include "shared/Blocks.h"

namespace fur::render {

namespace {

constexpr gl::Attribute kEdgeAttributes[] = {
    {FUR_FIN_POSITION_A, 4, offsetof(FinEdge, positionA)}, {FUR_FIN_POSITION_B, 4, offsetof(FinEdge, positionB)},
    {FUR_FIN_NORMAL_A, 4, offsetof(FinEdge, normalA)},     {FUR_FIN_NORMAL_B, 4, offsetof(FinEdge, normalB)},
    {FUR_FIN_FACE_0, 4, offsetof(FinEdge, face0)},         {FUR_FIN_FACE_1, 4, offsetof(FinEdge, face1)},
    {FUR_FIN_ATLAS, 4, offsetof(FinEdge, atlas)},          {FUR_FIN_ROOM, 2, offsetof(FinEdge, room)},
};

// fin.vert's test for the outline, with a margin for its rounding.
bool onOutline(const FinEdge& e, const Vec3& toEye) {
  const float facing0 = glm::dot(Vec3(e.face0), toEye), facing1 = glm::dot(Vec3(e.face1), toEye);
  return facing0 * facing1 < FUR_SILHOUETTE + 1e-3f && std::max(facing0, facing1) > FUR_HORIZON - 1e-3f;
}

}  // namespace

std::size_t FinPass::set(const geometry::Surface& surface, bool moves) {
  edges_ = finEdges(surface);
  moving_.reset();
  if (moves) moving_.emplace(edges_);
  setLengths({});
  batches_.clear();
  return 0;
}

std::size_t FinPass::bytes() const {
  std::size_t sum = 0;
  for (const Batch& batch : batches_) sum += batch.instances.bytes();
  return sum;
}

void FinPass::follow(const Skin& skin) {
  moving_->follow(skin, edges_);
  selectedFor_.reset();
}

void FinPass::setLengths(std::span<const float> vertexLengths) {
  vertexLengths_.assign(vertexLengths.begin(), vertexLengths.end());
  selectedFor_.reset();
}

// Those that fin.vert would not collapse. `pixels` that they are high at distance 1; 0: all edges on the outline, also those
// where rays show it.
void FinPass::select(const Drawing& drawing, float pixels) {
  const Vec3 eye = eyeInModel(drawing.frame);
  if (selectedFor_ == Vec4(eye, pixels)) return;
  selectedFor_ = Vec4(eye, pixels);
  std::vector<FinEdge> seen;
  for (const FinEdge& e : edges_) {
    if (e.normalB.w >= FUR_FIN_ROUND && pixels > 0) continue;
    if (bald(e.positionA.w) && bald(e.positionB.w)) continue;
    const Vec3 way = eye - 0.5f * (Vec3(e.positionA) + Vec3(e.positionB));
    const float away = glm::length(way);
    if (pixels > 0 && pixels * 1.001f < away * static_cast<float>(FUR_FIN_PIXELS)) continue;
    if (onOutline(e, way / away)) seen.push_back(e);
  }
  upload(drawing, seen);
}

// Sheppard 2004, 3.2.1: from far to near, each as opaque as Eq. 3.1 and 3.2 have it, or `all` of them fully.
void FinPass::selectClassic(const Drawing& drawing, bool all) {
  const Vec3 eye = eyeInModel(drawing.frame);
  const Vec4 wanted(eye, all ? -2 : -1);
  if (selectedFor_ == wanted) return;
  selectedFor_ = wanted;
  constexpr float kFaintest = 0.04f;  // that shows
  std::vector<FinEdge> seen;
  std::vector<std::pair<float, std::uint32_t>> order;  // distance, index in `seen`
  for (const FinEdge& e : edges_) {
    if (bald(e.positionA.w) && bald(e.positionB.w)) continue;
    const Vec3 way = eye - 0.5f * (Vec3(e.positionA) + Vec3(e.positionB));
    const float away = glm::length(way), facing = glm::dot(Vec3(e.face0), way) * glm::dot(Vec3(e.face1), way) / (away * away);
    const Vec3 across = normalizeOr(glm::cross(Vec3(e.positionB - e.positionA), Vec3(e.normalA + e.normalB)), Vec3(0));
    const float opacity = all ? 1.0f : furgen::finOpacity(facing, glm::dot(across, way) / away);
    if (opacity < kFaintest) continue;
    order.emplace_back(away, static_cast<std::uint32_t>(seen.size()));
    seen.push_back(e);
    seen.back().normalB.w = opacity;
  }
  sortStably(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<FinEdge> farToNear;
  farToNear.reserve(seen.size());
  for (const auto& [away, i] : order) farToNear.push_back(seen[i]);
  upload(drawing, farToNear);
}

void FinPass::upload(const Drawing& drawing, const std::vector<FinEdge>& seen) {
  std::vector<std::vector<FinEdge>> ofMaterials(drawing.materials.count());
  for (const FinEdge& edge : seen) ofMaterials[drawing.surface.materialOf(static_cast<std::uint32_t>(edge.positionA.w))].push_back(edge);
  batches_.resize(ofMaterials.size());
  for (std::size_t i = 0; i < ofMaterials.size(); ++i) batches_[i].fill(ofMaterials[i]);
  count_ = static_cast<int>(seen.size());
  drawing.uploadedBytes += seen.size() * sizeof(FinEdge);
}

void FinPass::Batch::fill(const std::vector<FinEdge>& edges) {
  count = static_cast<int>(edges.size());
  if (count == 0) return;
  if (instances.bytes() > 0) return instances.update(gl::bytesOf(edges));
  instances = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(edges), true);
  array = gl::VertexArray(instances, sizeof(FinEdge), kEdgeAttributes, 1, nullptr);
}

bool FinPass::draw(const Drawing& drawing, VariantBits view) {
  const bool lines = view & kViewEdges;
  const Frame& frame = drawing.frame;
  if (!drawing.look.furry() || !(frame.settings.fins || lines)) return true;
  select(drawing, lines ? 0 : frame.coatLength * pixelsPerUnit(frame));
  if (count_ == 0) return true;
  if (!drawing.programs.use(Shader::Fin, drawing.look.fins(view))) return false;
  gl::apply(stateOf(view, {.cullBack = false, .alphaToCoverage = !lines, .alpha = false}));
  drawBatches(drawing, FUR_FIN_SEGMENTS);
  return true;
}

void FinPass::drawBatches(const Drawing& drawing, int segments) const {
  forFurry(drawing.materials, [&](std::size_t material) {
    const Batch& batch = batches_[material];
    if (batch.count > 0) batch.array.drawStrips(2 * (segments + 1), batch.count);
  });
}

// They support the shells, which are drawn over them: no depth of theirs hides any.
bool FinPass::drawClassic(const Drawing& drawing) {
  const settings::Settings& s = drawing.frame.settings;
  if (!drawing.look.furry() || !s.fins) return true;
  selectClassic(drawing, s.finEdges == 1);
  if (count_ == 0) return true;
  if (!drawing.programs.use(Shader::Fin, drawing.look.classicFur())) return false;
  gl::apply({.depthWrite = false, .cullBack = false, .blend = gl::Blend::Over});
  drawBatches(drawing, FUR_CLASSIC_FIN_SEGMENTS);
  return true;
}

}  // namespace fur::render
