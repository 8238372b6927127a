// wet-fur-render: a picture of a model without a window.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/App.h"
#include "app/view/OrbitCamera.h"
#include "gl/Objects.h"
#include "native/Arguments.h"
#include "native/Files.h"
#include "native/headless/EglContext.h"
#include "scene/Png.h"
#include "settings/Presets.h"

namespace {

using namespace fur;

constexpr const char* kUsage = R"(usage: wet-fur-render [model] -o out.png [options]
  model                 a {models} file, or bunny (default), otter, pony, sphere, torus, plane,
                        or a scene as five-coats (assets/scenes/scenes.mjs has them all)
  -o, --output FILE     the PNG to write; may be left out when something else is saved
  --type-set [TYPE=]FILE  a coat from a {coats} file, for a fur type, 1 to 4 (several allowed)
  --color-map TYPE=FILE  a picture as the colour map of a fur type (several allowed)
  --save-type-set FILE  writes the coat as .fts
  --save-coat FILE      writes all of the coat of type 1 as .coat, named as the file
  --save-fo FILE        writes the model with its fur coordinates as .fo
  --save-scene FILE     writes model, groom, settings and camera as .glb
  --maps FOLDER         writes the groom's maps, the wetness and the layout of the charts as PNG files
  --length-map FILE     an image whose brightness is the length of the fur, or any map that --maps wrote
  --type-map FILE       one whose red, green and blue are the presence of the fur types 2 to 4
  --picture USE,FILE    an image and what it is: color, typeColor, skin, length, alpha, density, types or direction, as
                        the element's loadPicture() has them (several allowed, in order)
  --groom EDIT[,VALUE[,X,Y,Z]]  all over the model (several allowed, in order): length, invert, vary, type, comb, raise,
                        size, selectType and others, as the element's groom() has them
  --hair-file FILE      strands from a .hair file, as guides; before --hair
  --save-hair FILE      writes the selected scalp's strands as .hair
  --hair EDIT[,VALUE[,X,Y,Z]]  long hair (several allowed, in order): addScalp, cover, plant and others, as the element's
                        hair() has them
  --hair-value NAME=VALUE  a value of the selected scalp's hair (several allowed, in order with --hair)
  --size WxH            pixels, 16x16 to 8192x8192 (default 1280x720)
  --transparent         without background and ground, with the alpha of strands at the outline
  --turntable N         N pictures, 2 to 3600, of one turn of the camera, out-000.png and so on; between them goes by what
                        a turn takes
  --turn-seconds S      of such a turn (default 12), 0.1 to 600; below 0: the other way round
  --samples N           samples of the picture, 1 to 64 (default 1): what the page shows of one that stays
  --multisampling N     of each, 0 to 8 (default 4)
  --time S              seconds to run before the picture, in steps of 1/60 (default 0)
  --wetness R           soaks the whole model, 0 to 1
  --splash X,Y          one droplet at a pixel (several allowed)
  --whisker X,Y[,X2,Y2]  plants one at a pixel, dragged to another (several allowed)
  --hold TOOL,SECONDS[,X,Y]  a tool of water, pet or ball at a pixel (default: the middle), or what an animal does (several,
                        in order)
  --camera YAW,PITCH,DISTANCE[,X,Y,Z]  radians, radians, bounding radii; where it looks
  --state FILE          a state as JSON
  --preset NAME         a coat by its name, such as rabbit
  --light NAME          a light rig: daylight, studio, sunset, overcast, backlit or night
  --list-presets        all of them as JSON, and no picture
  --<setting> VALUE     over these, any field of the settings table, as --furLength 0.2 or --view skin
)";

struct GroomStep {
  app::GroomEdit edit;
  float value = 1;
  Vec3 direction{0, -1, 0};
};

// An edit, or a value of the selected scalp.
struct HairStep {
  std::optional<app::HairEdit> edit;
  std::string name{}, text{};
  float value = 1;
  Vec3 direction{0};
};

struct Hold {
  std::string tool;
  float seconds = 0;
  std::vector<float> at;
};

