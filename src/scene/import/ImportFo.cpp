#include <algorithm>

#include "scene/FoModel.h"
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

}  // namespace

Result<FoModel> readFo(std::span<const std::uint8_t> bytes, const std::string& name) {
  return guardedImport<FoModel>(name, [&] { return FoReader(bytes, name).run(); });
}

void readFo(Bytes bytes, Model& model) {
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
  if (varies(fo.length) || varies(fo.furType))
    model.warnings.push_back(model.name + ": fur of several lengths or types is not drawn yet");
}

}  // namespace fur::scene
