#include <span>

#include "core/Json.h"
#include "core/NumberText.h"
#include "scene/Model.h"
#include "scene/export/FurExtension.h"
#include "scene/export/GlbWriter.h"

namespace fur::scene {

namespace {

constexpr std::uint32_t kFloat = 5126, kUnsignedInt = 5125;
constexpr std::uint32_t kVertexBuffer = 34962, kIndexBuffer = 34963;

static_assert(sizeof(Vec3) == 12 && sizeof(Vec2) == 8, "vectors are written as they lie in memory (little-endian)");

// The attributes of the one primitive. Texture coordinate sets must be numbered without gaps: the atlas is the
// second when the mesh has uv, else the first.
std::string attributesOf(GlbWriter& writer, const geometry::Mesh& mesh, const FurData& fur) {
  const std::size_t vertices = mesh.positions.size();
  const geometry::Bounds box = geometry::bounds(mesh);
  std::string out;
  const auto put = [&](const char* name, const auto& values, const char* type, const std::string& extra = "") {
    if (values.size() != vertices) return;
    out += (out.empty() ? "\"" : ",\"") + std::string(name) + "\":" +
           decimal(writer.add(values, type, kFloat, kVertexBuffer, extra));
  };
  put("POSITION", mesh.positions, "VEC3", ",\"min\":" + jsonNumbers(&box.low.x, 3) + ",\"max\":" + jsonNumbers(&box.high.x, 3));
  put("NORMAL", mesh.normals, "VEC3");
  put("TEXCOORD_0", mesh.uv, "VEC2");
  put(mesh.uv.empty() ? "TEXCOORD_0" : "TEXCOORD_1", mesh.atlas, "VEC2");
  put("_WETFUR_TILE", mesh.furUv, "VEC2");
  put("_WETFUR_COMB", fur.comb, "VEC3");
  return out;
}

// WETFUR_fur of the root; "" when there is nothing to say.
std::string extensionOf(GlbWriter& writer, const geometry::Mesh& mesh, const FurData& fur) {
  const FurPlace place{.hasAtlas = mesh.atlas.size() == mesh.positions.size(), .ofMaps = mesh.uv.empty() ? ",\"texCoord\":0" : ",\"texCoord\":1", .ofRoot = ""};
  const bool hasMaps = !(fur.map.empty() && fur.paint.empty() && fur.mask.empty() && fur.shape.empty() && fur.wetness.empty() && fur.hair.empty());
  const bool isPlain = fur.state.empty() && fur.comb.empty() && fur.whiskers.empty() && !hasCoats(fur) && mesh.furUv.empty();
  return isPlain && !(hasMaps && place.hasAtlas) ? "" : furExtension(writer, fur, place);
}

// Materials, textures and images, each with a comma after it. The last material is what is shown.
std::string materialsOf(GlbWriter& writer, const geometry::Mesh& mesh, const ScenePicture& picture, std::string& used) {
  std::string materials, textures, images;
  int count = 0;
  const auto add = [&](const Vec4& factor, std::span<const std::uint8_t> bytes, const std::string& type, const char* texCoord) {
    materials += (materials.empty() ? "" : ",") + std::string("{\"pbrMetallicRoughness\":{\"baseColorFactor\":") + jsonNumbers(&factor.x, 4) +
                 ",\"metallicFactor\":0";
    if (!bytes.empty()) {
      const std::string index = decimal(count), comma = count++ > 0 ? "," : "", source = "{\"source\":" + index + "}";
      const bool webp = type == "image/webp";
      if (webp) used += std::string(used.empty() ? "" : ",") + "\"EXT_texture_webp\"";
      materials += ",\"baseColorTexture\":{\"index\":" + index + texCoord + "}";
      textures += comma + (webp ? "{\"extensions\":{\"EXT_texture_webp\":" + source + "}}" : source);
      images += comma + "{\"bufferView\":" + decimal(writer.addView(bytes)) + ",\"mimeType\":\"" + type + "\"}";
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

}  // namespace

std::vector<std::uint8_t> exportGlb(const geometry::Mesh& mesh, const std::string& name) {
  return exportScene(mesh, name, {}, {{}, Vec4(1)});
}

std::vector<std::uint8_t> exportScene(const geometry::Mesh& mesh, const std::string& name, const FurData& fur,
                                      const ScenePicture& picture) {
  GlbWriter writer;
  const std::string attributes = attributesOf(writer, mesh, fur);
  const int indices = writer.add(mesh.indices, "SCALAR", kUnsignedInt, kIndexBuffer);
  const std::string extension = extensionOf(writer, mesh, fur);
  std::string used = extension.empty() ? "" : "\"WETFUR_fur\"";
  const std::string materials = materialsOf(writer, mesh, picture, used);
  std::string shown = materials.empty() ? "" : ",\"material\":0";
  if (!picture.painted.empty()) shown = R"(,"material":1,"extensions":{"WETFUR_fur":{"material":0}})";
  std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"wet-fur\"},";
  if (!used.empty()) json += "\"extensionsUsed\":[" + used + "],";
  if (!extension.empty()) json += "\"extensions\":{\"WETFUR_fur\":" + extension + "},";
  json += "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"name\":" + jsonString(name) + "}]," + materials +
          "\"meshes\":[{\"name\":" + jsonString(name) + ",\"primitives\":[{\"attributes\":{" + attributes + "},\"indices\":" +
          decimal(indices) + shown + "}]}],\"accessors\":[" +
          writer.accessors + "],\"bufferViews\":[" + writer.views + "],\"buffers\":[{\"byteLength\":" +
          decimal(writer.binary.size()) + "}]}";
  return glbContainer(json, writer.binary);
}

}  // namespace fur::scene
