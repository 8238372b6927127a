// Puts together the JSON and the binary chunk of a .glb.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/NumberText.h"

namespace fur::scene {

struct GlbWriter {
  std::vector<std::uint8_t> binary;
  std::string accessors, views;  // separated by commas
  int accessorCount = 0, viewCount = 0;
  int buffer = 0;         // that the binary will be
  std::string viewExtra;  // further JSON of every view

  // A view of its own; `extra` is further JSON of it. Returns its index.
  int addView(std::span<const std::uint8_t> bytes, const std::string& extra = "");

  template <class T>
  int addBytes(const std::vector<T>& values) {
    return addView({reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)});
  }

  // One accessor on a view of its own; `extra` is further accessor JSON. Returns its index.
  template <class T>
  int add(const std::vector<T>& values, const char* type, std::uint32_t component, std::uint32_t target, const std::string& extra = "") {
    const auto* from = reinterpret_cast<const std::uint8_t*>(values.data());
    const int view = addView({from, values.size() * sizeof(T)}, ",\"target\":" + decimal(target));
    accessors += (accessorCount ? "," : "") + std::string("{\"bufferView\":") + decimal(view) + ",\"componentType\":" +
                 decimal(component) + ",\"count\":" + decimal(values.size()) + ",\"type\":\"" + type + "\"" + extra + "}";
    return accessorCount++;
  }
};

void padTo4(std::vector<std::uint8_t>& bytes, std::uint8_t with);
// A JSON array.
std::string jsonNumbers(const float* values, int count);
// Both chunks, padded, and further ones as they stand.
std::vector<std::uint8_t> glbContainer(const std::string& json, std::span<const std::uint8_t> binary, std::span<const std::uint8_t> furtherChunks = {});

}  // namespace fur::scene
