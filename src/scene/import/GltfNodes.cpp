#include "scene/import/GltfNodes.h"

#include <algorithm>
#include <cstdint>

namespace fur::scene {

namespace {

glm::dmat4 localTransform(const GltfFile& file, const Json& node, const std::string& where) {
  float matrix[16];
  if (file.numbers(node, "matrix", matrix, 16, where)) {
    glm::dmat4 out(1.0);
    for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = matrix[i];
    return out;
  }
  float t[3] = {0, 0, 0}, r[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
  file.numbers(node, "translation", t, 3, where);
  file.numbers(node, "rotation", r, 4, where);
  file.numbers(node, "scale", s, 3, where);
  const double x = r[0], y = r[1], z = r[2], w = r[3];
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  const glm::dquat rotation = length > 0.0 ? glm::dquat(w / length, x / length, y / length, z / length) : glm::dquat(1, 0, 0, 0);
  return glm::translate(glm::dmat4(1.0), glm::dvec3(t[0], t[1], t[2])) * glm::mat4_cast(rotation) *
         glm::scale(glm::dmat4(1.0), glm::dvec3(s[0], s[1], s[2]));
}

// The node numbers in an array such as `children`.
std::vector<Whole> nodeList(const GltfFile& file, const Json& object, const char* key, const std::string& where) {
  std::vector<Whole> out;
  const Json* list = object.find(key);
  if (!list) return out;
  if (!list->isArray()) file.bad("%s.%s is not an array", where.c_str(), key);
  const std::size_t nodes = file.count("nodes");
  for (const Json& entry : *list) {
    const double value = entry.number();
    if (!(value >= 0.0 && value < static_cast<double>(nodes) && value == std::floor(value))) {
      file.bad("%s.%s names a node that does not exist", where.c_str(), key);
    }
    out.push_back(static_cast<Whole>(value));
  }
  return out;
}

std::vector<Whole> rootsOfAllNodes(const GltfFile& file) {
  std::vector<std::uint8_t> isChild(file.count("nodes"));
  for (Whole node = 0; node < isChild.size(); ++node) {
    const std::string where = formatted("nodes[%llu]", node);
    for (const Whole child : nodeList(file, file.element("nodes", node), "children", where)) {
      isChild[static_cast<std::size_t>(child)] = true;
    }
  }
  std::vector<Whole> roots;
  for (Whole node = 0; node < isChild.size(); ++node) {
    if (!isChild[static_cast<std::size_t>(node)]) roots.push_back(node);
  }
  return roots;
}

std::vector<Whole> rootsOf(const GltfFile& file) {
  if (file.count("scenes") == 0) return rootsOfAllNodes(file);
  const Whole scene = file.whole(file.json(), "scene", 0, "the file");
  return nodeList(file, file.element("scenes", scene), "nodes", formatted("scenes[%llu]", scene));
}

}  // namespace

std::vector<Whole> childrenOf(const GltfFile& file, Whole node) {
  return nodeList(file, file.element("nodes", node), "children", formatted("nodes[%llu]", node));
}

std::vector<PlacedMesh> placedMeshes(const GltfFile& file) {
  std::vector<PlacedMesh> placed;
  if (file.count("nodes") == 0) {
    for (Whole mesh = 0; mesh < file.count("meshes"); ++mesh) placed.push_back({mesh, glm::dmat4(1.0), 0, kNoSkin});
    return placed;
  }
  struct Visit { Whole node; glm::dmat4 parent; };
  std::vector<Visit> stack;
  std::vector<std::uint8_t> seen(file.count("nodes"));
  // Last in, first out: children are pushed back to front to keep their order.
  const auto push = [&](std::vector<Whole> nodes, const glm::dmat4& parent) {
    std::reverse(nodes.begin(), nodes.end());
    for (const Whole node : nodes) {
      if (seen[static_cast<std::size_t>(node)]) {
        file.bad("nodes[%llu] is reached twice: a cycle, or two parents", node);
      }
      seen[static_cast<std::size_t>(node)] = true;
      stack.push_back({node, parent});
    }
  };
  push(rootsOf(file), glm::dmat4(1.0));
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const std::string where = formatted("nodes[%llu]", visit.node);
    const Json& node = file.element("nodes", visit.node);
    const glm::dmat4 transform = visit.parent * localTransform(file, node, where);
    if (node.find("mesh")) {
      const Whole skin = file.whole(node, "skin", kNoSkin, where);
      placed.push_back({file.whole(node, "mesh", where), skin == kNoSkin ? transform : glm::dmat4(1.0), visit.node, skin});
    }
    push(nodeList(file, node, "children", where), transform);
  }
  return placed;
}

}  // namespace fur::scene
