#include <string>

#include "scene/Model.h"
#include "scene/import/CornerMesh.h"
#include "scene/import/Readers.h"
#include "scene/import/StatementReader.h"

namespace fur::scene {

namespace {

class ObjReader {
 public:
  ObjReader(Bytes bytes, Model& model) : reader_(bytes, model.name), model_(model) {}

  void run() {
    while (reader_.next()) readStatement();
    if (lists_.corners.empty()) reader_.bad("the file ends without a face");
    buildMesh(std::move(lists_), model_);
  }

 private:
  void readStatement() {
    const std::string_view keyword = reader_.keyword();
    if (keyword == "v") readPosition();
    else if (keyword == "vt") readTexcoord();
    else if (keyword == "vn") readNormal();
    else if (keyword == "f") readFace();
    else if (keyword == "mtllib" || keyword == "usemtl") warnOnce(kMaterials, "its materials are left out");
    else if (keyword == "p" || keyword == "l") warnOnce(kPoints, "its points and lines are left out");
    else if (keyword != "o" && keyword != "g" && keyword != "s")
      warnOnce(kOthers, "what is no part of a mesh is left out");
  }

  enum Kind { kMaterials, kPoints, kOthers, kKinds };
  void warnOnce(Kind kind, const char* text) {
    if (!warned_[kind]) model_.warnings.push_back(model_.name + ": " + text);
    warned_[kind] = true;
  }

  // A fourth coordinate, or the colour that some programs write here, is left unread.
  void readPosition() {
    reader_.checkRoom(lists_.positions.size(), kMaxVertices, "vertices");
    lists_.positions.push_back(reader_.position());
  }

  void readTexcoord() {
    reader_.checkRoom(lists_.texcoords.size(), kMaxVertices, "texture coordinates");
    const float u = reader_.number("the u of a texture coordinate");
    const float v = reader_.number("the v of a texture coordinate");
    lists_.texcoords.emplace_back(u, 1.0f - v);
  }

  void readNormal() {
    reader_.checkRoom(lists_.normals.size(), kMaxVertices, "normals");
    const float x = reader_.number("the x of a normal"), y = reader_.number("the y of a normal");
    lists_.normals.emplace_back(x, y, reader_.number("the z of a normal"));
  }

  void readFace() {
    Corner first{}, last{};
    std::size_t count = 0;
    for (std::string_view word = reader_.word(); !word.empty(); word = reader_.word(), ++count) {
      const Corner corner = readCorner(word);
      if (count == 0) first = corner;
      if (count >= 2) {
        reader_.checkRoom(lists_.corners.size() / 3, kMaxTriangles, "triangles");
        lists_.corners.insert(lists_.corners.end(), {first, last, corner});
      }
      last = corner;
    }
    if (count < 3) reader_.bad("a face has %zu corners; it needs 3", count);
  }

  // v, v/t, v//n or v/t/n.
  Corner readCorner(std::string_view word) {
    const std::string_view whole = word;
    const std::size_t counts[3] = {lists_.positions.size(), lists_.texcoords.size(), lists_.normals.size()};
    const char* const names[3] = {"vertex", "texture coordinate", "normal"};
    Corner corner{};
    for (std::size_t list = 0; list < 3; ++list) {
      std::int64_t number;
      if (StatementReader::takeWhole(word, number)) {
        // A relative number counts back from the newest: -1. One that leads before the first is told as
        // it was written.
        const std::int64_t absolute = number < 0 ? number + static_cast<std::int64_t>(counts[list]) + 1 : number;
        corner[list] = reader_.index(absolute > 0 ? absolute : number, counts[list], names[list]) + 1;
      } else if (list == 0) {
        break;
      }
      if (word.empty()) return corner;
      if (word[0] != '/') break;
      word.remove_prefix(1);
    }
    reader_.badWord("a face's corner", whole, "is none of v, v/t, v//n and v/t/n");
  }

  StatementReader reader_;
  Model& model_;
  CornerLists lists_;
  bool warned_[kKinds] = {};
};

}  // namespace

void readObjFile(Bytes bytes, const FileSet&, Model& model) { ObjReader(bytes, model).run(); }

}  // namespace fur::scene
