// The state of the program as JSON, in links, scene files and scripts.
//   {"version":1, "model":"bunny", "settings":{"furLength":0.1}, "camera":{"yaw":0,"pitch":0.3,"distance":3,"target":[0,0,0]}}
// Only settings that differ from the defaults are written. Water and groom are binary and stored elsewhere (FurData.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/Math.h"
#include "core/Result.h"
#include "settings/Settings.h"

namespace fur::scene {

inline constexpr int kStateVersion = 1;
inline constexpr std::size_t kMaxStateBytes = 64 * 1024;

struct CameraState {
  float yaw = 0, pitch = 0, distance = 0;
  Vec3 target{0};
};

struct ProgramState {
  std::string model;  // "" when the text names none
  settings::Settings settings;
  std::optional<CameraState> camera;
  Warnings warnings;  // unknown keys, clamped values
};

std::string writeState(const ProgramState& state);

// bad-file when the text is not a JSON object, too-large over kMaxStateBytes, unsupported-version for a newer version. Invalid
// values are skipped with a warning.
Result<ProgramState> readState(std::string_view json);

}  // namespace fur::scene
