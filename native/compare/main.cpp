// wet-fur-compare: how far the real-time picture looks from the reference that draws every strand.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "app/App.h"
#include "gl/Objects.h"
#include "native/Arguments.h"
#include "native/Files.h"
#include "native/headless/EglContext.h"
#include "render/Blocks.h"
#include "render/Hair.h"
#include "truth/Flip.h"
#include "truth/Truth.h"

namespace {

using namespace fur;

constexpr const char* kUsage = R"(usage: wet-fur-compare [model] [options]
  model                 a {models} file, or plain-bunny (default: without eyes), sphere, torus, plane,
                        or a scene as five-coats (assets/scenes/scenes.mjs has them all)
  --views A,B,...       of near, middle, far, grazing (default: all)
  --wetness A,B,...     how wet the coat is, 0 to 1: 0.5 is half wet, 1 soaked (default 0)
  --layers A,B,...      layers of the real-time picture (default 8,16,32,64)
  --preset NAME         a coat by its name, such as rabbit
  --variant N=V,...     one more real-time picture beside the one of the settings, with these settings over
                        them; several allowed. The reference stays that of the settings
  --size WxH            pixels, 16x16 to 2048x2048 (default 800x600)
  --light NAME          of the reference: formula (default), or traced
  --samples N           of the reference, along each side of a pixel, 1 to 16 (default 8)
  --gathered N          samples of the real-time picture, 1 to 64 (default 1)
  --out FOLDER          for the pictures and their differences (default: none are written)
  --<setting> VALUE     any field of the settings table, as --furLength 0.2; lie is 0 unless it is given
)";

struct View {
  const char* name;
  app::CameraOrbit orbit;
};
// Grazing looks along the back: outline and fur that is seen from the side fill the picture.
constexpr View kViews[] = {{"near", {0.35f, 0.2f, 1.45f, Vec3(0)}},
                           {"middle", {0.35f, 0.28f, 2.75f, Vec3(0)}},
                           {"far", {0.35f, 0.28f, 7.0f, Vec3(0)}},
                           {"grazing", {1.3f, 0.02f, 1.4f, Vec3(0.0f, 0.25f, 0.0f)}}};

using Fields = std::vector<std::pair<std::string, std::string>>;
struct Variant {
  std::string name;
  Fields fields;
};

struct Options {
  std::string model = "plain-bunny", preset, folder;
  std::vector<View> views{std::begin(kViews), std::end(kViews)};
  std::vector<float> wetness{0};
  std::vector<int> layers{8, 16, 32, 64};
  std::vector<Variant> variants{{"as set", {}}};
  int width = 800, height = 600, gathered = 1;
  truth::Options truth;
  Fields fields{{"lie", "0"}};  // which figures are of, unless it is asked for
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) parts.emplace_back();
    else parts.back() += c;
  }
  return parts;
}

// A whole number in a range; -1: it is none.
int readWhole(const std::string& text, int low, int high) {
  char* stop = nullptr;
  const long value = std::strtol(text.c_str(), &stop, 10);
  return text.empty() || *stop || value < low || value > high ? -1 : static_cast<int>(value);
}

std::string readViews(const std::string& value, Options& o) {
  o.views.clear();
  for (const std::string& name : split(value, ',')) {
    const auto found = std::find_if(std::begin(kViews), std::end(kViews), [&](const View& v) { return name == v.name; });
    if (found == std::end(kViews)) return "--views " + name + ": expected near, middle, far or grazing";
    o.views.push_back(*found);
  }
  return "";
}

std::string readLayers(const std::string& value, Options& o) {
  o.layers.clear();
  for (const std::string& word : split(value, ',')) {
    o.layers.push_back(readWhole(word, 4, 128));
    if (o.layers.back() < 0) return "--layers " + value + ": expected numbers from 4 to 128";
  }
  return "";
}

std::string readWetness(const std::string& value, Options& o) {
  o.wetness.clear();
  for (const std::string& word : split(value, ',')) {
    char* stop = nullptr;
    o.wetness.push_back(std::strtof(word.c_str(), &stop));
    if (word.empty() || *stop || !(o.wetness.back() >= 0 && o.wetness.back() <= 1)) return "--wetness " + value + ": expected numbers from 0 to 1";
  }
  return "";
}

std::string readVariant(const std::string& value, Options& o) {
  Variant variant{value, {}};
  for (const std::string& part : split(value, ',')) {
    const auto sign = part.find('=');
    if (sign == std::string::npos || !settings::findField(part.substr(0, sign)))
      return "--variant " + value + ": expected setting=value,...";
    variant.fields.emplace_back(part.substr(0, sign), part.substr(sign + 1));
  }
  o.variants.push_back(std::move(variant));
  return "";
}