struct Options {
  std::string model = "bunny", output, stateFile, preset, light, hairFile, savedHair, savedTypeSet, savedCoat, savedFo, savedScene, maps, lengthMap, typeMap;
  int width = 1280, height = 720, samples = 1, multisampling = 4, turntable = 0;
  bool transparent = false;
  float turnSeconds = 12;
  float time = 0, wetness = -1;
  std::vector<Vec2> splashes;
  std::vector<std::pair<Vec2, Vec2>> whiskers;
  std::vector<Hold> holds;
  std::vector<float> camera;
  std::vector<GroomStep> grooms;
  std::vector<std::pair<app::PictureUse, std::string>> pictures;
  std::vector<HairStep> hairs;
  std::vector<std::pair<int, std::string>> typeSets, colorMaps;  // fur types, 0 to 3, and paths
  std::vector<std::pair<std::string, std::string>> fields;
};

bool readNumbers(const std::string& text, char separator, std::vector<float>& out) {
  std::size_t at = 0;
  while (at <= text.size()) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    char* stop = nullptr;
    const std::string part = text.substr(at, end - at);
    out.push_back(std::strtof(part.c_str(), &stop));
    if (part.empty() || *stop || !std::isfinite(out.back())) return false;
    at = end + 1;
  }
  return true;
}

// EDIT[,VALUE[,X,Y,Z]] as a step of `out`; `named`: the edit of a name.
template <class Step, class Named>
bool readEdit(const std::string& text, Named named, std::vector<Step>& out) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const auto edit = named(text.substr(0, comma));
  std::vector<float> n;
  if (!edit || (comma < text.size() && !readNumbers(text.substr(comma + 1), ',', n))) return false;
  Step step{*edit};
  if (!n.empty()) step.value = n[0];
  if (n.size() == 4) step.direction = {n[1], n[2], n[3]};
  out.push_back(step);
  return n.size() < 2 || n.size() == 4;
}

// Those of water, and those that touch the fur.
std::optional<app::Tool> heldTool(const std::string& name) {
  const auto tool = app::toolNamed(name);
  return tool && (app::worksOnWater(*tool) || app::traitsOf(*tool).drag == app::Drag::Touch) ? tool : std::nullopt;
}

bool readHold(const std::string& text, std::vector<Hold>& out) {
  const std::size_t comma = std::min(text.find(','), text.size() - 1);
  Hold hold{text.substr(0, comma), 0, {}};
  if (!readNumbers(text.substr(comma + 1), ',', hold.at) || (hold.at.size() != 1 && hold.at.size() != 3)) return false;
  hold.seconds = glm::clamp(hold.at[0], 0.0f, 600.0f);
  hold.at.erase(hold.at.begin());
  out.push_back(hold);
  return app::actionNamed(hold.tool) || heldTool(hold.tool);
}

// One option with its value; "" or what is wrong with it.
std::string readTypeFile(const std::string& name, const std::string& value, Options& o) {
  const bool typed = value.size() > 2 && value[0] >= '1' && value[0] <= '4' && value[1] == '=', picture = name == "--color-map";
  if (picture && !typed) return name + " " + value + ": expected TYPE=FILE";
  (picture ? o.colorMaps : o.typeSets).emplace_back(typed ? value[0] - '1' : 0, typed ? value.substr(2) : value);
  return "";
}

