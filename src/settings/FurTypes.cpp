#include "settings/FurTypes.h"

#include <algorithm>
#include <charconv>

#include "core/Json.h"
#include "core/NumberText.h"
#include "settings/Presets.h"

namespace fur::settings {

namespace {

constexpr int Values::*kChosen[] = {&Values::type2, &Values::type3, &Values::type4};

int chosen(const Settings& settings, int type) { return settings.*kChosen[type - 1]; }
int own() { return static_cast<int>(presets().size()) + 1; }

void copyType(const Values& from, Values& to) {
  for (const Field& field : fields())
    if (field.has(kOfType)) field.set(to, field.get(from));
}

// Numbers of files.
struct FileField {
  const char* name;
  std::array<std::uint32_t, kFurTypes + 1> Settings::*numbers;
};
constexpr FileField kFiles[] = {{"picture", &Settings::typePictures}, {"typeSet", &Settings::typeSets}};

std::string numberText(std::uint32_t number) { return number ? hexadecimal(number, 8) : std::string(); }

bool readNumber(std::uint32_t& to, std::string_view text) {
  std::uint32_t number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (!text.empty() && (result.ec != std::errc() || result.ptr != text.data() + text.size())) return false;
  to = number;
  return true;
}

// The type's own value of the field.
bool setOwn(Settings& settings, int type, const Field& field, std::string_view text, Warnings& warnings) {
  if (type == 0) return setFieldText(settings, field, text, warnings);
  Settings coat = typeCoat(settings, type);
  if (!setFieldText(coat, field, text, warnings)) return false;
  setTypeCoat(settings, type, coat);
  return true;
}

}  // namespace

bool isOwn(const Settings& settings, int type) { return type == 0 || chosen(settings, type) == own(); }

Settings typeCoat(const Settings& settings, int type) {
  if (type == 0) return settings;
  Settings out = settings;
  if (isOwn(settings, type)) copyType(settings.ownTypes[static_cast<std::size_t>(type - 1)], out);
  else if (chosen(settings, type) == 0) out.density = 0;
  else out = *applyPreset(settings, presets()[static_cast<std::size_t>(chosen(settings, type) - 1)].name);
  return out;
}

Settings drawnCoat(const Settings& settings, int type) {
  Settings coat = typeCoat(settings, type);
  if (isOwn(settings, type)) return coat;
  for (float Values::*field : {&Values::specular, &Values::shininess, &Values::strandShadow, &Values::occlusion, &Values::gravity, &Values::stiffness})
    coat.*field = settings.*field;
  coat.skinColor = settings.skinColor;
  coat.furLength = std::min(coat.furLength, settings.furLength);
  return coat;
}

void setTypeCoat(Settings& settings, int type, const Values& coat) {
  if (type == 0) return copyCoat(coat, settings);
  copyType(coat, settings.ownTypes[static_cast<std::size_t>(type - 1)]);
  settings.*kChosen[type - 1] = own();
}

void makeBald(Settings& settings, int type) { settings.*kChosen[type - 1] = 0; }

void takeEdited(Settings& settings, int type, const Settings& edited) {
  if (type == 0) return void(settings = edited);
  const Settings before = typeCoat(settings, type);
  bool ownChanged = false;
  for (const Field& field : fields()) {
    if (field.get(edited) == field.get(before)) continue;
    if (field.has(kOfType)) ownChanged = true;
    else field.set(settings, field.get(edited));
  }
  if (ownChanged) setTypeCoat(settings, type, edited);
}

bool loadType(Settings& settings, int type, std::string_view preset) {
  const auto coat = applyPreset(settings, preset);
  if (coat) setTypeCoat(settings, type, *coat);
  return coat.has_value();
}

float coatLength(const Settings& settings, unsigned types) {
  float longest = settings.furLength;
  for (int type = 1; type < kFurTypes; ++type)
    if (types >> type & 1 && isOwn(settings, type)) longest = std::max(longest, settings.ownTypes[static_cast<std::size_t>(type - 1)].furLength);
  return longest;
}

float typeHeight(const Settings& settings, int type, float coatLength) {
  const Settings coat = drawnCoat(settings, type);
  if (type > 0 && coat.density <= 0) return 0;
  return coat.furLength >= coatLength ? 1 : coat.furLength / coatLength;
}

std::string_view typeName(const Settings& settings, int type) { return settings.typeNames[static_cast<std::size_t>(type)].data(); }

void setTypeName(Settings& settings, int type, std::string_view name) {
  std::size_t bytes = std::min({name.size(), kTypeNameBytes - 1, name.find('\0')});
  // Not within a character of UTF-8.
  while (bytes > 0 && bytes < name.size() && (static_cast<unsigned char>(name[bytes]) & 0xc0) == 0x80) --bytes;
  auto& held = settings.typeNames[static_cast<std::size_t>(type)];
  held.fill('\0');
  std::copy_n(name.begin(), bytes, held.begin());
}

std::optional<TypeField> typeFieldOf(std::string_view name) {
  constexpr std::string_view kType = "type";
  if (name == "skin.picture") return TypeField{kSkin, kFiles[0].name};
  if (name.size() < 7 || !name.starts_with(kType) || name[4] < '1' || name[4] > '4' || name[5] != '.') return {};
  return TypeField{name[4] - '1', name.substr(6)};
}

bool isTypeField(std::string_view name) {
  const Field* field = findField(name);
  return (field && field->has(kOfType)) || name == "name" || name == "preset" || name == kFiles[0].name || name == kFiles[1].name;
}

bool setTypeField(Settings& settings, const TypeField& of, std::string_view text, Warnings& warnings) {
  if (of.name == "name") return setTypeName(settings, of.type, text), true;
  if (of.name == "preset") {
    if (loadType(settings, of.type, text)) return true;
    warnings.push_back(unknownPreset(text));
    return false;
  }
  for (const FileField& file : kFiles) {
    if (of.name != file.name) continue;
    if (readNumber((settings.*file.numbers)[static_cast<std::size_t>(of.type)], text)) return true;
    warnings.push_back("\"" + std::string(text.substr(0, 64)) + "\" is not the number of a file");
    return false;
  }
  const Field* field = findField(of.name);
  if (field && field->has(kOfType)) return setOwn(settings, of.type, *field, text, warnings);
  warnings.push_back("a fur type has no setting \"" + std::string(of.name.substr(0, 64)) + '"');
  return false;
}

std::string typeFieldText(const Settings& settings, const TypeField& of) {
  if (of.name == "name") return std::string(typeName(settings, of.type));
  for (const FileField& file : kFiles)
    if (of.name == file.name) return numberText((settings.*file.numbers)[static_cast<std::size_t>(of.type)]);
  const Field* field = findField(of.name);
  return field && field->has(kOfType) ? fieldText(typeCoat(settings, of.type), *field) : std::string();
}

std::string typesJson(const Settings& settings) {
  const Values standard;
  std::string out;
  for (int type = 0; type < kFurTypes; ++type) {
    const auto index = static_cast<std::size_t>(type);
    const auto add = [&](std::string_view name, std::string_view json) {
      out.append(",\"type").append(decimal(type + 1)).append(".").append(name).append("\":").append(json);
    };
    if (!typeName(settings, type).empty()) add("name", jsonString(typeName(settings, type)));
    for (const FileField& file : kFiles)
      if ((settings.*file.numbers)[index]) add(file.name, jsonString(numberText((settings.*file.numbers)[index])));
    if (type == 0 || !isOwn(settings, type)) continue;
    const Values& values = settings.ownTypes[index - 1];
    for (const Field& field : fields())
      if (field.has(kOfType) && field.get(values) != field.get(standard)) add(field.name, fieldJson(values, field));
  }
  if (const std::uint32_t number = settings.typePictures[kSkin]) out.append(",\"skin.picture\":").append(jsonString(numberText(number)));
  return out;
}

}  // namespace fur::settings
