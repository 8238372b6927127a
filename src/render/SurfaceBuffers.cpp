#include "render/SurfaceBuffers.h"

#include <algorithm>
#include <cmath>

#include "core/Assert.h"
#include "geometry/Weld.h"
#include "shared/Blocks.h"

namespace fur::render {

namespace {

// What of a vertex stays when the skin moves; as shared/Blocks.h lists the attributes.
struct FurVertex {
  Vec4 uvAtlas, fur, atlasFromFur;
  Vec4 around;
  Vec3 leanRoom;
  Vec3 hessianS, hessianT;
};
static_assert(sizeof(FurVertex) == 25 * sizeof(float));

constexpr gl::Attribute kSkinAttributes[] = {
    {FUR_POSITION, 4, offsetof(SkinVertex, position)}, {FUR_NORMAL, 4, offsetof(SkinVertex, normal)},
    {FUR_GRAD_S, 4, offsetof(SkinVertex, gradS)},      {FUR_GRAD_T, 3, offsetof(SkinVertex, gradT)},
};
constexpr gl::Attribute kFurAttributes[] = {
    {FUR_UV_ATLAS, 4, offsetof(FurVertex, uvAtlas)}, {FUR_FUR_COORD, 4, offsetof(FurVertex, fur)},
    {FUR_ATLAS_FROM_FUR, 4, offsetof(FurVertex, atlasFromFur)}, {FUR_AROUND, 4, offsetof(FurVertex, around)},
    {FUR_LEAN, 3, offsetof(FurVertex, leanRoom)},       {FUR_HESSIAN_S, 3, offsetof(FurVertex, hessianS)},
    {FUR_HESSIAN_T, 3, offsetof(FurVertex, hessianT)},
};

constexpr gl::Attribute kOtherUv[] = {{FUR_OTHER_UV, 2, 0}};

// Few models have any.
gl::Buffer otherUvOf(const geometry::Surface& surface) {
  std::vector<Vec2> uv;
  for (const auto& v : surface.vertices) uv.push_back(v.otherUv);
  const bool any = std::any_of(uv.begin(), uv.end(), [](const Vec2& at) { return at != Vec2(0); });
  return any ? gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(uv), false) : gl::Buffer();
}

// FUR_AROUND: the middle of the largest triangle at that place, which is in its chart where the place may lie on a border.
std::vector<Vec3> findSurroundings(const geometry::Surface& surface) {
  const geometry::Weld weld = geometry::weldVertices(surface.vertices);
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
  std::vector<Vec3> around;
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) around.push_back(found[weld.idOf[i]]);
  return around;
}

}  // namespace

IndexRanges IndexRanges::sort(std::vector<std::uint32_t>& indices, std::span<const std::uint8_t> materialOfVertex) {
  IndexRanges ranges;
  if (materialOfVertex.empty()) {
    ranges.of.push_back({0, static_cast<int>(indices.size())});
    return ranges;
  }
  ranges.of.resize(256);
  for (std::size_t i = 0; i < indices.size(); i += 3) ranges.of[materialOfVertex[indices[i]]].count += 3;
  for (std::size_t m = 1; m < ranges.of.size(); ++m) ranges.of[m].first = ranges.of[m - 1].first + ranges.of[m - 1].count;
  std::vector<int> next;
  for (const Range& range : ranges.of) next.push_back(range.first);
  std::vector<std::uint32_t> sorted(indices.size());
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    int& at = next[materialOfVertex[indices[i]]];
    std::copy_n(&indices[i], 3, &sorted[static_cast<std::size_t>(at)]);
    at += 3;
  }
  indices = std::move(sorted);
  return ranges;
}

std::size_t SurfaceBuffers::set(const geometry::Surface& surface, std::span<const Vec3> tangents, std::span<const std::uint8_t> materials) {
  materials_.assign(materials.begin(), materials.end());
  std::vector<std::uint32_t> indices = surface.indices;
  ranges_ = IndexRanges::sort(indices, materials_);
  std::vector<SkinVertex> vertices;
  std::vector<FurVertex> furVertices;
  // Pictures lie on the atlas of a model that has no coordinates for them.
  const bool hasUv = std::any_of(surface.vertices.begin(), surface.vertices.end(), [](const auto& v) { return v.uv != Vec2(0); });
  for (const auto& v : surface.vertices) {
    vertices.push_back({Vec4(v.position, v.curvature.x), Vec4(v.normal, v.curvature.y), Vec4(v.gradS, v.curvature.z), v.gradT});
    furVertices.push_back({Vec4(hasUv ? v.uv : v.atlas, v.atlas), Vec4(v.fur, v.strands), v.atlasFromFur, {}, Vec3(v.lean, v.room), v.hessianS, v.hessianT});
  }
  surroundings_ = findSurroundings(surface);
  for (std::size_t i = 0; i < furVertices.size(); ++i) furVertices[i].around = Vec4(surroundings_[i], surface.turned ? 1.0f : 0.0f);
  vertices_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(vertices), !tangents.empty());
  furVertices_ = gl::Buffer(gl::BufferKind::Vertex, gl::bytesOf(furVertices), false);
  otherUv_ = otherUvOf(surface);
  indices_ = gl::Buffer(gl::BufferKind::Index, gl::bytesOf(indices), false);
  array_ = arrayOver(indices_);
  vertexCount_ = static_cast<int>(surface.vertices.size());
  indexCount_ = static_cast<int>(surface.indices.size());
  twoSided_ = surface.sheets;
  moving_.reset();
  if (!tangents.empty()) moving_.emplace(std::move(vertices), tangents, surface.indices);
  ++revision_;
  return bytes();
}

std::size_t SurfaceBuffers::follow(const Skin& skin) {
  FUR_ASSERT(moving_.has_value(), "SurfaceBuffers::follow()", "a surface with tangents", "one without");
  moving_->follow(skin);
  vertices_.update(std::as_bytes(moving_->vertices()));
  ++revision_;
  return vertices_.bytes();
}

void SurfaceBuffers::drawMaterial(std::size_t material) const {
  const IndexRanges::Range range = ranges_.at(material);
  if (range.count > 0) array_.drawIndexed(range.count, 1, range.first);
}

gl::VertexArray SurfaceBuffers::arrayOver(const gl::Buffer& indices) const {
  gl::VertexArray array(vertices_, sizeof(SkinVertex), kSkinAttributes, 0, &indices);
  array.add(furVertices_, sizeof(FurVertex), kFurAttributes, 0);
  if (otherUv_.bytes() > 0) array.add(otherUv_, sizeof(Vec2), kOtherUv, 0);
  return array;
}

gl::VertexArray SurfaceBuffers::instanceArray() const {
  return gl::VertexArray(vertices_, sizeof(SkinVertex), std::span(kSkinAttributes).first(2), 1, nullptr);
}

}  // namespace fur::render
