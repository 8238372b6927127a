#include "scene/StateJson.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace fur::scene {

namespace {

using Json = nlohmann::json;

// A finite number, or a warning and `fallback`.
float readNumber(const Json& object, const char* key, float fallback, Warnings& warnings) {
  const auto found = object.find(key);
  if (found == object.end()) return fallback;
  if (found->is_number() && std::isfinite(found->get<float>())) return found->get<float>();
  warnings.push_back(std::string("camera.") + key + " is not a number");
  return fallback;
}

CameraState readCamera(const Json& json, Warnings& warnings) {
  CameraState camera;
  camera.yaw = readNumber(json, "yaw", 0.35f, warnings);
  camera.pitch = readNumber(json, "pitch", 0.28f, warnings);
  camera.distance = readNumber(json, "distance", 4.0f, warnings);
  const auto target = json.find("target");
  if (target != json.end() && target->is_array() && target->size() == 3)
    for (int k = 0; k < 3; ++k)
      if ((*target)[k].is_number()) camera.target[k] = (*target)[k].get<float>();
  return camera;
}

void readSettings(const Json& json, settings::Settings& settings, Warnings& warnings) {
  for (const auto& [key, value] : json.items()) {
    const settings::Field* field = settings::findField(key);
    if (value.is_number() && field)
      settings::setField(settings, *field, value.get<double>(), warnings);
    else
      settings::setField(settings, key, value.is_string() ? value.get<std::string>() : value.dump(), warnings);
  }
}

Json valueOf(const settings::Settings& settings, const settings::Field& field) {
  switch (field.type) {
    case settings::FieldType::Bool: return field.get(settings) != 0;
    case settings::FieldType::Int: return static_cast<int>(field.get(settings));
    // Parsed from its short text: 0.1, not 0.10000000149.
    case settings::FieldType::Float: return std::strtod(settings::fieldText(settings, field).c_str(), nullptr);
    default: return settings::fieldText(settings, field);
  }
}

double shortened(float value) { return std::round(static_cast<double>(value) * 1e4) / 1e4; }

}  // namespace

std::string writeState(const ProgramState& state) {
  const settings::Settings standard;
  Json out = {{"version", kStateVersion}, {"settings", Json::object()}};
  if (!state.model.empty()) out["model"] = state.model;
  for (const settings::Field& field : settings::fields())
    if (field.get(state.settings) != field.get(standard)) out["settings"][field.name] = valueOf(state.settings, field);
  if (state.camera) {
    const CameraState& c = *state.camera;
    out["camera"] = {{"yaw", shortened(c.yaw)},
                     {"pitch", shortened(c.pitch)},
                     {"distance", shortened(c.distance)},
                     {"target", {shortened(c.target.x), shortened(c.target.y), shortened(c.target.z)}}};
  }
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<ProgramState> readState(std::string_view text) {
  if (text.size() > kMaxStateBytes)
    return Error{ErrorId::TooLarge, "state: " + std::to_string(text.size()) + " bytes, the limit is " +
                                        std::to_string(kMaxStateBytes)};
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return Error{ErrorId::BadFile, "state: not a JSON object"};
  const auto version = json.find("version");
  if (version != json.end() && (!version->is_number_integer() || version->get<double>() > kStateVersion))
    return Error{ErrorId::UnsupportedVersion, "state: version " + version->dump() + ", this program reads up to " +
                                                  std::to_string(kStateVersion)};
  ProgramState state;
  for (const auto& [key, value] : json.items()) {
    if (key == "settings" && value.is_object())
      readSettings(value, state.settings, state.warnings);
    else if (key == "camera" && value.is_object())
      state.camera = readCamera(value, state.warnings);
    else if (key == "model" && value.is_string())
      state.model = value.get<std::string>();
    else if (key != "version")
      state.warnings.push_back("state: unknown key \"" + key.substr(0, 64) + '"');
  }
  return state;
}

}  // namespace fur::scene
