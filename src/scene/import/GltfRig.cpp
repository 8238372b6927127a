#include "scene/import/GltfRig.h"

#include <algorithm>
#include <cmath>

#include "scene/import/GltfAccessors.h"

namespace fur::scene {

namespace {

// Of all that moves: a few bytes of a file may ask for gigabytes of zeros.
constexpr std::size_t kMaxRigFloats = 64'000'000;
constexpr std::size_t kMaxJoints = 4096, kMaxTargets = 256, kMaxAnimations = 256, kMaxNodes = 65'536;

bool isFinite(const std::vector<float>& values) {
  for (const float value : values)
    if (!(std::abs(value) <= 1e30f)) return false;
  return true;
}

}  // namespace

GltfRig::GltfRig(const GltfFile& file, Rig& rig) : file_(file), rig_(rig) {}

std::vector<float> GltfRig::floats(Whole accessor, int components) {
  floats_ += elementCount(file_, accessor) * static_cast<std::size_t>(components);
  atMost(kMaxRigFloats, floats_, "numbers");
  std::vector<float> values = readFloats(file_, accessor, components);
  if (!isFinite(values)) file_.bad("accessors[%llu] holds something that is not a finite number", accessor);
  return values;
}

void GltfRig::atMost(std::size_t limit, std::size_t count, const char* what) const {
  if (count > limit) file_.fail(ErrorId::TooLarge, "%zu %s of a model that moves; the limit is %zu", count, what, limit);
}

bool GltfRig::begin() {
  if (file_.count("nodes") == 0 || (file_.count("skins") == 0 && file_.count("animations") == 0)) return false;
  readNodes();
  readSkins();
  readAnimations();
  return true;
}

void GltfRig::readNodes() {
  const std::size_t count = file_.count("nodes");
  atMost(kMaxNodes, count, "nodes");
  std::vector<std::vector<Whole>> children(count);
  std::vector<int> parents(count, -1);
  for (Whole i = 0; i < count; ++i) {
    children[i] = childrenOf(file_, i);
    for (const Whole child : children[i]) {
      if (parents[child] >= 0) file_.bad("nodes[%llu] has two parents", child);
      parents[child] = static_cast<int>(i);
    }
  }
  // Parents first.
  constexpr std::uint32_t kNowhere = ~0u;
  nodeOf_.assign(count, kNowhere);
  std::vector<Whole> order;
  for (Whole i = 0; i < count; ++i)
    if (parents[i] < 0) order.push_back(i);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Whole index = order[k];
    nodeOf_[index] = static_cast<std::uint32_t>(k);
    for (const Whole child : children[index]) order.push_back(child);
    Rig::Node node;
    node.source = static_cast<std::uint32_t>(index);
    node.parent = parents[index] < 0 ? -1 : static_cast<int>(nodeOf_[static_cast<std::size_t>(parents[index])]);
    const Json& json = file_.element("nodes", index);
    const std::string where = formatted("nodes[%llu]", index);
    if (const Json* name = json.find("name")) node.name = name->text();
    float m[16], r[4] = {0, 0, 0, 1};
    if (file_.numbers(json, "matrix", m, 16, where)) {
      node.fixed = true;
      for (int i = 0; i < 16; ++i) node.matrix[i / 4][i % 4] = m[i];
    }
    file_.numbers(json, "translation", &node.translation.x, 3, where);
    file_.numbers(json, "scale", &node.scale.x, 3, where);
    file_.numbers(json, "rotation", r, 4, where);
    const float length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    if (length > 1e-12f && length < 1e18f) node.rotation = Quat(r[3] / length, r[0] / length, r[1] / length, r[2] / length);
    rig_.nodes.push_back(std::move(node));
  }
  if (order.size() != count) file_.bad("nodes are children of themselves");
}

void GltfRig::readSkins() {
  for (Whole i = 0; i < file_.count("skins"); ++i) {
    const std::string where = formatted("skins[%llu]", i);
    const Json& json = file_.element("skins", i);
    Rig::Skin skin;
    if (const Json* joints = json.find("joints"); joints && joints->isArray())
      for (const Json& joint : *joints) {
        const double value = joint.number();
        if (!(value >= 0 && value < static_cast<double>(nodeOf_.size()) && value == std::floor(value)))
          file_.bad("%s.joints names a node that does not exist", where.c_str());
        skin.joints.push_back(nodeOf_[static_cast<std::size_t>(value)]);
      }
    if (skin.joints.empty()) file_.bad("%s has no joints", where.c_str());
    atMost(kMaxJoints, skin.joints.size(), "joints of a skin");
    skin.inverseBinds.assign(skin.joints.size(), Mat4(1));
    if (json.find("inverseBindMatrices")) {
      const std::vector<float> values = floats(file_.whole(json, "inverseBindMatrices", where), 16);
      if (values.size() < 16 * skin.joints.size()) file_.bad("%s: not one inverse bind matrix a joint", where.c_str());
      for (std::size_t k = 0; k < 16 * skin.joints.size(); ++k)
        skin.inverseBinds[k / 16][static_cast<int>(k % 16 / 4)][static_cast<int>(k % 4)] = values[k];
    }
    rig_.skins.push_back(std::move(skin));
  }
}

