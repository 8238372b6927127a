#include <algorithm>
#include <cmath>

#include "geometry/AtlasUv.h"
#include "scene/Model.h"
#include "scene/Pose.h"
#include "scene/import/CornerMesh.h"
#include "scene/import/GltfAccessors.h"
#include "scene/import/GltfFile.h"
#include "scene/import/GltfFur.h"
#include "scene/import/GltfHair.h"
#include "scene/import/GltfMaterials.h"
#include "scene/import/GltfNodes.h"
#include "scene/import/GltfRig.h"
#include "scene/import/GltfSurface.h"
#include "scene/import/Readers.h"

namespace fur::scene {

namespace {

// Warnings of which a file could cause millions.
constexpr std::size_t kMaxWarnings = 20;
// A mesh may be placed by as many nodes as there are, and its primitives with it each time.
constexpr std::size_t kMaxPrimitives = 100'000;

class Importer {
 public:
  Importer(const GltfFile& file, Model& model) : file_(file), model_(model), materials_(file), rig_(file, model.rig) {}

  void run() {
    fur_ = readFur(file_, model_.fur);
    for (const std::string& warning : fur_.warnings) warn(warning);
    rigged_ = rig_.begin();
    for (const PlacedMesh& placed : placedMeshes(file_)) addMesh(placed);
    if (rigged_) placeSkins();
    if (model_.mesh.indices.empty()) file_.bad("there are no triangles in it");
    if (!anyTexcoords_) model_.mesh.uv.clear();
    if (!model_.mesh.otherUv.empty()) model_.mesh.otherUv.resize(model_.mesh.positions.size(), Vec2(0));
    model_.hasTexcoords = anyTexcoords_ && !missingTexcoords_;
    checkTexcoords();
    describeMaterials();
    model_.bounds = geometry::bounds(model_.mesh);
    const geometry::Fit fit = geometry::fitToUnitSphere(model_.mesh);
    model_.rig.centre = Vec3(fit.centre);
    model_.rig.scale = static_cast<float>(fit.scale);
    if (!model_.rig.moves()) model_.rig = {};
    placeFur(fit);
  }

 private:
  void warn(const std::string& text) {
    if (model_.warnings.size() < kMaxWarnings) model_.warnings.push_back(text);
  }

  void describeMaterials() {
    materials_.describe(model_);
    if (model_.materials.size() < 2) {
      model_.materialOf.clear();
      return;
    }
    if (!fur_.bare) return guessBare(model_.materials);
    for (Material& material : model_.materials) material.bare = std::find(fur_.bare->begin(), fur_.bare->end(), material.source) != fur_.bare->end();
  }

  // A skin stands where its joints are.
  void placeSkins() {
    if (model_.rig.skins.empty()) return;
    const Pose pose(model_.rig);
    for (const Rig::Part& part : model_.rig.parts)
      for (std::size_t i = part.firstVertex; part.skin >= 0 && i < part.firstVertex + part.vertices; ++i) {
        const Vec3& p = model_.mesh.positions[i] = pose.positions()[i];
        if (!(std::abs(p.x) < 1e38f && std::abs(p.y) < 1e38f && std::abs(p.z) < 1e38f)) file_.bad("a skin puts vertex %zu out of bounds", i);
        model_.mesh.normals[i] = pose.normals()[i];
      }
  }

  void addMesh(const PlacedMesh& placed) {
    const Json& mesh = file_.element("meshes", placed.mesh);
    const Json* primitives = mesh.find("primitives");
    if (!primitives || !primitives->isArray()) file_.bad("meshes[%llu] has no primitives", placed.mesh);
    std::size_t number = 0;
    for (const Json& primitive : *primitives) {
      const std::string name = formatted("meshes[%llu].primitives[%zu]", placed.mesh, number++);
      if (!primitive.isObject()) file_.bad("%s is not an object", name.c_str());
      if (++primitives_ > kMaxPrimitives)
        file_.fail(ErrorId::TooLarge, "its nodes place over %zu primitives, which is the limit", kMaxPrimitives);
      file_.expectFewKeys(primitive, name);
      addPrimitive(primitive, placed, name);
    }
  }