std::string readOption(const std::string& name, const std::string& value, Options& o) {
  std::vector<float> n;
  if (name == "-o" || name == "--output") o.output = value;
  else if (name == "--state") o.stateFile = value;
  else if (name == "--type-set" || name == "--color-map") return readTypeFile(name, value, o);
  else if (name == "--save-type-set") o.savedTypeSet = value;
  else if (name == "--save-coat") o.savedCoat = value;
  else if (name == "--hair-file") o.hairFile = value;
  else if (name == "--save-hair") o.savedHair = value;
  else if (name == "--save-fo") o.savedFo = value;
  else if (name == "--save-scene") o.savedScene = value;
  else if (name == "--maps") o.maps = value;
  else if (name == "--length-map") o.lengthMap = value;
  else if (name == "--type-map") o.typeMap = value;
  else if (name == "--preset") o.preset = value;
  else if (name == "--transparent") o.transparent = true;
  else if (name == "--light") o.light = value;
  else if (name == "--size") {
    if (!readNumbers(value, 'x', n) || n.size() != 2 || n[0] < 16 || n[1] < 16 || n[0] > 8192 || n[1] > 8192)
      return "--size " + value + ": expected WxH from 16x16 to 8192x8192";
    o.width = static_cast<int>(n[0]), o.height = static_cast<int>(n[1]);
  } else if (name == "--samples" || name == "--multisampling" || name == "--time" || name == "--wetness") {
    const bool samples = name == "--samples", multisampling = name == "--multisampling";
    const float low = samples ? 1 : 0, high = samples ? static_cast<float>(app::mostSamples()) : multisampling ? 8.0f : name == "--time" ? 3600.0f : 1.0f;
    if (!readNumbers(value, ',', n) || n.size() != 1 || n[0] < low || n[0] > high)
      return name + " " + value + ": expected a number from " + std::to_string(static_cast<int>(low)) + " to " + std::to_string(static_cast<int>(high));
    if (samples || multisampling) (samples ? o.samples : o.multisampling) = static_cast<int>(n[0]);
    else (name == "--time" ? o.time : o.wetness) = n[0];
  } else if (name == "--turntable") {
    if (!readNumbers(value, ',', n) || n.size() != 1 || n[0] < 2 || n[0] > 3600) return "--turntable " + value + ": expected a number from 2 to 3600";
    o.turntable = static_cast<int>(n[0]);
  } else if (name == "--turn-seconds") {
    if (!readNumbers(value, ',', n) || n.size() != 1 || std::abs(n[0]) < 0.1f || std::abs(n[0]) > 600)
      return "--turn-seconds " + value + ": expected 0.1 to 600, or as much below 0";
    o.turnSeconds = n[0];
  } else if (name == "--splash") {
    if (!readNumbers(value, ',', n) || n.size() != 2) return "--splash " + value + ": expected X,Y";
    o.splashes.emplace_back(n[0], n[1]);
  } else if (name == "--whisker") {
    if (!readNumbers(value, ',', n) || (n.size() != 2 && n.size() != 4)) return "--whisker " + value + ": expected X,Y or X,Y,X2,Y2";
    o.whiskers.emplace_back(Vec2(n[0], n[1]), Vec2(n[n.size() - 2], n[n.size() - 1]));
  } else if (name == "--camera") {
    if (!readNumbers(value, ',', o.camera) || (o.camera.size() != 3 && o.camera.size() != 6))
      return "--camera " + value + ": expected YAW,PITCH,DISTANCE or YAW,PITCH,DISTANCE,X,Y,Z";
  } else if (name == "--hold") {
    if (!readHold(value, o.holds)) return "--hold " + value + ": expected TOOL,SECONDS, TOOL,SECONDS,X,Y or ACTION,SECONDS";
  } else if (name == "--picture") {
    const auto comma = value.find(',');
    const auto use = app::pictureUseNamed(value.substr(0, comma));
    if (!use || comma == std::string::npos) return "--picture " + value + ": expected USE,FILE";
    o.pictures.emplace_back(*use, value.substr(comma + 1));
  } else if (name == "--groom") {
    if (!readEdit(value, app::groomEditNamed, o.grooms)) return "--groom " + value + ": expected EDIT, EDIT,VALUE or EDIT,VALUE,X,Y,Z";
  } else if (name == "--hair") {
    if (!readEdit(value, app::hairEditNamed, o.hairs)) return "--hair " + value + ": expected EDIT, EDIT,VALUE or EDIT,VALUE,X,Y,Z";
  } else if (name == "--hair-value") {
    const std::size_t equals = value.find('=');
    if (equals == std::string::npos) return "--hair-value " + value + ": expected NAME=VALUE";
    o.hairs.push_back({{}, value.substr(0, equals), value.substr(equals + 1)});
  } else if (name.rfind("--", 0) == 0 && settings::isSetting(name.substr(2))) {
    o.fields.emplace_back(name.substr(2), value);
  } else {
    return "unknown option " + name;
  }
  return "";
}

std::string readOptions(int count, char** values, Options& o) {
  if (std::string wrong = native::readArguments(count, values, o, readOption, {"--transparent"}); !wrong.empty()) return wrong;
  if (o.turntable > 0 && o.output.empty()) return "--turntable: no output: -o out.png";
  return o.output.empty() && o.savedTypeSet.empty() && o.savedCoat.empty() && o.savedFo.empty() && o.savedScene.empty() && o.savedHair.empty() && o.maps.empty() ? "no output: -o out.png" : "";
}

