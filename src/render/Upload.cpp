// The renderer's half that turns CPU data into GL objects.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Assert.h"
#include "furgen/LockCentres.h"
#include "geometry/Adjacency.h"
#include "geometry/Curvature.h"
#include "geometry/Weld.h"
#include "render/Renderer.h"
#include "shared/Blocks.h"

namespace fur::render {

namespace {

constexpr gl::Attribute kSkinAttributes[] = {
    {FUR_POSITION, 4, offsetof(SkinVertex, position)}, {FUR_NORMAL, 4, offsetof(SkinVertex, normal)},
    {FUR_GRAD_S, 4, offsetof(SkinVertex, gradS)},      {FUR_GRAD_T, 3, offsetof(SkinVertex, gradT)},
};
constexpr gl::Attribute kFurAttributes[] = {
    {FUR_UV_ATLAS, 4, offsetof(FurVertex, uvAtlas)}, {FUR_FUR_COORD, 4, offsetof(FurVertex, fur)},
    {FUR_ATLAS_FROM_FUR, 4, offsetof(FurVertex, atlasFromFur)}, {FUR_AROUND, 4, offsetof(FurVertex, around)},
    {FUR_LEAN, 2, offsetof(FurVertex, lean)},
};
constexpr gl::Attribute kEdgeAttributes[] = {
    {FUR_FIN_POSITION_A, 4, offsetof(FinEdge, positionA)}, {FUR_FIN_POSITION_B, 4, offsetof(FinEdge, positionB)},
    {FUR_FIN_NORMAL_A, 4, offsetof(FinEdge, normalA)},     {FUR_FIN_NORMAL_B, 4, offsetof(FinEdge, normalB)},
    {FUR_FIN_FACE_0, 4, offsetof(FinEdge, face0)},         {FUR_FIN_FACE_1, 4, offsetof(FinEdge, face1)},
    {FUR_FIN_ATLAS, 4, offsetof(FinEdge, atlas)},
};

// From this angle between its two faces on an edge is sharp.
constexpr float kSharpCosine = 0.77f;
constexpr float kLeaningCosine = 0.9f;

float curvatureAcross(const geometry::SurfaceEdge& e, const geometry::SurfaceVertex& a, const geometry::SurfaceVertex& b, bool turned) {
  // Where fur leans over the edge it curves as much as the fur does, however sharp the skin is.
  const bool leans = turned && glm::dot(e.faceNormal0, a.normal) < kLeaningCosine;
  if (glm::dot(e.faceNormal0, e.faceNormal1) < kSharpCosine && !leans) return -1.0f;
  if (e.betweenFacets && !leans) return 0.0f;
  float sum = 0.0f;
  for (const auto* v : {&a, &b}) {
    Vec3 s, t;
    geometry::tangentAxes(*v, s, t);
    const Vec3 across = normalizeOr(glm::cross(v->normal, b.position - a.position), s);
    const Vec2 d(glm::dot(s, across), glm::dot(t, across));
    sum += 0.5f * (v->curvature.x * d.x * d.x + 2.0f * v->curvature.y * d.x * d.y + v->curvature.z * d.y * d.y);
  }
  return sum;
}

std::vector<FinEdge> finEdges(const geometry::Surface& surface) {
  std::vector<FinEdge> out;
  out.reserve(surface.edges.size());
  for (const auto& e : surface.edges) {
    const auto& a = surface.vertices[e.a];
    const auto& b = surface.vertices[e.b];
    const Vec2 uv = 0.5f * (a.uv + b.uv);
    out.push_back({Vec4(a.position, static_cast<float>(e.a)), Vec4(b.position, static_cast<float>(e.b)),
                   Vec4(a.normal, e.finStart), Vec4(b.normal, curvatureAcross(e, a, b, surface.turned)), Vec4(e.faceNormal0, uv.x), Vec4(e.faceNormal1, uv.y),
                   Vec4(a.atlas, b.atlas)});
  }
  return out;
}

// FUR_AROUND: the middle of the largest triangle at that place, which is in its chart where the place may lie on a border.
void findSurroundings(const geometry::Surface& surface, std::vector<FurVertex>& vertices) {
  std::vector<Vec3> positions;
  for (const auto& v : surface.vertices) positions.push_back(v.position);
  const geometry::Weld weld = geometry::weldPositions(positions);
  std::vector<Vec3> found(weld.count, Vec3(0));
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    const auto atlas = [&](std::size_t k) { return surface.vertices[surface.indices[i + k]].atlas; };
    const Vec2 a = atlas(0), b = atlas(1) - a, c = atlas(2) - a;
    const float edge = std::sqrt(std::abs(b.x * c.y - b.y * c.x));
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3& at = found[weld.idOf[surface.indices[i + k]]];
      if (edge > at.z) at = Vec3(a + (b + c) / 3.0f, edge);
    }
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].around = Vec4(found[weld.idOf[i]], surface.turned ? 1.0f : 0.0f);
}

}  // namespace

