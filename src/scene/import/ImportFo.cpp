#include <algorithm>
#include <cmath>

#include "core/NumberText.h"
#include "scene/FoModel.h"
#include "core/Sort.h"
#include "scene/import/CornerMesh.h"
#include "scene/import/Readers.h"
#include "scene/import/StatementReader.h"

namespace fur::scene {

namespace {

class FoReader {
 public:
  FoReader(Bytes bytes, const std::string& name) : reader_(bytes, name) {}

  FoModel run() {
    while (reader_.next()) {
      const std::string_view keyword = reader_.keyword();
      if (keyword == "v") readVertex();
      else if (keyword == "t") readTexcoord();
      else if (keyword == "p") readFace();
      else reader_.badWord("the statement", keyword, "is none of a .fo file: v, t and p are");
      reader_.expectEnd();
    }
    if (fo_.faces.empty()) reader_.bad("the file ends without a face");
    return std::move(fo_);
  }

 private:
  void readVertex() {
    reader_.checkRoom(fo_.positions.size(), kMaxVertices, "vertices");
    fo_.positions.push_back(reader_.position());
    Vec3 normal;
    for (int axis = 0; axis < 3; ++axis) normal[axis] = reader_.number("a normal's component");
    fo_.normals.push_back(normal);
    fo_.length.push_back(reader_.number("a fur length"));
    if (fo_.length.back() < 0.0f) reader_.bad("a fur length is below 0");
    fo_.furType.push_back(reader_.whole("a fur type"));
  }

  void readTexcoord() {
    reader_.checkRoom(fo_.texcoords.size(), kMaxVertices, "texture coordinates");
    float value[4];
    for (float& one : value) one = reader_.number("a texture coordinate");
    fo_.texcoords.push_back({{value[0], value[1]}, {value[2], value[3]}});
  }

  void readFace() {
    reader_.checkRoom(fo_.faces.size(), kMaxTriangles, "triangles");
    std::array<FoModel::Corner, 3> face;
    for (FoModel::Corner& corner : face) {
      const std::string_view whole = reader_.word();
      if (whole.empty()) reader_.bad("a face has fewer than 3 corners");
      std::string_view word = whole;
      std::int64_t vertex = 0, texcoord = 0;
      bool fits = StatementReader::takeWhole(word, vertex) && !word.empty() && word[0] == '/';
      if (fits) word.remove_prefix(1);
      fits = fits && StatementReader::takeWhole(word, texcoord) && word.empty();
      if (!fits) reader_.badWord("a face's corner", whole, "is not v/t");
      corner = {reader_.index(vertex, fo_.positions.size(), "vertex"),
                reader_.index(texcoord, fo_.texcoords.size(), "texture coordinate")};
    }
    fo_.faces.push_back(face);
  }