void GltfRig::readAnimations() {
  // Weights first: what their channels write to.
  for (Whole i = 0; i < nodeOf_.size(); ++i) {
    const Json& json = file_.element("nodes", i);
    if (!json.find("mesh")) continue;
    const std::string where = formatted("nodes[%llu]", i);
    const Whole index = file_.whole(json, "mesh", where);
    const Json& mesh = file_.element("meshes", index);
    const Json* primitives = mesh.find("primitives");
    std::size_t targets = 0;
    if (primitives && primitives->isArray() && primitives->begin() != primitives->end())
      if (const Json* list = (*primitives->begin()).find("targets"))
        targets = list->isArray() ? list->count() : 0;
    atMost(kMaxTargets, targets, "morph targets of a mesh");
    Rig::Node& node = rig_.nodes[nodeOf_[i]];
    node.firstWeight = static_cast<std::uint32_t>(rig_.restWeights.size());
    node.weights = static_cast<std::uint32_t>(targets);
    std::vector<float> rest(targets, 0.0f);
    if (targets > 0 && !file_.numbers(json, "weights", rest.data(), targets, where))
      file_.numbers(mesh, "weights", rest.data(), targets, formatted("meshes[%llu]", index));
    rig_.restWeights.insert(rig_.restWeights.end(), rest.begin(), rest.end());
  }
  atMost(kMaxAnimations, file_.count("animations"), "animations");
  for (Whole i = 0; i < file_.count("animations"); ++i) {
    const std::string where = formatted("animations[%llu]", i);
    const Json& json = file_.element("animations", i);
    const Json* channels = json.find("channels");
    if (!channels || !channels->isArray()) file_.bad("%s has no channels", where.c_str());
    std::vector<const Json*> samplers;
    if (const Json* list = json.find("samplers"); list && list->isArray())
      for (const Json& one : *list) samplers.push_back(&one);
    Rig::Animation animation;
    if (const Json* name = json.find("name")) animation.name = name->text();
    std::replace(animation.name.begin(), animation.name.end(), '\n', ' ');
    for (const Json& channel : *channels) {
      if (!channel.isObject()) file_.bad("%s holds a channel that is not an object", where.c_str());
      readChannel(samplers, channel, animation, where);
    }
    if (animation.duration > 0) rig_.animations.push_back(std::move(animation));
  }
}

void GltfRig::readChannel(const std::vector<const Json*>& samplers, const Json& json, Rig::Animation& out, const std::string& where) {
  const Json* target = json.find("target");
  if (!target || !target->isObject()) file_.bad("%s has a channel without a target", where.c_str());
  if (!target->find("node")) return;  // of an extension that we do not read
  const Whole node = file_.whole(*target, "node", where), wanted = file_.whole(json, "sampler", where);
  if (node >= nodeOf_.size()) file_.bad("%s moves a node that does not exist", where.c_str());
  if (wanted >= samplers.size() || !samplers[wanted]->isObject()) file_.bad("%s uses a sampler that does not exist", where.c_str());
  const Json* sampler = samplers[static_cast<std::size_t>(wanted)];
  file_.expectFewKeys(*sampler, where + ".samplers");

  Rig::Channel channel;
  channel.node = nodeOf_[static_cast<std::size_t>(node)];
  const Json* path = target->find("path");
  const std::string name = path ? path->text() : "";
  // In the order of scene::Path.
  static constexpr const char* kPaths[] = {"translation", "rotation", "scale", "weights"};
  const auto found = std::find(std::begin(kPaths), std::end(kPaths), name);
  if (found == std::end(kPaths)) return;
  channel.path = static_cast<Path>(found - std::begin(kPaths));
  const bool weights = channel.path == Path::Weights;
  channel.width = weights ? rig_.nodes[channel.node].weights : channel.path == Path::Rotation ? 4 : 3;
  if (channel.width == 0) return;
  const Json* interpolation = sampler->find("interpolation");
  const std::string manner = interpolation ? interpolation->text() : "LINEAR";
  if (manner == "STEP") channel.interpolation = Interpolation::Step;
  else if (manner == "CUBICSPLINE") channel.interpolation = Interpolation::Cubic;
  else if (manner != "LINEAR") file_.bad("%s: the interpolation %.20s is unknown", where.c_str(), manner.c_str());
  channel.times = floats(file_.whole(*sampler, "input", where), 1);
  for (std::size_t k = 0; k < channel.times.size(); ++k)
    if (channel.times[k] < (k ? channel.times[k - 1] : 0.0f)) file_.bad("%s: times do not ascend", where.c_str());
  channel.values = floats(file_.whole(*sampler, "output", where), weights ? 1 : static_cast<int>(channel.width));
  const std::size_t values = channel.times.size() * channel.width * (channel.interpolation == Interpolation::Cubic ? 3 : 1);
  if (channel.times.empty() || channel.values.size() != values)
    file_.bad("%s: not one value a time of the channel %s", where.c_str(), name.c_str());
  out.duration = std::max(out.duration, channel.times.back());
  out.channels.push_back(std::move(channel));
}