void Renderer::setSurface(const geometry::Surface& surface, std::span<const Vec3> tangents) {
  std::vector<SkinVertex> vertices;
  std::vector<FurVertex> furVertices;
  for (const auto& v : surface.vertices) {
    vertices.push_back({Vec4(v.position, v.strands.x), Vec4(v.normal, v.strands.y), Vec4(v.gradS, v.curvature.z), v.gradT});
    furVertices.push_back({Vec4(v.uv, v.atlas), Vec4(v.fur, v.curvature.x, v.curvature.y), v.atlasFromFur, {}, v.lean});
  }
  findSurroundings(surface, furVertices);
  sheets_ = surface.sheets;
  finEdges_ = finEdges(surface);
  vertices_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(vertices), !tangents.empty());
  furVertices_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(furVertices), false);
  indices_ = gl::Buffer(gl::BufferKind::Index, gl::bytesOf(surface.indices), false);
  patches_ = {surface.furIndices, surface.ownFurIndices, surface.furClusters};
  furIndices_ = gl::Buffer(gl::BufferKind::Index, gl::bytesOf(patches_.indices), true);
  shellsFor_.reset();
  edges_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(finEdges_), true);
  finEye_.reset();
  const auto arrayWith = [this](const gl::Buffer& indices) {
    gl::VertexArray array(vertices_, sizeof(SkinVertex), kSkinAttributes, 0, &indices);
    array.add(furVertices_, sizeof(FurVertex), kFurAttributes, 0);
    return array;
  };
  surface_ = arrayWith(indices_);
  shells_ = arrayWith(furIndices_);
  fins_ = gl::VertexArray(edges_, sizeof(FinEdge), kEdgeAttributes, 1, nullptr);
  arrows_ = gl::VertexArray(vertices_, sizeof(SkinVertex), std::span(kSkinAttributes).first(2), 1, nullptr);
  vertexCount_ = static_cast<int>(surface.vertices.size());
  indexCount_ = static_cast<int>(surface.indices.size());
  uploadedBytes_ += vertices_.bytes() + furVertices_.bytes() + indices_.bytes() + furIndices_.bytes() + edges_.bytes();
  bendCapacity_ = 0;
  shadowKey_.reset();
  ++furShadowScene_;
  vertexLengths_.clear();
  const std::vector<Vec4> rest(surface.vertices.size(), Vec4(0, 0, 0, 1));
  updateBends(rest);
  moving_.reset();
  if (!tangents.empty()) moving_.emplace(std::move(vertices), tangents, finEdges_);
}

void Renderer::setSkin(const Skin& skin) {
  FUR_ASSERT(moving_.has_value(), "Renderer::setSkin()", "a surface with tangents", "one without");
  moving_->follow(skin, finEdges_);
  vertices_.update(std::as_bytes(moving_->vertices()));
  uploadedBytes_ += vertices_.bytes();
  for (geometry::FurCluster& cluster : patches_.clusters) {
    // It may face any way now.
    if (std::exchange(cluster.cosine, -1.0f) > 0) shellsFor_.reset();
    cluster.centre = skin.positions[patches_.indices[cluster.first]];
  }
  finEye_.reset();
  shadowKey_.reset();
  ++furShadowScene_;
}

void Renderer::setFurry(geometry::FurPatches patches, std::span<const float> vertexLengths) {
  patches_ = std::move(patches);
  vertexLengths_.assign(vertexLengths.begin(), vertexLengths.end());
  finEye_.reset();
  shellsFor_.reset();
}