  void addPrimitive(const Json& primitive, const PlacedMesh& placed, const std::string& where) {
    const glm::dmat4& transform = placed.transform;
    const Whole mode = file_.whole(primitive, "mode", 4, where);
    if (mode > 6) file_.bad("%s.mode %llu is unknown", where.c_str(), mode);
    const Json* attributes = primitive.find("attributes");
    if (!attributes || !attributes->isObject()) file_.bad("%s has no attributes", where.c_str());
    file_.expectFewKeys(*attributes, where + ".attributes");
    if (mode < 4) return warn(where + " has points or lines; they are left out");
    if (!attributes->find("POSITION")) return warn(where + " has no positions; it is left out");

    geometry::Mesh part;
    readPositions(part, file_.whole(*attributes, "POSITION", where), transform, where);
    readTriangles(part, primitive, mode, transform, where);
    readNormals(part, *attributes, transform, where);
    const Whole material = materials_.of(primitive, where);
    readTexcoords(part, *attributes, material, where);
    const std::uint8_t number = materials_.count(material, part.triangleCount());
    model_.materialOf.resize(model_.mesh.positions.size() + part.positions.size(), number);
    readFurAttributes(*attributes, transform, part.positions.size(), where);
    if (rigged_) rig_.addPart(placed, primitive, std::move(local_), localNormals(part.normals, transform), where);
    append(part);
  }

  // Back to the space of the node; readNormals() has taken them out of it.
  static std::vector<Vec3> localNormals(const std::vector<Vec3>& normals, const glm::dmat4& transform) {
    const glm::dmat3 back = glm::transpose(glm::dmat3(transform));
    std::vector<Vec3> out;
    for (const Vec3& n : normals) out.push_back(normalizeOr(Vec3(glm::normalize(back * glm::dvec3(n))), Vec3(0, 1, 0)));
    return out;
  }

  void readPositions(geometry::Mesh& part, Whole accessor, const glm::dmat4& transform, const std::string& where) {
    const std::size_t total = model_.mesh.positions.size() + elementCount(file_, accessor);
    if (total > kMaxVertices) {
      file_.fail(ErrorId::TooLarge, "the model has over %zu vertices, which is the limit", kMaxVertices);
    }
    const std::vector<float> values = readFloats(file_, accessor, 3);
    part.positions.resize(values.size() / 3);
    local_.clear();
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
      const glm::dvec4 local(values[3 * i], values[3 * i + 1], values[3 * i + 2], 1.0);
      const Vec3 p = Vec3(transform * local);
      // Half of what float holds, so that differences of positions are finite too.
      if (!(std::abs(p.x) < 1e38f && std::abs(p.y) < 1e38f && std::abs(p.z) < 1e38f)) {
        file_.bad("%s: position %zu is not a finite number", where.c_str(), i);
      }
      part.positions[i] = p;
      if (rigged_) local_.emplace_back(local);
    }
  }

  void readTriangles(geometry::Mesh& part, const Json& primitive, Whole mode, const glm::dmat4& transform,
                     const std::string& where) {
    const bool indexed = primitive.find("indices") != nullptr;
    const Whole accessor = indexed ? file_.whole(primitive, "indices", where) : 0;
    const std::size_t count = indexed ? elementCount(file_, accessor) : part.positions.size();
    const std::size_t triangles = mode == 4 ? count / 3 : count < 3 ? 0 : count - 2;
    if (model_.mesh.triangleCount() + triangles > kMaxTriangles) {
      file_.fail(ErrorId::TooLarge, "the model has over %zu triangles, which is the limit", kMaxTriangles);
    }
    std::vector<std::uint32_t> corners;
    if (indexed) corners = readIndices(file_, accessor);
    for (std::uint32_t i = 0; !indexed && i < count; ++i) corners.push_back(i);
    for (const std::uint32_t corner : corners) {
      if (corner < part.positions.size()) continue;
      file_.bad("%s: index %u is past the %zu vertices", where.c_str(), corner, part.positions.size());
    }
    if (mode == 4 && count % 3 != 0) warn(formatted("%s: %zu indices are over", where.c_str(), count % 3));
    // A mirrored node turns its triangles inside out.
    const bool flip = glm::determinant(glm::dmat3(transform)) < 0.0;
    part.indices.reserve(triangles * 3);
    for (std::size_t t = 0; t < triangles; ++t) {
      const std::size_t a = mode == 4 ? 3 * t : mode == 5 ? t : 0;
      const std::size_t first = mode == 4 ? a + 1 : t + 1, second = first + 1;
      // glTF 2.0, 3.7.2.1: every other triangle of a strip is wound the other way round.
      const bool swap = flip != (mode == 5 && t % 2 == 1);
      part.indices.push_back(corners[a]);
      part.indices.push_back(corners[swap ? second : first]);
      part.indices.push_back(corners[swap ? first : second]);
    }
  }