Status setUp(app::App& app, const Options& o, const char* program) {
  if (Status status = native::loadScene(app, o.model, program); !status) return status;
  if (!o.stateFile.empty()) {
    const auto text = native::readFile(o.stateFile);
    if (!text) return text.error();
    if (Status status = app.setState({reinterpret_cast<const char*>(text.value().data()), text.value().size()}); !status)
      return status;
  }
  if (!o.preset.empty()) app.applyPreset(o.preset);
  if (!o.light.empty()) app.setField("lightRig", o.light);
  for (const auto& [name, value] : o.fields) app.setField(name, value);
  if (const auto& c = o.camera; !c.empty())
    app.setCamera({c[0], c[1], c[2], c.size() == 6 ? Vec3(c[3], c[4], c[5]) : Vec3(0)});
  if (!o.lengthMap.empty())
    if (Status status = native::loadGroomImage(app, groom::ImageOf::Length, o.lengthMap); !status) return status;
  if (!o.typeMap.empty())
    if (Status status = native::loadGroomImage(app, groom::ImageOf::Types, o.typeMap); !status) return status;
  for (const auto& [use, path] : o.pictures)
    if (Status status = native::usePicture(app, use, path); !status) return status;
  for (const GroomStep& step : o.grooms) app.groomAll(step.edit, step.value, step.direction);
  if (!o.hairFile.empty())
    if (Status status = native::loadHair(app, o.hairFile); !status) return status;
  for (const HairStep& step : o.hairs) {
    if (step.edit) app.editHair(*step.edit, step.value, step.direction);
    else if (Status status = app.setHairValue(static_cast<int>(app.selectedScalp()), step.name, step.text); !status) return status;
  }
  // After the settings: a change of theirs would grow a coat in its place.
  for (const auto& [type, path] : o.typeSets)
    if (Status status = native::loadTypeSet(app, path, type); !status) return status;
  for (const auto& [type, path] : o.colorMaps)
    if (Status status = native::loadTypePicture(app, path, type); !status) return status;
  return Done{};
}

// As a person does with a pointer.
void plant(app::App& app, const Vec2& at, const Vec2& to) {
  app.setTool(app::Tool::Whisker);
  app::PointerEvent event{app::PointerPhase::Down};
  event.position = at;
  event.buttons = 1;
  const std::size_t before = app.whiskerCount();
  app.pointer(event);
  if (app.whiskerCount() == before) app.addWarning("--whisker " + std::to_string(at.x) + "," + std::to_string(at.y) + " misses the model");
  event.phase = app::PointerPhase::Move;
  event.position = to;
  if (to != at) app.pointer(event);
  event.phase = app::PointerPhase::Up;
  event.buttons = 0;
  app.pointer(event);
}

void run(app::App& app, float seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds * 60)); ++i) app.tick(1.0f / 60);
}

void hold(app::App& app, const Hold& hold, Vec2 middle) {
  if (const auto action = app::actionNamed(hold.tool)) {
    if (*action == app::Action::Shake) app.shake();
    else if (!app.act(hold.tool)) app.addWarning("--hold " + hold.tool + ": the model cannot do that");
    return run(app, hold.seconds);
  }
  app.setTool(*heldTool(hold.tool));
  app::PointerEvent event{app::PointerPhase::Down};
  event.position = hold.at.empty() ? middle : Vec2(hold.at[0], hold.at[1]);
  event.buttons = 1;
  app.pointer(event);
  run(app, hold.seconds);
  event.phase = app::PointerPhase::Up;
  app.pointer(event);
}

Status save(app::App& app, const Options& o) {
  if (!o.savedTypeSet.empty())
    if (Status status = native::writeFile(o.savedTypeSet, app.saveTypeSet()); !status) return status;
  if (!o.savedCoat.empty())
    if (Status status = native::writeFile(o.savedCoat, app.saveCoat(std::filesystem::path(o.savedCoat).stem().string())); !status) return status;
  if (!o.savedFo.empty())
    if (Status status = native::writeFile(o.savedFo, app.saveFo()); !status) return status;
  if (!o.savedHair.empty()) {
    const auto bytes = app.saveHairFile();
    if (!bytes) return bytes.error();
    if (Status status = native::writeFile(o.savedHair, bytes.value()); !status) return status;
  }
  if (!o.maps.empty())
    if (Status status = native::writeFiles(o.maps, app.saveMaps()); !status) return status;
  if (o.savedScene.empty()) return Done{};
  for (const std::string& lost : app.lostBySaving()) std::fprintf(stderr, "warning: %s will be without %s\n", o.savedScene.c_str(), lost.c_str());
  return native::writeFile(o.savedScene, app.saveScene());
}