// Those that fin.vert would not collapse: its test, with a margin for its rounding. `pixels` that they are high at distance 1;
// 0: all edges on the outline, also those where rays show it.
void Renderer::selectFins(const Vec3& eyeModel, float pixels) {
  if (finEye_ == Vec4(eyeModel, pixels)) return;
  finEye_ = Vec4(eyeModel, pixels);
  std::vector<FinEdge> seen;
  const auto bald = [this](float vertex) {
    return !vertexLengths_.empty() && vertexLengths_[static_cast<std::size_t>(vertex)] <= 0;
  };
  for (const FinEdge& e : finEdges_) {
    if (e.normalB.w >= FUR_FIN_ROUND && pixels > 0) continue;
    if (bald(e.positionA.w) && bald(e.positionB.w)) continue;
    const Vec3 way = eyeModel - 0.5f * (Vec3(e.positionA) + Vec3(e.positionB));
    const float away = glm::length(way);
    if (pixels > 0 && pixels * 1.001f < away * static_cast<float>(FUR_FIN_PIXELS)) continue;
    const Vec3 toEye = way / away;
    const float facing0 = glm::dot(Vec3(e.face0), toEye), facing1 = glm::dot(Vec3(e.face1), toEye);
    if (facing0 * facing1 < FUR_SILHOUETTE + 1e-3f && std::max(facing0, facing1) > FUR_HORIZON - 1e-3f) seen.push_back(e);
  }
  finCount_ = static_cast<int>(seen.size());
  if (seen.empty()) return;
  edges_.update(gl::bytesOf(seen));
  uploadedBytes_ += seen.size() * sizeof(FinEdge);
}

// Near to far: what is covered is rejected by depth. Without what faces away.
void Renderer::orderShells(const Vec3& eyeModel, float reach, bool overlapping) {
  if (shellsFor_ == Vec4(eyeModel, reach) && shellsOverlap_ == overlapping) return;
  shellsFor_ = Vec4(eyeModel, reach);
  shellsOverlap_ = overlapping;
  std::vector<std::uint32_t> seen;
  seen.reserve(patches_.indices.size());
  for (const std::uint32_t i : geometry::clustersNearToFar(patches_.clusters, eyeModel, reach)) {
    const geometry::FurCluster& c = patches_.clusters[i];
    const auto first = overlapping ? patches_.indices.begin() + c.first : patches_.ownIndices.begin() + c.ownFirst;
    seen.insert(seen.end(), first, first + (overlapping ? c.count : c.ownCount));
  }
  shellIndexCount_ = static_cast<int>(seen.size());
  if (seen.empty()) return;
  furIndices_.update(gl::bytesOf(seen));
  uploadedBytes_ += seen.size() * sizeof(std::uint32_t);
}

void Renderer::setFurLayer(int type, int layer, std::span<const furgen::PackedLevel> levels) {
  fur_.setLayer(type, layer, levels);
  for (const furgen::PackedLevel& level : levels)
    uploadedBytes_ += level.coverage.size() + level.strand.size() + level.offset.size();
}

void Renderer::setFinMap(int type, std::span<const furgen::PackedLevel> levels) {
  fur_.setFin(type, levels);
  for (const furgen::PackedLevel& level : levels) uploadedBytes_ += level.coverage.size() + level.strand.size();
}

void Renderer::showFur(std::span<const float> densities) {
  fur_.show();
  std::fill(densities_.begin(), densities_.end(), 0.0f);
  std::copy_n(densities.begin(), std::min(densities.size(), densities_.size()), densities_.begin());
  hasFur_ = *std::max_element(densities_.begin(), densities_.end()) > 0;
  ++furShadowScene_;
}

void Renderer::setBaseColor(int width, int height, std::span<const std::uint8_t> rgba) {
  const std::uint8_t white[4] = {255, 255, 255, 255};
  hasPicture_ = !rgba.empty();
  if (!hasPicture_) width = height = 1, rgba = white;
  baseColor_ = gl::Texture({gl::TexelFormat::RGBA8, width, height, 0, gl::Filter::Trilinear, true},
                           std::as_bytes(rgba));
  uploadedBytes_ += baseColor_.bytes();
}

void Renderer::updateMask(const wet::MaskTexels& mask) {
  const geometry::TexelRect& rect = mask.rect;
  if (rect.empty()) return;
  if (mask_.shape().width != mask.size || mask_.bytes() == 0) {
    const geometry::TexelRect whole{0, 0, mask.size, mask.size};
    FUR_ASSERT(rect == whole, "Renderer::updateMask()", "the whole of a mask of another size", mask.texels.size());
    mask_ = gl::Texture({gl::TexelFormat::RGBA32F, mask.size, mask.size, 0, gl::Filter::Nearest, false}, {});
  }
  mask_.update(rect.x0, rect.y0, rect.x1 - rect.x0, rect.y1 - rect.y0, gl::bytesOf(mask.texels), 0);
  uploadedBytes_ += mask.texels.size() * sizeof(Vec4);
}

