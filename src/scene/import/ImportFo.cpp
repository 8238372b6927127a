#include <algorithm>

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

// Lengths and types of the mesh's vertices; nothing where they are all the same.
void describeFur(const FoModel& fo, const CornerLists& lists, const CornerWeld& weld, Model& model) {
  const auto vertexOf = [&](std::uint32_t corner) { return lists.corners[corner][0] - 1; };
  if (varies(fo.length)) {
    const float longest = *std::max_element(fo.length.begin(), fo.length.end());
    for (const std::uint32_t first : weld.cornerOf) model.fur.lengths.push_back(fo.length[vertexOf(first)] / longest);
  }
  if (!varies(fo.furType)) return;
  std::vector<int> kinds = fo.furType;
  sortStably(kinds.begin(), kinds.end());
  kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
  for (const std::uint32_t first : weld.cornerOf) {
    const auto kind = std::lower_bound(kinds.begin(), kinds.end(), fo.furType[vertexOf(first)]) - kinds.begin();
    model.fur.types.push_back(1 + std::min(static_cast<int>(kind), groom::kTypes - 1));
  }
  if (kinds.size() > groom::kTypes)
    model.warnings.push_back(model.name + ": of " + std::to_string(kinds.size()) + " types of fur " +
                             std::to_string(groom::kTypes) + " are told apart");
}

}  // namespace

Result<FoModel> readFo(std::span<const std::uint8_t> bytes, const std::string& name) {
  return guardedImport<FoModel>(name, [&] { return FoReader(bytes, name).run(); });
}

void readFo(Bytes bytes, const FileSet&, Model& model) {
  FoModel fo = FoReader(bytes, model.name).run();
  CornerLists lists;
  for (const FoModel::Texcoord& t : fo.texcoords) lists.texcoords.emplace_back(t.colour.x, 1.0f - t.colour.y);
  for (const auto& face : fo.faces)
    for (const FoModel::Corner& corner : face)
      lists.corners.push_back({corner.vertex + 1, corner.texcoord + 1, corner.vertex + 1});
  lists.positions = std::move(fo.positions);
  lists.normals = std::move(fo.normals);
  const CornerWeld weld = buildMesh(lists, model);
  for (const std::uint32_t first : weld.cornerOf)
    model.mesh.furUv.push_back(usableTexcoord(fo.texcoords[lists.corners[first][1] - 1].fur));
  describeFur(fo, lists, weld, model);
}

}  // namespace fur::scene
