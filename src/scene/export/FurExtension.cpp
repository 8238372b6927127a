#include "scene/export/FurExtension.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/Json.h"
#include "core/NumberText.h"
#include "hair/HairFields.h"
#include "scene/MapPlanes.h"
#include "scene/WetnessPlanes.h"

namespace fur::scene {

namespace {

// The number of the view that holds it.
std::string addMap(GlbWriter& writer, const std::vector<groom::GroomMap::Texel>& map) { return decimal(writer.addView(packMap(map))); }

template <class T>
std::string addBytes(GlbWriter& writer, const std::vector<T>& values) { return decimal(writer.addBytes(values)); }

std::string scalpJson(GlbWriter& writer, const hair::Scalp& scalp) {
  std::string out = "{\"name\":" + jsonString(scalp.name) + ",\"values\":" + hair::writeHairValues(scalp.values) +
                    ",\"map\":{\"size\":" + decimal(scalp.map.size()) + ",\"bufferView\":" + addMap(writer, scalp.map.texels()) + "}";
  if (scalp.guides.count() > 0)
    out += ",\"guides\":{\"nodes\":" + decimal(scalp.guides.nodes) + ",\"positions\":" + addBytes(writer, scalp.guides.positions) +
           ",\"flags\":" + addBytes(writer, scalp.guides.flags) +
           (scalp.wetness.empty() ? "" : ",\"wetness\":" + addBytes(writer, scalp.wetness)) + "}";
  return out + "}";
}

// With the nodes of the file that they go with, if any does.
std::string bodiesJson(GlbWriter& writer, const std::vector<hair::Body>& bodies) {
  std::vector<float> numbers;
  std::string bones;
  for (const hair::Body& body : bodies) {
    for (const float number : {body.a.x, body.a.y, body.a.z, body.b.x, body.b.y, body.b.z, body.radius}) numbers.push_back(number);
    bones += (bones.empty() ? "" : ",") + decimal(body.bone);
  }
  std::string out = ",\"bodies\":" + addBytes(writer, numbers);
  const bool boned = std::any_of(bodies.begin(), bodies.end(), [](const hair::Body& body) { return body.bone >= 0; });
  return boned ? out + ",\"bones\":[" + bones + "]" : out;
}

std::string hairJson(GlbWriter& writer, const hair::Hairstyle& hair, const std::string& atlas) {
  std::string out = ",\"hair\":{\"scalps\":[";
  for (const hair::Scalp& scalp : hair.scalps) out += (&scalp == hair.scalps.data() ? "" : ",") + scalpJson(writer, scalp);
  out += "]";
  if (!hair.bodies.empty()) out += bodiesJson(writer, hair.bodies);
  return out + atlas + "}";
}

std::string groomJson(GlbWriter& writer, const FurData& fur, const std::string& atlas) {
  const std::pair<const char*, const std::vector<groom::GroomMap::Texel>*> over[] = {
      {"paint", &fur.paint}, {"mask", &fur.mask}, {"shape", &fur.shape}};
  const std::vector<groom::GroomMap::Texel> plain(static_cast<std::size_t>(fur.mapSize) * static_cast<std::size_t>(fur.mapSize), groom::GroomMap::kPlain);
  std::string out = ",\"groom\":{\"size\":" + decimal(fur.mapSize) + ",\"bufferView\":" + addMap(writer, fur.map.empty() ? plain : fur.map);
  for (const auto& [name, map] : over)
    if (!map->empty()) out += std::string(",\"") + name + "\":" + addMap(writer, *map);
  return out + atlas + "}";
}

std::string pictureJson(GlbWriter& writer, const char* key, const EncodedImage& picture) {
  return std::string(",\"") + key + "\":{\"bufferView\":" + addBytes(writer, picture.bytes) + ",\"mimeType\":" + jsonString(picture.mimeType) + "}";
}

// The type set of type 1 has had a place of its own before the other types had any.
std::string coatsJson(GlbWriter& writer, const FurData& fur) {
  const auto coats = std::span(fur.coats).first<groom::kTypes>();
  const EncodedImage& skin = fur.coats.back().picture;
  std::string out, types;
  for (const TypeFiles& coat : coats) {
    const bool first = &coat == coats.data();
    std::string one;
    if (!coat.typeSet.empty()) (first ? out : one) += ",\"typeSet\":" + addBytes(writer, coat.typeSet);
    if (!coat.picture.bytes.empty()) one += pictureJson(writer, "picture", coat.picture);
    types += (first ? "{" : ",{") + (one.empty() ? one : one.substr(1)) + "}";
  }
  if (!skin.bytes.empty()) out += pictureJson(writer, "skinPicture", skin);
  const bool any = std::any_of(coats.begin(), coats.end(), [&](const TypeFiles& coat) { return !coat.picture.bytes.empty() || (&coat != coats.data() && !coat.empty()); });
  return any ? out + ",\"types\":[" + types + "]" : out;
}

std::string waterJson(GlbWriter& writer, const std::vector<std::uint8_t>& water) {
  return ",\"water\":{\"bytes\":" + decimal(water.size()) + ",\"bufferView\":" + addBytes(writer, packPlanes(water)) + "}";
}

}  // namespace

bool hasCoats(const FurData& fur) {
  return std::any_of(fur.coats.begin(), fur.coats.end(), [](const TypeFiles& coat) { return !coat.empty(); });
}

std::string furExtension(GlbWriter& writer, const FurData& fur, const FurPlace& place) {
  std::string out = "{\"version\":" + decimal(place.version);
  if (!fur.state.empty()) out += ",\"state\":" + fur.state;
  const bool hasMap = !(fur.map.empty() && fur.paint.empty() && fur.mask.empty() && fur.shape.empty());
  if (hasMap && place.hasAtlas) out += groomJson(writer, fur, place.ofMaps);
  if (!fur.wetness.empty() && place.hasAtlas)
    out += ",\"wetness\":{\"size\":" + decimal(fur.wetnessSize) + ",\"bufferView\":" + addBytes(writer, packWetness(fur.wetness)) + place.ofMaps + "}";
  if (!fur.water.empty() && place.hasAtlas) out += waterJson(writer, fur.water);
  if (!fur.hair.empty() && place.hasAtlas) out += hairJson(writer, fur.hair, place.ofMaps);
  if (!fur.whiskers.empty()) {
    const auto* from = reinterpret_cast<const std::uint8_t*>(fur.whiskers.data());
    out += ",\"whiskers\":{\"bufferView\":" + decimal(writer.addView({from, fur.whiskers.size() * groom::kWhiskerBytes})) + "}";
  }
  if (fur.isLying && !fur.comb.empty()) out += ",\"lie\":true";
  if (fur.hasBare) {
    out += ",\"bare\":[";
    for (const int& material : fur.bare) out += (&material == fur.bare.data() ? "" : ",") + decimal(material);
    out += "]";
  }
  if (hasCoats(fur)) out += coatsJson(writer, fur);
  return out + place.ofRoot + "}";
}

}  // namespace fur::scene