void GltfRig::readJoints(const Json& attributes, std::size_t joints, std::size_t vertices, const std::string& where) {
  const std::size_t first = rig_.positions.size() - vertices;
  rig_.joints.resize(first);
  rig_.weights.resize(first, Vec4(1, 0, 0, 0));
  if (joints > 0 && attributes.find("JOINTS_0") && attributes.find("WEIGHTS_0")) {
    const std::vector<float> numbers = floats(file_.whole(attributes, "JOINTS_0", where), 4);
    const std::vector<float> shares = floats(file_.whole(attributes, "WEIGHTS_0", where), 4);
    if (numbers.size() != 4 * vertices || shares.size() != 4 * vertices)
      file_.bad("%s: not four joints and weights a vertex", where.c_str());
    for (std::size_t i = 0; i < vertices; ++i) {
      std::array<std::uint16_t, 4> of{};
      Vec4 weights(0);
      int used = 0;
      for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
        if (!(shares[k] > 0)) continue;
        if (!(numbers[k] >= 0 && numbers[k] < static_cast<float>(joints)))
          file_.bad("%s: vertex %zu hangs on a joint that its skin does not have", where.c_str(), i);
        of[static_cast<std::size_t>(used)] = static_cast<std::uint16_t>(numbers[k]);
        weights[used++] = shares[k];
      }
      const float sum = weights.x + weights.y + weights.z + weights.w;
      rig_.joints.push_back(of);
      rig_.weights.push_back(sum > 0 ? weights / sum : Vec4(1, 0, 0, 0));
    }
  }
  rig_.joints.resize(rig_.positions.size());
  rig_.weights.resize(rig_.positions.size(), Vec4(1, 0, 0, 0));
}

void GltfRig::readTargets(const Json& primitive, Rig::Part& part, const std::string& where) {
  const Json* targets = primitive.find("targets");
  if (!targets) return;
  const std::uint32_t known = rig_.nodes[part.node].weights;
  if (!targets->isArray() || targets->count() != known) file_.bad("%s: its mesh has another number of morph targets", where.c_str());
  part.targets = known;
  part.firstDelta = rig_.deltas.size();
  for (const Json& target : *targets) {
    if (!target.isObject()) file_.bad("%s: a morph target is not an object", where.c_str());
    floats_ += 6 * std::size_t{part.vertices};
    atMost(kMaxRigFloats, floats_, "numbers");
    const std::size_t first = rig_.deltas.size();
    rig_.deltas.resize(first + 2 * std::size_t{part.vertices}, Vec3(0));
    for (const bool normals : {false, true}) {
      const char* name = normals ? "NORMAL" : "POSITION";
      if (!target.find(name)) continue;
      const std::vector<float> values = floats(file_.whole(target, name, where), 3);
      if (values.size() != 3 * std::size_t{part.vertices}) file_.bad("%s: a morph target has not one %s a vertex", where.c_str(), name);
      for (std::size_t k = 0; k < values.size(); ++k)
        rig_.deltas[first + k / 3 * 2 + normals][static_cast<int>(k % 3)] = values[k];
    }
  }
}

void GltfRig::addPart(const PlacedMesh& placed, const Json& primitive, std::vector<Vec3> positions, std::vector<Vec3> normals,
                      const std::string& where) {
  Rig::Part part;
  part.firstVertex = static_cast<std::uint32_t>(rig_.positions.size());
  part.vertices = static_cast<std::uint32_t>(positions.size());
  part.node = nodeOf_[static_cast<std::size_t>(placed.node)];
  if (placed.skin != kNoSkin) {
    if (placed.skin >= rig_.skins.size()) file_.bad("%s: its skin does not exist", where.c_str());
    part.skin = static_cast<int>(placed.skin);
  }
  rig_.positions.insert(rig_.positions.end(), positions.begin(), positions.end());
  rig_.normals.insert(rig_.normals.end(), normals.begin(), normals.end());
  const Json& attributes = *primitive.find("attributes");
  readJoints(attributes, part.skin < 0 ? 0 : rig_.skins[static_cast<std::size_t>(part.skin)].joints.size(), part.vertices, where);
  readTargets(primitive, part, where);
  rig_.parts.push_back(part);
}

}  // namespace fur::scene
