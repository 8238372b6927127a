// A coat that a person has saved under a name, as a file (.coat): JSON,
//   {"wetFurCoat":1,"name":"Winter fox","settings":{"density":0.9},"typeSet":"...","picture":"..."}
// settings: of the values of a coat (kOfCoat) those that differ from the defaults, as states have them (StateJson.h). Base64,
// where the coat has them: typeSet, a .fts whose strands are drawn; picture, the colour map, as PNG, JPEG or WebP.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/Result.h"
#include "scene/FurData.h"
#include "settings/Settings.h"

namespace fur::scene {

inline constexpr int kCoatVersion = 1;
inline constexpr const char* kCoatVersionKey = "wetFurCoat";
inline constexpr std::size_t kMostCoatBytes = 32u << 20;
inline constexpr std::size_t kMostCoatNameBytes = 320;  // 80 characters of up to four

struct CoatFile {
  std::string name;
  settings::Values values{};
  TypeFiles files{};      // the type set is not validated yet
  Warnings warnings{};    // unknown keys, clamped values
};

std::vector<std::uint8_t> writeCoat(const CoatFile& coat);

// Whether a coat is such a file and no .fts: it begins with a brace and is of another size than those.
bool isCoatFile(std::span<const std::uint8_t> bytes);

// `file`: its name, for errors. bad-file: no JSON of that kind; too-large: over kMostCoatBytes, kMostCoatNameBytes or
// kMaxImageSide; unsupported-version. Values that cannot be read are skipped with a warning.
Result<CoatFile> readCoat(std::span<const std::uint8_t> bytes, const std::string& file);

}  // namespace fur::scene
