// A tube along y that its joints wave, and whose second target swells it: a .glb with a skin, two morph targets, and two
// animations, "wave" and "swell".
#pragma once

#include <cmath>
#include <string>

#include "core/Math.h"
#include "scene/GltfBuilder.h"

namespace fur::scene {

struct Tentacle {
  int around = 12, along = 16, joints = 4;
  std::vector<float> positions, normals, weights, swell, swellNormals;
  std::vector<std::uint8_t> jointsOf;
  std::vector<std::uint16_t> indices;
  // Parts of the JSON that tests replace.
  std::string skin, animations, targets = R"(,"targets":[{"POSITION":9},{"POSITION":9,"NORMAL":10}])", attributes;

  Tentacle() {
    for (int j = 0; j <= along; ++j)
      for (int i = 0; i < around; ++i) {
        const float a = 2 * kPi * static_cast<float>(i) / static_cast<float>(around), y = static_cast<float>(j) / static_cast<float>(along);
        const Vec3 out(std::cos(a), 0, std::sin(a));
        for (const float v : {0.1f * out.x, y, 0.1f * out.z}) positions.push_back(v);
        for (const float v : {out.x, 0.0f, out.z}) normals.push_back(v);
        const float bulge = 0.1f * std::sin(kPi * y);
        for (const float v : {bulge * out.x, 0.0f, bulge * out.z}) swell.push_back(v);
        for (const float v : {0.0f, -0.1f * kPi * std::cos(kPi * y), 0.0f}) swellNormals.push_back(v);
        const float at = y * static_cast<float>(joints - 1);
        const int first = std::min(static_cast<int>(at), joints - 2);
        const float share = at - static_cast<float>(first);
        for (const int v : {first, first + 1, 0, 0}) jointsOf.push_back(static_cast<std::uint8_t>(v));
        for (const float v : {1 - share, share, 0.0f, 0.0f}) weights.push_back(v);
        if (j == along) continue;
        const auto at4 = [&](int di, int dj) { return static_cast<std::uint16_t>((j + dj) * around + (i + di) % around); };
        for (const std::uint16_t v : {at4(0, 0), at4(0, 1), at4(1, 0), at4(1, 0), at4(0, 1), at4(1, 1)}) indices.push_back(v);
      }
  }
  std::size_t vertices() const { return positions.size() / 3; }

  FileBytes build() const {
    FileBytes binary;
    std::string views, accessors;
    const auto add = [&](const auto& values, int component, const char* type, std::size_t count) {
      while (binary.size() % 4) binary.push_back(0);
      const std::size_t at = binary.size();
      appendValues(binary, values);
      views += (views.empty() ? "" : ",") + std::string("{\"buffer\":0,\"byteOffset\":") + std::to_string(at) +
               ",\"byteLength\":" + std::to_string(binary.size() - at) + "}";
      const std::size_t view = accessorCount++;
      accessors += (accessors.empty() ? "" : ",") + std::string("{\"bufferView\":") + std::to_string(view) + ",\"componentType\":" +
                   std::to_string(component) + ",\"type\":\"" + type + "\",\"count\":" + std::to_string(count) + "}";
    };
    accessorCount = 0;
    add(positions, 5126, "VEC3", vertices());           // 0
    add(normals, 5126, "VEC3", vertices());             // 1
    add(jointsOf, 5121, "VEC4", vertices());            // 2
    add(weights, 5126, "VEC4", vertices());             // 3
    add(indices, 5123, "SCALAR", indices.size());       // 4
    std::vector<float> binds;
    for (int j = 0; j < joints; ++j)
      for (int k = 0; k < 16; ++k) binds.push_back(k % 5 == 0 ? 1.0f : k == 13 ? -heightOf(j) : 0.0f);
    add(binds, 5126, "MAT4", static_cast<std::size_t>(joints));  // 5
    std::vector<float> times, turns, shares;
    for (int k = 0; k <= 8; ++k) {
      const float t = static_cast<float>(k) / 4, half = 0.3f * std::sin(kPi * t);
      times.push_back(t);
      for (const float v : {0.0f, 0.0f, std::sin(half), std::cos(half)}) turns.push_back(v);
      for (const float v : {0.0f, 0.5f - 0.5f * std::cos(kPi * t)}) shares.push_back(v);
    }
    add(times, 5126, "SCALAR", times.size());           // 6
    add(turns, 5126, "VEC4", times.size());             // 7
    add(shares, 5126, "SCALAR", shares.size());         // 8
    add(swell, 5126, "VEC3", vertices());               // 9
    add(swellNormals, 5126, "VEC3", vertices());        // 10

    // Node 0 holds the mesh, 1 and on are joints, each the child of the one before.
    std::string nodes = R"({"mesh":0,"skin":0})", list;
    for (int j = 0; j < joints; ++j) {
      nodes += ",{\"translation\":[0," + std::to_string(j ? heightOf(1) : 0.0f) + ",0]";
      if (j + 1 < joints) nodes += ",\"children\":[" + std::to_string(j + 2) + "]";
      nodes += "}";
      list += (j ? "," : "") + std::to_string(j + 1);
    }
    std::string channels;
    for (int j = 1; j < joints; ++j)
      channels += (j > 1 ? "," : "") + std::string(R"({"sampler":0,"target":{"path":"rotation","node":)") + std::to_string(j + 1) + "}}";
    const std::string standard =
        R"({"name":"wave","samplers":[{"input":6,"output":7}],"channels":[)" + channels +
        R"(]},{"name":"swell","samplers":[{"input":6,"output":8}],"channels":[{"sampler":0,"target":{"path":"weights","node":0}}]})";
    const std::string json =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[)" + nodes + R"(],"meshes":[{"primitives":[{"attributes":{)" +
        (attributes.empty() ? R"("POSITION":0,"NORMAL":1,"JOINTS_0":2,"WEIGHTS_0":3)" : attributes) + R"(},"indices":4)" + targets +
        R"(}]}],"skins":[)" + (skin.empty() ? R"({"inverseBindMatrices":5,"joints":[)" + list + "]}" : skin) + R"(],"animations":[)" +
        (animations.empty() ? standard : animations) + R"(],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views +
        R"(],"buffers":[{"byteLength":)" + std::to_string((binary.size() + 3) / 4 * 4) + "}]}";
    return glb(json, binary);
  }
  float heightOf(int joint) const { return static_cast<float>(joint) / static_cast<float>(joints - 1); }

 private:
  mutable std::size_t accessorCount = 0;
};

}  // namespace fur::scene