void Renderer::showPuddles(const wet::Puddles& puddles) {
  constexpr int kCells = wet::kGroundCells;
  FUR_ASSERT(puddles.cells.size() == kCells * kCells, "Frame::puddles", "a byte for each cell", puddles.cells.size());
  if (puddles_.bytes() == 0) puddles_ = gl::Texture({gl::TexelFormat::R8, kCells, kCells, 0}, {});
  puddles_.bind(FUR_UNIT_PUDDLES);
  if (std::exchange(puddlesRevision_, puddles.revision) == puddles.revision) return;
  puddles_.update(0, 0, kCells, kCells, std::as_bytes(puddles.cells), 0);
  uploadedBytes_ += puddles.cells.size();
}

void Renderer::updateGroom(const groom::GroomMap& map, const geometry::TexelRect& changed) {
  ++furShadowScene_;
  updateMap(groom_, map, changed);
}

void Renderer::updateShape(const groom::GroomMap& shape, const geometry::TexelRect& changed) {
  if (lockCentres_.bytes() == 0) {
    constexpr int kSize = 128;
    const std::vector<std::array<std::uint8_t, 2>> texels = furgen::lockCentres(kSize, static_cast<int>(FUR_LOCKS_ACROSS));
    lockCentres_ = gl::Texture({gl::TexelFormat::RG8, kSize, kSize, 0, gl::Filter::Nearest, true}, gl::bytesOf(texels));
  }
  updateMap(shape_, shape, changed);
}

void Renderer::updateMap(gl::Texture& texture, const groom::GroomMap& map, const geometry::TexelRect& changed) {
  const int size = map.size();
  const auto bytes = gl::bytesOf(map.texels());
  if (texture.shape().width != size) {
    texture = gl::Texture({gl::TexelFormat::RGBA8, size, size, 0, gl::Filter::Linear, false}, bytes);
    uploadedBytes_ += texture.bytes();
  } else if (!changed.empty()) {
    const int width = changed.x1 - changed.x0, height = changed.y1 - changed.y0;
    texture.update(changed.x0, changed.y0, width, height, bytes, size);
    uploadedBytes_ += sizeof(groom::GroomMap::Texel) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
}

void Renderer::updateBends(std::span<const Vec4> bends) {
  ++furShadowScene_;
  const int rows = std::max(1, (static_cast<int>(bends.size()) + FUR_BEND_ROW - 1) / FUR_BEND_ROW);
  if (rows * FUR_BEND_ROW != bendCapacity_) {
    bends_ = gl::Texture({gl::TexelFormat::RGBA32F, FUR_BEND_ROW, rows, 0, gl::Filter::Nearest, false}, {});
    bendCapacity_ = rows * FUR_BEND_ROW;
  }
  const int fullRows = static_cast<int>(bends.size()) / FUR_BEND_ROW;
  const int rest = static_cast<int>(bends.size()) % FUR_BEND_ROW;
  const auto bytes = std::as_bytes(bends);
  if (fullRows) bends_.update(0, 0, FUR_BEND_ROW, fullRows, bytes, FUR_BEND_ROW);
  if (rest) bends_.update(0, fullRows, rest, 1, bytes.subspan(sizeof(Vec4) * fullRows * FUR_BEND_ROW), 0);
  uploadedBytes_ += bytes.size();
}

std::size_t Renderer::gpuBytes() const {
  return vertices_.bytes() + furVertices_.bytes() + indices_.bytes() + furIndices_.bytes() + edges_.bytes() + fur_.bytes() +
         mask_.bytes() + bends_.bytes() + groom_.bytes() + paint_.bytes() + baseColor_.bytes() +
         groundShadow_[0].bytes() + groundShadow_[1].bytes() + strandTables_.bytes() + whiskers_.bytes() + drops_.bytes() + puddles_.bytes() + furShadow_.bytes() + small_.bytes();
}

std::size_t Renderer::takeUploadedBytes() { return std::exchange(uploadedBytes_, 0); }

}  // namespace fur::render