  void readNormals(geometry::Mesh& part, const Json& attributes, const glm::dmat4& transform, const std::string& where) {
    geometry::computeNormals(part);
    if (!attributes.find("NORMAL")) return;
    const Whole accessor = file_.whole(attributes, "NORMAL", where);
    // Before they are read: few bytes of a file may ask for millions, at each of its primitives.
    if (elementCount(file_, accessor) != part.positions.size()) return warn(where + ": not one normal a vertex; they are computed");
    const std::vector<float> values = readFloats(file_, accessor, 3);
    // Cofactors: the inverse transpose but for a factor, and defined for flat transforms too.
    const glm::dmat3 m(transform);
    const double turn = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]) * turn, glm::cross(m[2], m[0]) * turn, glm::cross(m[0], m[1]) * turn);
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
      const glm::dvec3 n = cofactors * glm::dvec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
      const double squared = glm::dot(n, n);
      // A unit stays as it is, as a mesh that was fitted before does.
      if (squared > 1e-300 && squared < 1e300) part.normals[i] = Vec3(std::abs(squared - 1.0) < 1e-6 ? n : n / std::sqrt(squared));
    }
  }

  void readTexcoords(geometry::Mesh& part, const Json& attributes, Whole material, const std::string& where) {
    const bool read = readTexcoordSet(part.uv, part.positions.size(), attributes, materials_.texcoordUse(material), where);
    (read ? anyTexcoords_ : missingTexcoords_) = true;
    if (const auto other = materials_.otherSet(material)) readTexcoordSet(part.otherUv, part.positions.size(), attributes, {.set = *other}, where);
  }

  // Zero where there are none; whether there are.
  bool readTexcoordSet(std::vector<Vec2>& uv, std::size_t vertices, const Json& attributes, const TexcoordUse& use, const std::string& where) {
    uv.assign(vertices, Vec2(0.0f));
    const std::string key = formatted("TEXCOORD_%llu", use.set);
    if (!attributes.find(key)) return false;
    const Whole accessor = file_.whole(attributes, key.c_str(), where);
    if (elementCount(file_, accessor) != vertices) return warn(where + ": not one texture coordinate a vertex; they are left out"), false;
    const std::vector<float> values = readFloats(file_, accessor, 2);
    for (std::size_t i = 0; i < uv.size(); ++i) uv[i] = usableTexcoord(Vec2(use.transform * Vec3(values[2 * i], values[2 * i + 1], 1.0f)));
    return true;
  }

  // The values of an attribute that only we know; none where the primitive has none.
  std::vector<float> ownValues(const Json& attributes, const std::string& name, int components, std::size_t vertices,
                               const std::string& where) {
    if (!attributes.find(name)) return {};
    const Whole accessor = file_.whole(attributes, name.c_str(), where);
    if (elementCount(file_, accessor) != vertices) file_.bad("%s: not one %s a vertex", where.c_str(), name.c_str());
    return readFloats(file_, accessor, components);
  }

  // Zero where a primitive has none; nothing is added for a file without.
  void readOwn(std::vector<Vec2>& all, const Json& attributes, const std::string& name, std::size_t vertices,
               const std::string& where) {
    const std::vector<float> values = ownValues(attributes, name, 2, vertices, where);
    if (!values.empty()) all.resize(model_.mesh.positions.size(), Vec2(0));
    for (std::size_t i = 0; i < values.size(); i += 2) all.emplace_back(values[i], values[i + 1]);
  }

  void readFurAttributes(const Json& attributes, const glm::dmat4& transform, std::size_t vertices, const std::string& where) {
    if (!fur_.present) return;
    if (fur_.hasMap && !fur_.surface) readOwn(model_.mesh.atlas, attributes, formatted("TEXCOORD_%llu", fur_.atlasSet), vertices, where);
    readOwn(model_.mesh.furUv, attributes, "_WETFUR_TILE", vertices, where);
    if (fur_.surface) return;
    const std::vector<float> combs = ownValues(attributes, "_WETFUR_COMB", 3, vertices, where);
    if (!combs.empty()) model_.fur.comb.resize(model_.mesh.positions.size(), Vec3(0));
    for (std::size_t i = 0; i < combs.size(); i += 3) {
      const Vec3 comb(combs[i], combs[i + 1], combs[i + 2]);
      // An angle stays what it is under a scale.
      model_.fur.comb.push_back(normalizeOr(Mat3(transform) * comb, Vec3(0)) * glm::length(comb));
    }
  }

  // All primitives have them, or none counts; a map needs coordinates of its own for every point.
  void checkTexcoords() {
    geometry::Mesh& mesh = model_.mesh;
    if (!mesh.furUv.empty()) mesh.furUv.resize(mesh.positions.size(), Vec2(0));
    for (Vec2& uv : mesh.furUv) uv = usableTexcoord(uv);
    if (!model_.fur.comb.empty()) model_.fur.comb.resize(mesh.positions.size(), Vec3(0));
    if (!fur_.hasMap || fur_.surface) return;
    geometry::Mesh flat;
    flat.positions = mesh.positions;
    flat.uv = mesh.atlas;
    if (flat.uv.size() == flat.positions.size() && geometry::isUniqueAtlas(flat, mesh.indices)) return;
    leaveOutFur("their texture coordinates are missing, overlap or lie outside of the map");
  }

  void leaveOutFur(const char* why) {
    model_.mesh.atlas.clear();
    FurData kept;
    kept.state = std::move(model_.fur.state);
    kept.comb = std::move(model_.fur.comb);
    kept.isLying = model_.fur.isLying;
    kept.coats = std::move(model_.fur.coats);
    if (!fur_.surface) kept.whiskers = std::move(model_.fur.whiskers);
    model_.fur = std::move(kept);
    warn(std::string("groom, wetness and hair are left out: ") + why);
  }

  // The mesh has been fitted. On a document everything is in model space.
  void placeFur(const geometry::Fit& fit) {
    const bool onDocument = fur_.surface != nullptr;
    if (onDocument && !readSurface(file_, *fur_.surface, model_)) leaveOutFur("the model is another than when they were saved");
    for (groom::Whisker& whisker : model_.fur.whiskers)
      if (!onDocument) whisker.root = fit.of(whisker.root);
    if (!hairReader()) return;
    hairReader()->fit(file_, model_.fur.hair, onDocument ? geometry::Fit{glm::dvec3(0), 1} : fit);
    for (hair::Body& body : model_.fur.hair.bodies) body.bone = boneOf(body.bone);
  }

  // Of a node of the file.
  std::int32_t boneOf(std::int32_t node) const {
    const auto& nodes = model_.rig.nodes;
    for (std::size_t i = 0; node >= 0 && i < nodes.size(); ++i)
      if (nodes[i].source == static_cast<std::uint32_t>(node)) return static_cast<std::int32_t>(i);
    return -1;
  }

  void append(const geometry::Mesh& part) {
    geometry::Mesh& mesh = model_.mesh;
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
    if (!part.otherUv.empty()) mesh.otherUv.resize(base, Vec2(0));
    mesh.otherUv.insert(mesh.otherUv.end(), part.otherUv.begin(), part.otherUv.end());
    mesh.uv.insert(mesh.uv.end(), part.uv.begin(), part.uv.end());
    for (const std::uint32_t index : part.indices) mesh.indices.push_back(base + index);
  }

  const GltfFile& file_;
  Model& model_;
  GltfMaterials materials_;
  GltfRig rig_;
  std::vector<Vec3> local_;  // positions of the primitive that is read, in the space of its node
  GltfFur fur_;
  std::size_t primitives_ = 0;
  bool rigged_ = false, anyTexcoords_ = false, missingTexcoords_ = false;
};

}  // namespace

void readGltf(Bytes bytes, const FileSet& others, Model& model) {
  const GltfFile file(bytes, model.name, others);
  Importer(file, model).run();
  model.isGltf = true;
}

}  // namespace fur::scene