// One option with its value; "" or what is wrong with it.
std::string readOption(const std::string& name, const std::string& value, Options& o) {
  if (name == "--views") return readViews(value, o);
  if (name == "--layers") return readLayers(value, o);
  if (name == "--wetness") return readWetness(value, o);
  if (name == "--variant") return readVariant(value, o);
  if (name == "--preset") o.preset = value;
  else if (name == "--out") o.folder = value;
  else if (name == "--size") {
    const auto sides = split(value, 'x');
    o.width = readWhole(sides[0], 16, 2048);
    o.height = sides.size() == 2 ? readWhole(sides[1], 16, 2048) : -1;
    if (o.width < 0 || o.height < 0) return "--size " + value + ": expected WxH from 16x16 to 2048x2048";
  } else if (name == "--light") {
    if (value != "formula" && value != "traced") return "--light " + value + ": expected formula or traced";
    o.truth.light = value == "traced" ? truth::Light::Traced : truth::Light::Formula;
  } else if (name == "--samples") {
    o.truth.samples = readWhole(value, 1, 16);
    if (o.truth.samples < 0) return "--samples " + value + ": expected a number from 1 to 16";
  } else if (name == "--gathered") {
    o.gathered = readWhole(value, 1, app::mostSamples());
    if (o.gathered < 0) return "--gathered " + value + ": expected a number from 1 to " + std::to_string(app::mostSamples());
  } else if (name.rfind("--", 0) == 0 && settings::isSetting(name.substr(2))) {
    o.fields.emplace_back(name.substr(2), value);
  } else {
    return "unknown option " + name;
  }
  return "";
}

std::vector<std::uint8_t> bytesOf(const truth::Picture& picture) {
  std::vector<std::uint8_t> rgba;
  for (const Vec3& pixel : picture.pixels) {
    for (int k = 0; k < 3; ++k) rgba.push_back(static_cast<std::uint8_t>(std::lround(saturate(pixel[k]) * 255)));
    rgba.push_back(255);
  }
  return rgba;
}

truth::Picture pictureOf(int width, int height, const std::vector<std::uint8_t>& rgba) {
  truth::Picture picture{width, height, {}};
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
    picture.pixels.push_back(Vec3(rgba[i], rgba[i + 1], rgba[i + 2]) / 255.0f);
  return picture;
}

// How far a picture is from the reference: FLIP over the whole picture, as it is defined, and over the pixels in which
// either shows something before the background; over these also the distance in CIELAB, and how much lighter
// the picture is than the reference.
struct Figures {
  float flip = 0, flipOnModel = 0, distance = 0, lighter = 0;
};

Figures figuresOf(const truth::Difference& flip, const truth::Picture& reference, const truth::Picture& picture, const truth::Picture& empty) {
  constexpr float kSame = 2.5f / 255;  // the background is dithered, and the pictures rounded
  const auto differ = [](const Vec3& p, const Vec3& q) { return glm::length(p - q) > kSame; };
  const std::vector<Vec3> a = truth::labOf(reference), b = truth::labOf(picture);
  Figures sum;
  float count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!differ(reference.pixels[i], empty.pixels[i]) && !differ(picture.pixels[i], empty.pixels[i])) continue;
    sum.flipOnModel += flip.map[i];
    sum.distance += glm::distance(a[i], b[i]);
    sum.lighter += b[i].x - a[i].x;
    ++count;
  }
  count = std::max(count, 1.0f);
  return {flip.mean, sum.flipOnModel / count, sum.distance / count, sum.lighter / count};
}

class Comparison {
 public:
  Comparison(const Options& options, app::App& app, gl::Target& target, gl::Target& resolved)
      : o_(options), app_(app), target_(target), resolved_(resolved), base_(app.settings()) {}

  Status run() {
    std::printf("flip: mean FLIP of the picture; model: of the pixels that the model covers, as the other two\n"
                "lab: distance in CIELAB; light: how much lighter than the reference, of 100\n");
    for (std::size_t k = 0; k < o_.variants.size(); ++k) std::printf("%zu: %s\n", k, o_.variants[k].name.c_str());
    std::printf("\n%-8s wetness layers", "view");
    for (std::size_t k = 0; k < o_.variants.size(); ++k) std::printf(" | %zu: flip  model   lab  light", k);
    std::printf("\n");
    for (const View& view : o_.views)
      for (const float wetness : o_.wetness)
        if (Status status = compareView(view, wetness); !status) return status;
    return Done{};
  }

