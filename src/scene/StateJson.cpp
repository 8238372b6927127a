#include "scene/StateJson.h"

#include <cmath>

#include "core/NumberText.h"
#include "core/Json.h"
#include "settings/FurTypes.h"

namespace fur::scene {

namespace {

// A finite number, or a warning and `fallback`.
float readNumber(const Json& object, const char* key, float fallback, Warnings& warnings) {
  const Json* found = object.find(key);
  if (!found) return fallback;
  const auto number = static_cast<float>(found->number());
  if (std::isfinite(number)) return number;
  warnings.push_back(std::string("camera.") + key + " is not a number");
  return fallback;
}

CameraState readCamera(const Json& json, Warnings& warnings) {
  CameraState camera;
  camera.yaw = readNumber(json, "yaw", 0.35f, warnings);
  camera.pitch = readNumber(json, "pitch", 0.28f, warnings);
  camera.distance = readNumber(json, "distance", 4.0f, warnings);
  if (const Json* target = json.find("target"); target && target->isArray() && target->count() == 3) {
    int axis = 0;
    for (const Json& number : *target) {
      if (number.isNumber()) camera.target[axis] = static_cast<float>(number.number());
      ++axis;
    }
  }
  return camera;
}

void readSettings(const Json& json, settings::Settings& settings, Warnings& warnings) {
  for (const Json& key : json) {
    const std::string name = key.text();
    const Json& value = key.value();
    const settings::Field* field = settings::findField(name);
    if (value.isNumber() && field)
      settings::setField(settings, *field, value.number(), warnings);
    else
      settings::setField(settings, name, value.isString() ? value.text() : std::string(value.source()), warnings);
  }
}

void append(std::string& out, const char* key, float value) {
  out.append(key).append(shortDecimal(std::round(static_cast<double>(value) * 1e4) / 1e4));
}

}  // namespace

std::string writeState(const ProgramState& state) {
  const settings::Settings standard;
  std::string out = "{";
  if (state.camera) {
    const CameraState& c = *state.camera;
    append(out, "\"camera\":{\"distance\":", c.distance);
    append(out, ",\"pitch\":", c.pitch);
    append(out, ",\"target\":[", c.target.x);
    append(out, ",", c.target.y);
    append(out, ",", c.target.z);
    append(out, "],\"yaw\":", c.yaw);
    out += "},";
  }
  if (!state.model.empty()) out.append("\"model\":").append(jsonString(state.model)).append(",");
  out += "\"settings\":{";
  const char* before = "\"";
  for (const settings::Field& field : settings::fields()) {
    if (field.get(state.settings) == field.get(standard)) continue;
    out.append(before).append(field.name).append("\":").append(settings::fieldJson(state.settings, field));
    before = ",\"";
  }
  const std::string ofTypes = settings::typesJson(state.settings);
  out.append(ofTypes, *before == ',' || ofTypes.empty() ? 0 : 1);
  return out.append("},\"version\":").append(decimal(kStateVersion)).append("}");
}

Result<ProgramState> readState(std::string_view text) {
  if (text.size() > kMaxStateBytes)
    return Error{ErrorId::TooLarge, "state: " + decimal(text.size()) + " bytes, the limit is " +
                                        decimal(kMaxStateBytes)};
  const std::vector<Json> nodes = parseJson(text);
  if (nodes.empty() || !nodes[0].isObject()) return Error{ErrorId::BadFile, "state: not a JSON object"};
  const Json& json = nodes[0];
  if (const Json* version = json.find("version")) {
    const double number = version->number();
    if (!(number <= kStateVersion && number == std::floor(number)))
      return Error{ErrorId::UnsupportedVersion, "state: version " + std::string(version->source().substr(0, 64)) +
                                                    ", this program reads up to " + decimal(kStateVersion)};
  }
  ProgramState state;
  for (const Json& own : json) {
    const std::string key = own.text();
    const Json& value = own.value();
    if (key == "settings" && value.isObject())
      readSettings(value, state.settings, state.warnings);
    else if (key == "camera" && value.isObject())
      state.camera = readCamera(value, state.warnings);
    else if (key == "model" && value.isString())
      state.model = value.text();
    else if (key != "version")
      state.warnings.push_back("state: unknown key \"" + key.substr(0, 64) + '"');
  }
  return state;
}

}  // namespace fur::scene
