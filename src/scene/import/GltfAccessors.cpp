#include "scene/import/GltfAccessors.h"

#include <algorithm>
#include <cstring>

namespace fur::scene {

namespace {

enum Component : std::uint64_t { kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                                 kUint32 = 5125, kFloat32 = 5126 };

std::size_t sizeOf(Whole component) {
  switch (component) {
    case kByte: case kUnsignedByte: return 1;
    case kShort: case kUnsignedShort: return 2;
    case kUint32: case kFloat32: return 4;
    default: return 0;
  }
}

// Elements that lie inside the bytes; `stride` apart. Null bytes: all zero (only sparse values, or none).
struct Elements {
  const std::uint8_t* bytes = nullptr;
  std::size_t stride = 0, count = 0;
};

struct Accessor {
  std::string where;
  const Json& json;
  Whole component;
  std::size_t count;
  bool normalized;
};

Accessor openAccessor(const GltfFile& file, Whole index, const char* type, std::size_t limit) {
  const Json& json = file.element("accessors", index);
  const std::string where = formatted("accessors[%llu]", index);
  const Json* given = json.find("type");
  if (!given || given->text() != type) file.bad("%s.type is not %s", where.c_str(), type);
  const Whole component = file.whole(json, "componentType", where);
  if (sizeOf(component) == 0) file.bad("%s.componentType %llu is unknown", where.c_str(), component);
  const Whole count = file.whole(json, "count", where);
  if (count > limit) file.fail(ErrorId::TooLarge, "%s has %llu elements; the limit is %zu", where.c_str(), count, limit);
  const Json* normalized = json.find("normalized");
  return {where, json, component, static_cast<std::size_t>(count), normalized && normalized->isTrue()};
}

// `count` elements of `size` bytes from `offset` on in a view: all inside, or bad-file.
Elements elementsIn(const GltfFile& file, Whole view, Whole offset, std::size_t count, std::size_t size,
                    const std::string& where) {
  const GltfFile::View from = file.bufferView(view);
  const std::size_t stride = from.stride ? from.stride : size;
  if (stride < size) file.bad("%s: the elements overlap (a stride of %zu)", where.c_str(), stride);
  // No sum here overflows 64 bits: offset <= 2^53, count <= kMaxIndices, stride <= 252.
  const Whole end = count == 0 ? 0 : offset + Whole{stride} * (count - 1) + size;
  if (end > from.bytes.size()) {
    file.bad("%s reaches byte %llu of bufferViews[%llu], which has %zu", where.c_str(), end, view, from.bytes.size());
  }
  return {count ? from.bytes.data() + offset : nullptr, stride, count};
}

Elements elementsOf(const GltfFile& file, const Accessor& accessor, std::size_t size) {
  if (!accessor.json.find("bufferView")) return {nullptr, 0, accessor.count};
  return elementsIn(file, file.whole(accessor.json, "bufferView", accessor.where),
                    file.whole(accessor.json, "byteOffset", 0, accessor.where), accessor.count, size, accessor.where);
}

template <class T>
T load(const std::uint8_t* from) {
  T value;
  std::memcpy(&value, from, sizeof value);  // accessors need not be aligned
  return value;
}

// glTF 2.0, 3.11: signed normalized integers reach -1 one step early.
float componentAt(const std::uint8_t* from, Whole component, bool normalized) {
  switch (component) {
    case kByte: {
      const float value = load<std::int8_t>(from);
      return normalized ? std::max(value / 127.0f, -1.0f) : value;
    }
    case kUnsignedByte: return load<std::uint8_t>(from) / (normalized ? 255.0f : 1.0f);
    case kShort: {
      const float value = load<std::int16_t>(from);
      return normalized ? std::max(value / 32767.0f, -1.0f) : value;
    }
    case kUnsignedShort: return load<std::uint16_t>(from) / (normalized ? 65535.0f : 1.0f);
    default: return load<float>(from);
  }
}

std::uint32_t indexAt(const std::uint8_t* from, Whole component) {
  if (component == kUnsignedByte) return *from;
  return component == kUnsignedShort ? load<std::uint16_t>(from) : load<std::uint32_t>(from);
}

bool isIndexComponent(Whole component) {
  return component == kUnsignedByte || component == kUnsignedShort || component == kUint32;
}

// Where an accessor's elements are replaced (glTF 2.0, 3.6.2.3).
struct Sparse {
  Elements indices, values;
  std::uint64_t indexComponent = kUint32;
};

Sparse openSparse(const GltfFile& file, const Accessor& accessor, std::size_t size) {
  Sparse sparse;
  const Json* json = accessor.json.find("sparse");
  if (!json) return sparse;
  const std::string where = accessor.where + ".sparse";
  if (!json->isObject()) file.bad("%s is not an object", where.c_str());
  const Whole count = file.whole(*json, "count", where);
  if (count > accessor.count) {
    file.bad("%s replaces %llu of %zu elements", where.c_str(), count, accessor.count);
  }
  const Json *indices = json->find("indices"), *values = json->find("values");
  if (!indices || !indices->isObject() || !values || !values->isObject()) {
    file.bad("%s has no indices or no values", where.c_str());
  }
  for (const Json* part : {json, indices, values}) file.expectFewKeys(*part, where);
  sparse.indexComponent = file.whole(*indices, "componentType", where);
  if (!isIndexComponent(sparse.indexComponent)) file.bad("%s.indices are no unsigned integers", where.c_str());
  sparse.indices = elementsIn(file, file.whole(*indices, "bufferView", where), file.whole(*indices, "byteOffset", 0, where),
                              static_cast<std::size_t>(count), sizeOf(sparse.indexComponent), where + ".indices");
  sparse.values = elementsIn(file, file.whole(*values, "bufferView", where), file.whole(*values, "byteOffset", 0, where),
                             static_cast<std::size_t>(count), size, where + ".values");
  return sparse;
}

// Calls store(element, bytes) for every element that has bytes, the replaced ones last.
template <class Store>
void forEachElement(const GltfFile& file, const Accessor& accessor, std::size_t size, Store store) {
  const Elements all = elementsOf(file, accessor, size);
  for (std::size_t i = 0; all.bytes && i < all.count; ++i) store(i, all.bytes + i * all.stride);
  const Sparse sparse = openSparse(file, accessor, size);
  for (std::size_t i = 0; i < sparse.indices.count; ++i) {
    const std::uint32_t at = indexAt(sparse.indices.bytes + i * sparse.indices.stride, sparse.indexComponent);
    if (at >= accessor.count) {
      file.bad("%s.sparse replaces element %u of %zu", accessor.where.c_str(), at, accessor.count);
    }
    store(at, sparse.values.bytes + i * sparse.values.stride);
  }
}

}  // namespace

std::vector<float> readFloats(const GltfFile& file, Whole index, int components) {
  const char* type = components == 1 ? "SCALAR" : components == 2 ? "VEC2" : components == 3 ? "VEC3" : components == 4 ? "VEC4" : "MAT4";
  const Accessor accessor = openAccessor(file, index, type, kMaxVertices);
  if (accessor.component == kUint32) file.bad("%s has 32-bit integers where numbers are needed", accessor.where.c_str());
  const std::size_t part = sizeOf(accessor.component), width = static_cast<std::size_t>(components);
  std::vector<float> out;
  const auto store = [&](std::size_t i, const std::uint8_t* from) {
    if (out.empty()) out.resize(accessor.count * width, 0.0f);
    for (std::size_t c = 0; c < width; ++c) {
      out[i * width + c] = componentAt(from + c * part, accessor.component, accessor.normalized);
    }
  };
  forEachElement(file, accessor, part * width, store);
  out.resize(accessor.count * width, 0.0f);
  return out;
}

std::vector<std::uint32_t> readIndices(const GltfFile& file, Whole index) {
  const Accessor accessor = openAccessor(file, index, "SCALAR", kMaxIndices);
  if (!isIndexComponent(accessor.component)) {
    file.bad("%s is used for indices but is not of unsigned integers", accessor.where.c_str());
  }
  std::vector<std::uint32_t> out;
  forEachElement(file, accessor, sizeOf(accessor.component), [&](std::size_t i, const std::uint8_t* from) {
    if (out.empty()) out.resize(accessor.count, 0);
    out[i] = indexAt(from, accessor.component);
  });
  out.resize(accessor.count, 0);
  return out;
}

std::size_t elementCount(const GltfFile& file, Whole index) {
  const std::string where = formatted("accessors[%llu]", index);
  const Whole count = file.whole(file.element("accessors", index), "count", where);
  if (count > kMaxIndices) {
    file.fail(ErrorId::TooLarge, "%s has %llu elements; the limit is %zu", where.c_str(), count, kMaxIndices);
  }
  return static_cast<std::size_t>(count);
}

}  // namespace fur::scene