  StatementReader reader_;
  FoModel fo_;
};

template <class T>
bool varies(const std::vector<T>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<T>()) != values.end();
}

// Whether its types are Sheppard's: 1 to 3, and 4 for bald.
bool hasBaldType(const FoModel& fo) {
  return std::all_of(fo.furType.begin(), fo.furType.end(), [](int type) { return type >= 1 && type <= kFoBald; });
}

// Lengths of the file's vertices as shares of the longest, which goes to the model; nothing where they are all the same.
std::vector<float> sharesOf(const FoModel& fo, float scale, Model& model) {
  std::vector<float> shares = fo.length;
  const bool absolute = hasBaldType(fo);
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (absolute && fo.furType[i] == kFoBald) shares[i] = 0;
  const float longest = *std::max_element(shares.begin(), shares.end());
  if (absolute && longest > 0) model.furLength = longest * scale;
  if (!varies(shares) && longest > 0) return {};
  for (float& share : shares) share /= std::max(longest, 1e-30f);
  return shares;
}

void describeTypes(const FoModel& fo, const std::vector<std::uint32_t>& vertexOf, Model& model) {
  if (hasBaldType(fo)) {
    if (std::any_of(fo.furType.begin(), fo.furType.end(), [](int type) { return type == 2 || type == 3; }))
      for (const std::uint32_t vertex : vertexOf) model.fur.types.push_back(fo.furType[vertex] % kFoBald + (fo.furType[vertex] == kFoBald));
    return;
  }
  if (!varies(fo.furType)) return;
  std::vector<int> kinds = fo.furType;
  sortStably(kinds.begin(), kinds.end());
  kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
  for (const std::uint32_t vertex : vertexOf) {
    const auto kind = std::lower_bound(kinds.begin(), kinds.end(), fo.furType[vertex]) - kinds.begin();
    model.fur.types.push_back(1 + std::min(static_cast<int>(kind), groom::kTypes - 1));
  }
  if (kinds.size() > groom::kTypes)
    model.warnings.push_back(model.name + ": of " + decimal(kinds.size()) + " types of fur " +
                             decimal(groom::kTypes) + " are told apart");
}

// Normals of the surface at the file's vertices, by the angles of the faces there; of a vertex without any the file's.
std::vector<Vec3> surfaceNormals(const FoModel& fo) {
  std::vector<Vec3> normals(fo.positions.size(), Vec3(0));
  for (const auto& face : fo.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t corner) { return fo.positions[face[corner % 3].vertex]; };
      const Vec3 next = at(k + 1) - at(k), last = at(k + 2) - at(k), none(0);
      const float angle = std::acos(glm::clamp(glm::dot(normalizeOr(next, none), normalizeOr(last, none)), -1.0f, 1.0f));
      normals[face[k].vertex] += normalizeOr(glm::cross(next, last), none) * angle;
    }
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = normalizeOr(normals[i], fo.normals[i]);
  return normals;
}

// The comb whose hair has the directions of the file's normals, which become those of the surface; nothing where they are that.
std::vector<Vec3> takeComb(FoModel& fo) {
  constexpr float kCombed = 0.978f;  // cosine of 12 degrees
  const std::vector<Vec3> normals = surfaceNormals(fo);
  std::vector<Vec3> bends(normals.size(), Vec3(0));
  bool combed = false;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vec3 direction = normalizeOr(fo.normals[i], normals[i]);
    const float cosine = glm::clamp(glm::dot(direction, normals[i]), -1.0f, 1.0f);
    combed |= cosine < kCombed;
    // An arc leans by half of what its tip has turned.
    bends[i] = normalizeOr(direction - normals[i] * cosine, Vec3(0)) * std::min(2 * std::acos(cosine), groom::kMaxComb);
  }
  if (!combed) return {};
  fo.normals = normals;
  return bends;
}

}  // namespace

Result<FoModel> readFo(std::span<const std::uint8_t> bytes, const std::string& name) {
  return guardedImport<FoModel>(name, [&] { return FoReader(bytes, name).run(); });
}

void readFoFile(Bytes bytes, const FileSet&, Model& model) {
  FoModel fo = FoReader(bytes, model.name).run();
  CornerLists lists;
  for (const FoModel::Texcoord& t : fo.texcoords) lists.texcoords.emplace_back(t.colour.x, 1.0f - t.colour.y);
  for (const auto& face : fo.faces)
    for (const FoModel::Corner& corner : face)
      lists.corners.push_back({corner.vertex + 1, corner.texcoord + 1, corner.vertex + 1});
  const std::vector<Vec3> bends = takeComb(fo);
  lists.positions = std::move(fo.positions);
  lists.normals = std::move(fo.normals);
  const CornerWeld weld = buildMesh(lists, model);
  for (const std::uint32_t first : weld.cornerOf)
    model.mesh.furUv.push_back(usableTexcoord(fo.texcoords[lists.corners[first][1] - 1].fur));
  std::vector<std::uint32_t> vertexOf;  // of the file, one a vertex of the mesh
  for (const std::uint32_t first : weld.cornerOf) vertexOf.push_back(lists.corners[first][0] - 1);
  const std::vector<float> shares = sharesOf(fo, static_cast<float>(weld.scale), model);
  for (const std::uint32_t vertex : vertexOf) {
    if (!shares.empty()) model.fur.lengths.push_back(shares[vertex]);
    if (!bends.empty()) model.fur.comb.push_back(bends[vertex]);
  }
  describeTypes(fo, vertexOf, model);
}

}  // namespace fur::scene
