#include "geometry/SurfaceBytes.h"

#include <algorithm>

#include "core/Bytes.h"

namespace fur::geometry {

namespace {

// In one order for writing and reading.
template <class Stream, class OneSurface>
void passThrough(Stream& stream, OneSurface& s) {
  stream(s.vertices, s.trueVertexCount, s.indices, s.furIndices, s.ownFurIndices, s.furClusters, s.edges, s.chartCount, s.turned, s.sheets, s.inserted, s.meshIndices);
}

// Of what a writer would write: so many megabytes that letting them grow would take longer than writing them.
struct ByteCounter {
  std::size_t bytes = 0;
  template <class... T>
  void operator()(const T&... values) {
    (add(values), ...);
  }
  template <class T>
  void add(const T& value) {
    bytes += sizeof value;
  }
  template <class T>
  void add(const std::vector<T>& values) {
    bytes += sizeof(std::uint32_t) + values.size() * sizeof(T);
  }
};

template <class T, class Test>
bool allOf(const std::vector<T>& values, Test test) {
  return std::all_of(values.begin(), values.end(), test);
}

bool allBelow(const std::vector<std::uint32_t>& indices, std::size_t count) {
  return indices.size() % 3 == 0 && allOf(indices, [&](std::uint32_t i) { return i < count; });
}

// A vertex inserted lies between two before it.
bool insertedFit(const Surface& s, std::size_t count) {
  return allOf(s.inserted, [&](const InsertedVertex& v) { return std::max(v.a, v.b) < count++; });
}

bool fits(const Surface& s, const Mesh& mesh) {
  const std::size_t count = s.vertices.size(), own = mesh.positions.size(), sources = own + s.inserted.size();
  return s.trueVertexCount <= count && !s.indices.empty() && allBelow(s.indices, s.trueVertexCount) && allBelow(s.furIndices, count) &&
         allBelow(s.ownFurIndices, count) && allBelow(s.meshIndices, count) &&
         allOf(s.vertices, [&](const SurfaceVertex& v) { return v.source < sources; }) &&
         allOf(s.edges, [&](const SurfaceEdge& e) { return e.a < count && e.b < count; }) &&
         insertedFit(s, own) &&
         allOf(s.furClusters, [&](const FurCluster& c) {
           return std::size_t{c.first} + c.count <= s.furIndices.size() && std::size_t{c.ownFirst} + c.ownCount <= s.ownFurIndices.size();
         });
}

}  // namespace

std::vector<std::uint8_t> surfaceBytes(const Surface& surface) {
  ByteCounter all;
  passThrough(all, surface);
  ByteWriter out;
  out.bytes.reserve(all.bytes);
  passThrough(out, surface);
  return std::move(out.bytes);
}

std::optional<Surface> surfaceFromBytes(std::span<const std::uint8_t> bytes, const Mesh& mesh) {
  ByteReader in(bytes);
  Surface surface;
  passThrough(in, surface);
  if (!in.sound() || !in.atEnd() || !fits(surface, mesh)) return std::nullopt;
  return surface;
}

}  // namespace fur::geometry