 private:
  Status compareView(const View& view, float wetness) {
    app_.setSettings(base_);
    app_.setCamera(view.orbit);
    app_.setWetness(0);
    if (wetness > 0) app_.setWetness(wetness);
    app_.settle();
    const furgen::Coat* coat = app_.grownCoat();
    if (!coat) return Error{ErrorId::BadFile, "a coat of a type set has no strands to draw"};
    const std::vector<truth::LongHair> hair = longHair();
    const auto begun = std::chrono::steady_clock::now();
    const render::Frame frame = app_.frame();
    const wet::MaskTexels mask = app_.shownMask();
    truth::Scene scene{app_.surface(), *coat, app_.bends(), render::frameBlock(frame),
                       render::furBlock(frame, {.size = coat->parameters.size, .layers = frame.settings.layers}, {truth::densestSection(*coat)}, 1),
                       static_cast<dynamics::BendCurve>(frame.settings.bendCurve), hair, wetness > 0 ? &mask : nullptr};
    const truth::Picture reference = truth::render(scene, o_.width, o_.height, o_.truth);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    const std::string name = view.name + wetName(wetness);
    if (Status status = save(reference, name + "-truth"); !status) return status;
    const truth::Picture empty = emptyPicture(scene);
    std::fprintf(stderr, "%s: the reference took %.1f s\n", name.c_str(), taken.count());
    for (const int layers : o_.layers) {
      std::printf("%-8s %7.2f %6d", view.name, static_cast<double>(wetness), layers);
      for (std::size_t k = 0; k < o_.variants.size(); ++k) {
        const std::string stem = name + "-" + std::to_string(layers) + (k > 0 ? "-" + std::to_string(k) : "");
        if (Status status = compareOne(o_.variants[k], layers, stem, reference, empty); !status) return status;
      }
      std::printf("\n");
      std::fflush(stdout);
    }
    return Done{};
  }

  // In names of files: nothing where it is dry.
  static std::string wetName(float wetness) { return wetness > 0 ? "-wet" + std::to_string(std::lround(100 * wetness)) : ""; }

  Status compareOne(const Variant& variant, int layers, const std::string& stem, const truth::Picture& reference, const truth::Picture& empty) {
    app_.setSettings(base_);
    for (const auto& [name, value] : variant.fields) app_.setField(name, value);
    app_.setField("layers", std::to_string(layers));
    app_.settle();
    target_.bind();
    if (Status status = app_.draw(app::Picture::Best, o_.gathered); !status) return status;
    resolved_.resolve(target_, o_.width, o_.height);
    const truth::Picture picture = pictureOf(o_.width, o_.height, gl::readPixels(o_.width, o_.height));
    if (const std::string error = gl::takeError(); !error.empty()) return Error{ErrorId::WebglUnavailable, error};
    const truth::Difference difference = truth::flip(reference, picture);
    const Figures f = figuresOf(difference, reference, picture, empty);
    std::printf(" |  %.4f %.4f %5.1f %+6.1f", f.flip, f.flipOnModel, f.distance, f.lighter);
    if (Status status = save(picture, stem); !status) return status;
    return save(truth::heatPicture(difference), stem + "-flip");
  }

  std::vector<truth::LongHair> longHair() const {
    std::vector<truth::LongHair> out;
    for (std::size_t scalp = 0; scalp < app_.hairstyle().scalps.size(); ++scalp) {
      const render::HairGrowth growth = app_.hairGrowth(scalp);
      out.push_back({growth.wisps, growth.members, app_.hairNodes(scalp), growth.nodes, growth.values, growth.ambient, base_.hairOcclusion});
    }
    return out;
  }

  // The background alone.
  truth::Picture emptyPicture(const truth::Scene& scene) const {
    static const geometry::Surface kNothing{};
    const truth::Scene empty{kNothing, scene.strands, {}, scene.frame, scene.coat};
    truth::Options options;
    options.samples = options.shadowTexels = 1;
    return truth::render(empty, o_.width, o_.height, options);
  }

  Status save(const truth::Picture& picture, const std::string& name) const {
    if (o_.folder.empty()) return Done{};
    return native::writePng((std::filesystem::path(o_.folder) / (name + ".png")).string(), picture.width, picture.height, bytesOf(picture));
  }

  const Options& o_;
  app::App& app_;
  gl::Target& target_;
  gl::Target& resolved_;
  settings::Settings base_;
};

Status compare(const Options& o, const char* program) {
  app::App app;
  app.resize(o.width, o.height, 1);
  const auto context = native::EglContext::create();
  if (!context) return context.error();
  auto target = gl::Target::offscreen(o.width, o.height, 4);
  if (!target) return target.error();
  auto resolved = gl::Target::offscreen(o.width, o.height, 0);
  if (!resolved) return resolved.error();
  target->bind();
  if (Status status = app.attach(); !status) return status;
  if (Status status = native::loadScene(app, o.model, program); !status) return status;
  if (!o.preset.empty()) app.applyPreset(o.preset);
  for (const auto& [name, value] : o.fields) app.setField(name, value);
  // What the reference does not draw.
  app.setField("ground", "false");
  app.setField("textureAmount", "0");
  // Wet fur stays as it is.
  app.setField("dryRate", "0");
  for (const std::string& warning : app.takeWarnings()) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  if (!o.folder.empty()) {
    std::error_code failure;
    std::filesystem::create_directories(o.folder, failure);
    if (failure) return Error{ErrorId::Network, o.folder + ": " + failure.message()};
  }
  const Status status = Comparison(o, app, *target, *resolved).run();
  app.detach(false);
  return status;
}

}  // namespace

int main(int count, char** values) {
  if (native::asksForHelp(count, values)) return native::showHelp(kUsage);
  Options options;
  if (const std::string wrong = native::readArguments(count, values, options, readOption); !wrong.empty()) {
    return native::refuse(wrong);
  }
  if (const Status status = compare(options, values[0]); !status) {
    return native::fail(status.error());
  }
  return 0;
}