void printWarnings(app::App& app) {
  for (const std::string& warning : app.takeWarnings()) std::fprintf(stderr, "warning: %s\n", warning.c_str());
}

Status saveOnly(const Options& o, const char* program) {
  app::App app;
  if (Status status = setUp(app, o, program); !status) return status;
  printWarnings(app);
  return save(app, o);
}

// One turn of the camera, without the frame that would be the first again.
template <class Write>
Status drawTurntable(app::App& app, const Options& o, Write write) {
  const app::CameraOrbit start = app.camera();
  const float seconds = std::abs(o.turnSeconds) / static_cast<float>(o.turntable);
  for (int i = 0; i < o.turntable; ++i) {
    app::CameraOrbit orbit = start;
    orbit.yaw += app::OrbitCamera::turned(seconds * static_cast<float>(i), o.turnSeconds);
    app.setCamera(orbit);
    if (Status status = write(native::numberedPath(o.output, i, o.turntable)); !status) return status;
    app::advanceFilm(app, seconds);
  }
  app.setCamera(start);
  return Done{};
}

Status drawPicture(const Options& o, const char* program) {
  app::App app;
  app.resize(o.width, o.height, 1);
  const auto context = native::EglContext::create();
  if (!context) return context.error();
  auto target = gl::Target::offscreen(o.width, o.height, o.multisampling);
  if (!target) return target.error();
  auto resolved = gl::Target::offscreen(o.width, o.height, 0);
  if (!resolved) return resolved.error();
  target->bind();
  if (Status status = app.attach(); !status) return status;
  if (Status status = setUp(app, o, program); !status) return status;
  if (o.wetness >= 0) app.setWetness(o.wetness);
  if (!o.splashes.empty() || !o.whiskers.empty()) app.settle();  // tools reach the fur as it stands
  for (const Vec2& at : o.splashes)
    if (!app.splashPixel(at, app.settings().brushRadius, app.settings().brushFlow))
      app.addWarning("--splash " + std::to_string(at.x) + "," + std::to_string(at.y) + " misses the model");
  for (const auto& [at, to] : o.whiskers) plant(app, at, to);
  app.settle();
  for (const Hold& one : o.holds) hold(app, one, 0.5f * Vec2(o.width, o.height));
  run(app, o.time);
  const auto write = [&](const std::string& path) -> Status {
    app.setSaved(true, o.transparent);
    target->bind();
    if (Status status = app.draw(app::Picture::Best, o.samples); !status) return status;
    resolved->resolve(*target, o.width, o.height);
    auto pixels = gl::readPixels(o.width, o.height);
    if (const std::string error = gl::takeError(); !error.empty()) return Error{ErrorId::WebglUnavailable, error};
    if (o.transparent) scene::makeStraight(pixels);
    if (Status status = native::writePng(path, o.width, o.height, pixels); !status) return status;
    std::printf("%s (%dx%d)\n", path.c_str(), o.width, o.height);
    std::fflush(stdout);  // of a turntable one hears how far it is
    return Done{};
  };
  if (Status status = o.turntable ? drawTurntable(app, o, write) : write(o.output); !status) return status;
  printWarnings(app);
  if (Status status = save(app, o); !status) return status;
  app.detach(false);
  return Done{};
}

}  // namespace

int main(int count, char** values) {
  if (native::asksForHelp(count, values)) return native::showHelp(kUsage);
  if (count == 2 && values[1] == std::string("--list-presets")) {
    std::printf("%s\n", settings::presetTableJson().c_str());
    return 0;
  }
  Options options;
  if (const std::string wrong = readOptions(count, values, options); !wrong.empty()) {
    return native::refuse(wrong);
  }
  app::App::keepDocuments(&scene::kDocumentKeeping);
  const bool picture = !options.output.empty();
  if (const Status status = picture ? drawPicture(options, values[0]) : saveOnly(options, values[0]); !status) {
    return native::fail(status.error());
  }
  for (const std::string& saved : {options.savedTypeSet, options.savedCoat, options.savedFo, options.savedScene, options.savedHair, options.maps})
    if (!saved.empty()) std::printf("%s\n", saved.c_str());
  return 0;
}
