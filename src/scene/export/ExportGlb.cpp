#include <cstdio>
#include <cstring>
#include <span>
#include <utility>

#include "core/Json.h"
#include "hair/HairFields.h"
#include "scene/MapPlanes.h"
#include "scene/Model.h"
#include "scene/WetnessPlanes.h"

namespace fur::scene {

namespace {

constexpr std::uint32_t kFloat = 5126, kUnsignedInt = 5125;
constexpr std::uint32_t kVertexBuffer = 34962, kIndexBuffer = 34963;

void append32(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void padTo4(std::vector<std::uint8_t>& bytes, std::uint8_t with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
}

std::string numbers(const float* values, int count) {
  std::string out = "[";
  for (int i = 0; i < count; ++i) {
    char text[32];
    std::snprintf(text, sizeof text, "%s%.9g", i ? "," : "", static_cast<double>(values[i]));
    out += text;
  }
  return out + "]";
}

// The JSON and binary chunks while they are put together.
struct Writer {
  std::vector<std::uint8_t> binary;
  std::string accessors, views;
  int accessorCount = 0, viewCount = 0;

  // A view of its own; `extra` is further JSON of it. Returns its index.
  int addView(std::span<const std::uint8_t> bytes, const std::string& extra) {
    views += (viewCount ? "," : "") + std::string("{\"buffer\":0,\"byteOffset\":") + std::to_string(binary.size()) +
             ",\"byteLength\":" + std::to_string(bytes.size()) + extra + "}";
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    padTo4(binary, 0);
    return viewCount++;
  }

  // One accessor on a view of its own; `extra` is further accessor JSON. Returns its index.
  template <class T>
  int add(const std::vector<T>& values, const char* type, std::uint32_t component, std::uint32_t target,
          const std::string& extra = "") {
    const auto* from = reinterpret_cast<const std::uint8_t*>(values.data());
    const int view = addView({from, values.size() * sizeof(T)}, ",\"target\":" + std::to_string(target));
    accessors += (accessorCount ? "," : "") + std::string("{\"bufferView\":") + std::to_string(view) +
                 ",\"componentType\":" + std::to_string(component) + ",\"count\":" + std::to_string(values.size()) +
                 ",\"type\":\"" + type + "\"" + extra + "}";
    return accessorCount++;
  }
};

static_assert(sizeof(Vec3) == 12 && sizeof(Vec2) == 8, "vectors are written as they lie in memory (little-endian)");

// The attributes of the one primitive. Texture coordinate sets must be numbered without gaps: the atlas is the
// second when the mesh has uv, else the first.
std::string attributesOf(Writer& writer, const geometry::Mesh& mesh, const FurData& fur) {
  const std::size_t vertices = mesh.positions.size();
  const geometry::Bounds box = geometry::bounds(mesh);
  std::string out;
  const auto put = [&](const char* name, const auto& values, const char* type, const std::string& extra = "") {
    if (values.size() != vertices) return;
    out += (out.empty() ? "\"" : ",\"") + std::string(name) + "\":" +
           std::to_string(writer.add(values, type, kFloat, kVertexBuffer, extra));
  };
  put("POSITION", mesh.positions, "VEC3", ",\"min\":" + numbers(&box.low.x, 3) + ",\"max\":" + numbers(&box.high.x, 3));
  put("NORMAL", mesh.normals, "VEC3");
  put("TEXCOORD_0", mesh.uv, "VEC2");
  put(mesh.uv.empty() ? "TEXCOORD_0" : "TEXCOORD_1", mesh.atlas, "VEC2");
  put("_WETFUR_TILE", mesh.furUv, "VEC2");
  put("_WETFUR_COMB", fur.comb, "VEC3");
  return out;
}

// The number of the view that holds it.
std::string addMap(Writer& writer, const std::vector<groom::GroomMap::Texel>& map) { return std::to_string(writer.addView(packMap(map), "")); }

template <class T>
std::string addBytes(Writer& writer, const std::vector<T>& values) {
  return std::to_string(writer.addView({reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)}, ""));
}

std::string scalpJson(Writer& writer, const hair::Scalp& scalp) {
  std::string out = "{\"name\":" + jsonString(scalp.name) + ",\"values\":" + hair::writeHairValues(scalp.values) +
                    ",\"map\":{\"size\":" + std::to_string(scalp.map.size()) + ",\"bufferView\":" + addMap(writer, scalp.map.texels()) + "}";
  if (scalp.guides.count() > 0)
    out += ",\"guides\":{\"nodes\":" + std::to_string(scalp.guides.nodes) + ",\"positions\":" + addBytes(writer, scalp.guides.positions) +
           ",\"flags\":" + addBytes(writer, scalp.guides.flags) +
           (scalp.wetness.empty() ? "" : ",\"wetness\":" + addBytes(writer, scalp.wetness)) + "}";
  return out + "}";
}

// `atlas` names its texture coordinates and closes the object.
std::string hairJson(Writer& writer, const hair::Hairstyle& hair, const std::string& atlas) {
  std::string out = ",\"hair\":{\"scalps\":[";
  for (const hair::Scalp& scalp : hair.scalps) out += (&scalp == hair.scalps.data() ? "" : ",") + scalpJson(writer, scalp);
  out += "]";
  // Without their bones: the file has none.
  std::vector<float> bodies;
  for (const hair::Body& body : hair.bodies)
    for (const float number : {body.a.x, body.a.y, body.a.z, body.b.x, body.b.y, body.b.z, body.radius}) bodies.push_back(number);
  if (!bodies.empty()) out += ",\"bodies\":" + addBytes(writer, bodies);
  return out + atlas;
}

// WETFUR_fur of the root; "" when there is nothing to say.
std::string furExtension(Writer& writer, const geometry::Mesh& mesh, const FurData& fur) {
  const bool hasAtlas = mesh.atlas.size() == mesh.positions.size();
  const std::pair<const char*, const std::vector<groom::GroomMap::Texel>*> over[] = {
      {"paint", &fur.paint}, {"mask", &fur.mask}, {"shape", &fur.shape}};
  const bool hasMap = !(fur.map.empty() && fur.paint.empty() && fur.mask.empty() && fur.shape.empty()) && hasAtlas;
  const bool isWet = !fur.wetness.empty() && hasAtlas;
  const std::string atlas = mesh.uv.empty() ? ",\"texCoord\":0}" : ",\"texCoord\":1}";
  const bool hasHair = !fur.hair.empty() && hasAtlas;
  if (fur.state.empty() && !hasMap && !isWet && !hasHair && fur.comb.empty() && fur.whiskers.empty() && mesh.furUv.empty()) return "";
  std::string out = "\"WETFUR_fur\":{\"version\":" + std::to_string(kFurVersion);
  if (!fur.state.empty()) out += ",\"state\":" + fur.state;
  if (hasMap) {
    const std::vector<groom::GroomMap::Texel> plain(static_cast<std::size_t>(fur.mapSize) * static_cast<std::size_t>(fur.mapSize), groom::GroomMap::kPlain);
    out += ",\"groom\":{\"size\":" + std::to_string(fur.mapSize) + ",\"bufferView\":" + addMap(writer, fur.map.empty() ? plain : fur.map);
    for (const auto& [name, map] : over)
      if (!map->empty()) out += std::string(",\"") + name + "\":" + addMap(writer, *map);
    out += atlas;
  }
  if (isWet)
    out += ",\"wetness\":{\"size\":" + std::to_string(fur.wetnessSize) + ",\"bufferView\":" +
           std::to_string(writer.addView(packWetness(fur.wetness), "")) + atlas;
  if (hasHair) out += hairJson(writer, fur.hair, atlas);
  if (!fur.whiskers.empty()) {
    const auto* from = reinterpret_cast<const std::uint8_t*>(fur.whiskers.data());
    out += ",\"whiskers\":{\"bufferView\":" + std::to_string(writer.addView({from, fur.whiskers.size() * groom::kWhiskerBytes}, "")) + "}";
  }
  return out + "}";
}

// Materials, textures and images, each with a comma after it. The last material is what is shown.
std::string materialsOf(Writer& writer, const geometry::Mesh& mesh, const ScenePicture& picture, std::string& used) {
  std::string materials, textures, images;
  int count = 0;
  const auto add = [&](const Vec4& factor, std::span<const std::uint8_t> bytes, const std::string& type, const char* texCoord) {
    materials += (materials.empty() ? "" : ",") + std::string("{\"pbrMetallicRoughness\":{\"baseColorFactor\":") + numbers(&factor.x, 4) +
                 ",\"metallicFactor\":0";
    if (!bytes.empty()) {
      const std::string index = std::to_string(count), comma = count++ > 0 ? "," : "", source = "{\"source\":" + index + "}";
      const bool webp = type == "image/webp";
      if (webp) used += std::string(used.empty() ? "" : ",") + "\"EXT_texture_webp\"";
      materials += ",\"baseColorTexture\":{\"index\":" + index + texCoord + "}";
      textures += comma + (webp ? "{\"extensions\":{\"EXT_texture_webp\":" + source + "}}" : source);
      images += comma + "{\"bufferView\":" + std::to_string(writer.addView(bytes, "")) + ",\"mimeType\":\"" + type + "\"}";
    }
    materials += "}}";
  };
  const bool isPainted = !picture.painted.empty();
  if (picture.image.bytes.empty() && picture.factor == Vec4(1) && !isPainted) return "";
  add(picture.factor, picture.image.bytes, picture.image.mimeType, "");
  if (isPainted) add(Vec4(1), picture.painted, "image/png", mesh.uv.empty() ? "" : ",\"texCoord\":1");
  std::string out = "\"materials\":[" + materials + "],";
  if (count > 0) out += "\"textures\":[" + textures + "],\"images\":[" + images + "],";
  return out;
}

std::vector<std::uint8_t> container(const std::string& json, const std::vector<std::uint8_t>& binary) {
  std::vector<std::uint8_t> jsonBytes(json.begin(), json.end());
  padTo4(jsonBytes, ' ');
  std::vector<std::uint8_t> file;
  append32(file, 0x46546c67);  // "glTF"
  append32(file, 2);
  append32(file, static_cast<std::uint32_t>(12 + 8 + jsonBytes.size() + 8 + binary.size()));
  append32(file, static_cast<std::uint32_t>(jsonBytes.size()));
  append32(file, 0x4e4f534a);  // "JSON"
  file.insert(file.end(), jsonBytes.begin(), jsonBytes.end());
  append32(file, static_cast<std::uint32_t>(binary.size()));
  append32(file, 0x004e4942);  // "BIN"
  file.insert(file.end(), binary.begin(), binary.end());
  return file;
}

}  // namespace

std::vector<std::uint8_t> exportGlb(const geometry::Mesh& mesh, const std::string& name) {
  return exportScene(mesh, name, {}, {{}, Vec4(1)});
}

std::vector<std::uint8_t> exportScene(const geometry::Mesh& mesh, const std::string& name, const FurData& fur,
                                      const ScenePicture& picture) {
  Writer writer;
  const std::string attributes = attributesOf(writer, mesh, fur);
  const int indices = writer.add(mesh.indices, "SCALAR", kUnsignedInt, kIndexBuffer);
  const std::string extension = furExtension(writer, mesh, fur);
  std::string used = extension.empty() ? "" : "\"WETFUR_fur\"";
  const std::string materials = materialsOf(writer, mesh, picture, used);
  std::string shown = materials.empty() ? "" : ",\"material\":0";
  if (!picture.painted.empty()) shown = R"(,"material":1,"extensions":{"WETFUR_fur":{"material":0}})";
  std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"wet-fur\"},";
  if (!used.empty()) json += "\"extensionsUsed\":[" + used + "],";
  if (!extension.empty()) json += "\"extensions\":{" + extension + "},";
  json += "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"name\":" + jsonString(name) + "}]," + materials +
          "\"meshes\":[{\"name\":" + jsonString(name) + ",\"primitives\":[{\"attributes\":{" + attributes + "},\"indices\":" +
          std::to_string(indices) + shown + "}]}],\"accessors\":[" +
          writer.accessors + "],\"bufferViews\":[" + writer.views + "],\"buffers\":[{\"byteLength\":" +
          std::to_string(writer.binary.size()) + "}]}";
  return container(json, writer.binary);
}

}  // namespace fur::scene
