// wet-fur on the desktop: the editor in a window.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>

#include "gl/Objects.h"
#include "native/Arguments.h"
#include "native/Files.h"
#include "native/window/FileDialog.h"
#include "native/window/OwnCoats.h"
#include "native/window/Shots.h"
#include "native/window/Versions.h"
#include "native/window/Window.h"
#include "scene/Formats.h"

namespace {

using namespace fur;

constexpr const char* kUsage =
    "usage: wet-fur [FILE | bunny | sphere | torus | plane | SCENE] [options]\n"
    "  FILE                  {models}, or a coat as {coats}; others can be dropped on the window\n"
    "  SCENE                 one of assets/scenes/scenes.mjs, as five-coats\n"
    "  --size WxH            of the window, default 1280x800\n"
    "  --preset NAME         a coat by its name, such as rabbit\n"
    "  --light NAME          a light rig: daylight, studio, sunset, overcast, backlit or night\n"
    "  --set name=value      a setting, as in links, over the preset; may be given several times\n"
    "  --wetness AMOUNT      0 dry to 1 soaked\n"
    "  --quality auto|fixed  auto, the default: as good as 60 frames a second allow\n"
    "  --pixel-ratio RATIO   of the panel, default the screen's\n"
    "  --screenshot OUT.png  writes the window's picture and ends\n"
    "  --frames N            frames before that, default 30\n";

// Ticks are cut to this: after a sleep the fur must not jump.
constexpr float kLongestStep = 0.5f;
constexpr float kCoatSeconds = 0.014f;  // of a frame, for a coat that grows
constexpr std::size_t kMostKeptBytes = 64u << 20;
constexpr double kIdleStep = 1.0 / 60;
constexpr double kStillAfter = 0.3;  // seconds without a change, then the picture is drawn better than moving ones are
constexpr double kDialogStep = 0.05;  // between two looks whether a file dialog has been closed
// Nothing needs it to wake up; a safety net for an event that a window system swallowed.
constexpr double kLongestSleep = 5;

struct Options {
  std::string scene = "bunny", preset, light, screenshot, quality = "auto";
  std::vector<std::pair<std::string, std::string>> settings;
  int width = 1280, height = 800, frames = 30;
  float wetness = 0, pixelRatio = 0;
};

// "" or what is wrong.
std::string readOptions(int count, char** values, Options& out) {
  for (int i = 1; i < count; ++i) {
    const std::string_view name = values[i];
    if (name.substr(0, 2) != "--") {
      out.scene = name;
      continue;
    }
    if (++i == count) return std::string(name) + " needs a value";
    const std::string value = values[i];
    if (name == "--screenshot")
      out.screenshot = value;
    else if (name == "--preset")
      out.preset = value;
    else if (name == "--light")
      out.light = value;
    else if (name == "--quality") {
      if (value != "auto" && value != "fixed") return "--quality is auto or fixed";
      out.quality = value;
    } else if (name == "--frames")
      out.frames = std::atoi(value.c_str());
    else if (name == "--wetness")
      out.wetness = std::strtof(value.c_str(), nullptr);
    else if (name == "--pixel-ratio")
      out.pixelRatio = std::strtof(value.c_str(), nullptr);
    else if (name == "--set") {
      const auto equals = value.find('=');
      if (equals == std::string::npos) return "--set needs name=value";
      out.settings.emplace_back(value.substr(0, equals), value.substr(equals + 1));
    } else if (name == "--size") {
      if (std::sscanf(value.c_str(), "%dx%d", &out.width, &out.height) != 2 || out.width < 1 ||
          out.height < 1)
        return "--size needs WxH, such as 1280x800";
    } else
      return "unknown option " + std::string(name);
  }
  return {};
}

// Where the panel's size is kept from day to day; empty where the system names no place.
std::string layoutPath() {
  const std::filesystem::path folder = native::userFolder("XDG_CONFIG_HOME", ".config");
  return folder.empty() ? "" : (folder / "panel").string();
}

// Likewise of versions and coats.
std::filesystem::path dataFolder(const char* of) {
  const std::filesystem::path folder = native::userFolder("XDG_DATA_HOME", ".local/share");
  return folder.empty() ? folder : folder / of;
}

class Session {
 public:
  Session(native::Window& window, const Options& options, std::string program)
      : window_(window), options_(options), program_(std::move(program)) {}

  Status run() {
    window_.connect(app_, host_);
    if (Status status = app_.attach(); !status) return status;
    if (Status status = host_.attach(); !status) return status;
    if (options_.pixelRatio > 0)
      host_.resize(window_.pixelSize().x, window_.pixelSize().y, options_.pixelRatio);
    if (options_.quality == "auto") app_.setQuality(0, true);
    load(options_.scene);
    // Over what it brought, and where undo begins.
    if (!options_.preset.empty()) app_.applyPreset(options_.preset);
    if (!options_.light.empty()) app_.setField("lightRig", options_.light);
    for (const auto& [name, value] : options_.settings) app_.setField(name, value);
    app_.settingsCameWithModel();
    check(app_.restoreHistory({}));
    host_.setVersions(versions_.list());
    host_.setOwnCoats(ownCoats_.list());
    if (options_.wetness > 0) app_.setWetness(options_.wetness);
    const Status status = options_.screenshot.empty() ? work() : screenshot();
    host_.detach();
    app_.detach(false);
    return status;
  }

 private:
  // A model that undo or redo leads to, and what was done on it.
  struct Kept {
    std::string scene, state;
    app::CameraOrbit camera;
    std::vector<std::uint8_t> groom, hair, water, history;
    std::vector<std::uint8_t> typeFiles;
    std::size_t bytes() const { return groom.size() + hair.size() + water.size() + history.size() + typeFiles.size(); }
  };
  Kept keep(bool leaves) const {
    return {shown_, app_.state(), app_.camera(), app_.saveGroom(), app_.saveHair(), app_.saveWater(), app_.saveHistory(leaves),
            app_.saveTypeFiles()};
  }

  void check(const Status& status) {
    if (!status) host_.message(status.error().message, true);
  }

  void load(const std::string& scene) {
    if (scene::isNamedAs(scene::FileKind::Coat, scene)) return check(native::loadTypeSet(app_, scene, host_.coatType()));
    if (scene::isNamedAs(scene::FileKind::Picture, scene)) return host_.askPicture(scene);
    if (!native::isModel(scene)) return check(native::loadScene(app_, scene, program_));
    Kept former = keep(true);
    if (const Status status = native::loadScene(app_, scene, program_); !status) return check(status);
    if (!shown_.empty()) {
      kept_.resize(at_);
      kept_.push_back(std::move(former));
      kept_.emplace_back();  // this one
      at_ = kept_.size() - 1;
      app_.followModel();
      forgetOldest();
    }
    shown_ = scene;
  }

  // What holds too much goes, but never the model before this one.
  void forgetOldest() {
    std::size_t sum = 0;
    for (const Kept& one : kept_) sum += one.bytes();
    for (; at_ > 1 && sum > kMostKeptBytes; --at_) {
      sum -= kept_.front().bytes();
      kept_.erase(kept_.begin());
    }
  }

  // The model before this one (-1) or after it, as it was left.
  void bring(int way) {
    if ((way < 0 && at_ == 0) || (way > 0 && at_ + 1 >= kept_.size())) return;
    kept_[at_] = keep(false);
    at_ = way < 0 ? at_ - 1 : at_ + 1;
    const Kept next = std::exchange(kept_[at_], {});
    check(app_.setState(next.state));  // its surface depends on it
    if (const Status status = native::loadScene(app_, next.scene, program_); !status) return check(status);
    shown_ = next.scene;
    check(app_.setState(next.state));
    check(native::restoreTypeFiles(app_, next.typeFiles));
    check(app_.restoreGroom(next.groom));
    check(app_.restoreHair(next.hair));
    check(app_.restoreWater(next.water));
    check(app_.restoreHistory(next.history));
    app_.setCamera(next.camera);
  }

  // Asks for a path, and then does the work with it, which gets "" from who gives up. Where there are no dialogs, `without` is done, and
  // said that there are none. False: one is open already.
  bool ask(native::FileDialog::Kind kind, const char* title, const std::string& suggested, std::function<void(const std::string&)> work,
           const std::function<void()>& without) {
    if (dialog_.isOpen()) return host_.message("A file dialog is open already", false), false;
    std::error_code ignored;
    if (dialog_.show(kind, title, (std::filesystem::current_path(ignored) / suggested).string())) {
      chosen_ = std::move(work);
      return true;
    }
    without();
    if (!std::exchange(toldMissing_, true)) host_.message("To be asked where files go, install zenity or kdialog", false);
    return true;
  }
  void openChosen() {
    ask(native::FileDialog::Kind::Open, "Open a model, a coat, hair or a picture", "",
        [this](const std::string& path) {
          if (!path.empty()) load(path);
        },
        [this] {
          toldMissing_ = true;
          host_.message(std::string("Type the path beside Open; ") + native::FileDialog::kMissing, true);
        });
  }

  // A scene that was saved before is written anew.
  void saveScene(const std::string& name) {
    if (savedOf_ != shown_) savedAs_.clear();
    savedOf_ = shown_;
    if (!savedAs_.empty()) return write(savedAs_, app_.saveScene());
    askAndSave(name, [this] { return app_.saveScene(); }, [this](const std::string& path) { savedAs_ = path; });
  }
  // Where the person says or, without dialogs, in the folder that the program was started in beside what is there.
  void askAndSave(const std::string& name, std::function<std::vector<std::uint8_t>()> bytes, std::function<void(const std::string&)> saved = {}) {
    const auto save = [this, bytes = std::move(bytes), saved = std::move(saved)](const std::string& path) {
      if (path.empty()) return;
      write(path, bytes());
      if (saved) saved(path);
    };
    ask(native::FileDialog::Kind::Save, "Save as", name, save, [&] { save(native::freePath(name)); });
  }
  void write(const std::string& path, const std::vector<std::uint8_t>& bytes) {
    const Status status = native::writeFile(path, bytes);
    std::error_code ignored;
    host_.message(status ? "Saved as " + std::filesystem::absolute(path, ignored).string() : status.error().message, !status);
  }

  // The panel has begun it; it is drawn once there is a path.
  void beginShots(const std::string& name) {
    const auto begin = [this](const std::string& path) {
      if (path.empty()) return host_.endPicture();
      shots_.begin(path, host_.studio().order());
      shooting_ = true;
    };
    shooting_ = false;
    if (!ask(native::FileDialog::Kind::Save, "Save as", name, begin, [&] { begin(native::freePath(name)); })) host_.endPicture();
  }

  void keepVersion(const std::string& name) {
    auto picture = host_.versionPicture();
    if (!picture) return host_.message(picture.error().message, true);
    const Status kept = versions_.keep(name, app_.modelName(), app_.saveScene(), *picture);
    check(kept);
    for (const std::string& lost : kept ? app_.lostBySaving() : Warnings()) host_.message('"' + name + "\" is kept without " + lost, false);
    host_.setVersions(versions_.list());
  }

  void changeOwnCoats(const Status& changed) {
    check(changed);
    host_.setOwnCoats(ownCoats_.list());
  }
  void saveOwnCoat(const std::string& id) {
    const auto bytes = native::readFile(ownCoats_.path(id));
    if (!bytes) return host_.message(bytes.error().message, true);
    askAndSave(id, [bytes] { return bytes.value(); });
  }

  // Over those that were saved there before.
  void saveMaps(const std::string& folder) {
    const Status status = native::writeFiles(folder, app_.saveMaps());
    std::error_code ignored;
    host_.message(status ? "Saved in " + std::filesystem::absolute(folder, ignored).string() : status.error().message, !status);
  }

  void serveEditor() {
    using Kind = app::PlatformCommand::Kind;
    while (const auto command = host_.takeCommand()) {
      switch (command->kind) {
        case Kind::OpenPath:
        case Kind::LoadShipped:
          load(command->text);
          break;
        case Kind::UsePicture: {
          const auto end = command->text.find('\n');
          if (const auto use = app::pictureUseNamed(command->text.substr(0, end))) check(native::usePicture(app_, *use, command->text.substr(end + 1)));
          break;
        }
        case Kind::CopyText:
          window_.setClipboard(command->text);
          break;
        case Kind::PasteRequest:
          host_.paste(window_.clipboard());
          break;
        case Kind::OpenDialog:
          openChosen();
          break;
        case Kind::KeepCoat:
          changeOwnCoats(ownCoats_.keep(command->text, app_.saveCoat(command->text, host_.coatType())));
          break;
        case Kind::WearCoat:
          check(native::loadTypeSet(app_, ownCoats_.path(command->text), host_.coatType()));
          break;
        case Kind::SaveOwnCoat:
          saveOwnCoat(command->text);
          break;
        case Kind::RenameCoat: {
          const auto end = command->text.find('\n');
          changeOwnCoats(ownCoats_.rename(command->text.substr(0, end), command->text.substr(end + 1)));
          break;
        }
        case Kind::DeleteCoat:
          changeOwnCoats(ownCoats_.remove(command->text));
          break;
        case Kind::SaveTypeSet:
          askAndSave(command->text, [this] { return app_.saveTypeSet(host_.coatType()); });
          break;
        case Kind::SaveFo:
          askAndSave(command->text, [this] { return app_.saveFo(); });
          break;
        case Kind::SaveHair:
          if (const auto bytes = app_.saveHairFile()) askAndSave(command->text, [bytes] { return bytes.value(); });
          else check(bytes.error());
          break;
        case Kind::SaveScene:
          saveScene(command->text);
          break;
        case Kind::SavePicture:
        case Kind::SaveTurntable:
          beginShots(command->text);
          break;
        case Kind::KeepVersion:
          keepVersion(command->text);
          break;
        case Kind::OpenVersion:
          if (const auto path = versions_.path(command->text)) load(path.value());
          else host_.message(path.error().message, true);
          break;
        case Kind::RenameVersion: {
          const auto end = command->text.find('\n');
          check(versions_.rename(command->text.substr(0, end), command->text.substr(end + 1)));
          host_.setVersions(versions_.list());
          break;
        }
        case Kind::DeleteVersion:
          versions_.remove(command->text);
          host_.setVersions(versions_.list());
          break;
        case Kind::SaveMaps:
          ask(native::FileDialog::Kind::Folder, "Save the maps in a folder", "",
              [this, name = command->text](const std::string& folder) {
                if (!folder.empty()) saveMaps((std::filesystem::path(folder) / name).string());
              },
              [&] { saveMaps(command->text); });
          break;
      }
    }
    if (const auto path = dialog_.poll()) chosen_(*path);
    for (const std::string& path : window_.takeDropped()) load(path);
    if (const int way = app_.takeModelStep()) bring(way);
    for (std::string& warning : app_.takeWarnings()) host_.message(std::move(warning), false);
    window_.setCursor(host_.cursor());
  }

  // Whether anything was drawn.
  Result<bool> frame(float dt, app::Picture picture, bool always) {
    serveEditor();
    if (host_.studio().busy() && shooting_) shots_.work(host_);
    moved_ = app::advanceFrame(app_, dt, kCoatSeconds);
    const bool changed = host_.update(dt) || moved_;
    if (!changed && !always) return false;
    // A panel that moves alone does not take away what the picture has become.
    const Result<bool> there = moved_ || always ? false : app_.showAgain();
    if (!there) return there.error();
    if (!there.value())
      if (Status status = app_.draw(picture); !status) return status.error();
    host_.draw();
    return true;
  }

  bool busy() const { return app_.active() || host_.active(); }

  // What was drawn in a hurry is not left standing when nothing changes for a while.
  Status improve() {
    for (double wait = kStillAfter; app_.improvable(); wait = 0) {
      window_.poll(wait);
      serveEditor();
      if (busy() || window_.closing()) return Done{};
      if (Status status = improveOnce(); !status) return status;
    }
    return Done{};
  }
  Status improveOnce() {
    if (!app_.improvable()) return Done{};
    const auto shown = app_.improve();
    if (!shown) return shown.error();
    gl::finish();  // else all of it would stand in front of what the person does next
    if (!shown.value()) return Done{};
    host_.draw();
    window_.present();
    return Done{};
  }

  Status loop() {
    double last = glfwGetTime(), lastShown = 0;
    bool drawn = true;
    int run = 0;  // frames drawn one after another
    while (!window_.closing()) {
      if (!busy()) {
        run = 0;
        if (app_.improvable())
          if (Status status = improve(); !status) return status;
      }
      // Presenting waits for the screen; a frame that drew nothing must not spin.
      const double sleep = dialog_.isOpen() ? kDialogStep : kLongestSleep;
      window_.poll(!busy() ? sleep : drawn ? 0 : kIdleStep);
      const double now = glfwGetTime();
      const auto result = frame(std::min(static_cast<float>(now - last), kLongestStep), app::Picture::Moving, false);
      last = now;
      if (!result) return result.error();
      drawn = result.value();
      run = drawn && moved_ ? run + 1 : 0;
      // Fur that dries changes now and then.
      if (!drawn && now - lastShown > kStillAfter)
        if (Status status = improveOnce(); !status) return status;
      if (!drawn) continue;
      window_.present();
      const double shown = glfwGetTime();
      if (run > 1) app_.frameShown(1000 * static_cast<float>(shown - lastShown));
      lastShown = shown;
    }
    return Done{};
  }

  // loop() with the panel as large as it was the last time.
  Status work() {
    const std::string path = layoutPath();
    if (const auto kept = native::readFile(path)) host_.setLayout(std::string(kept.value().begin(), kept.value().end()));
    const std::string before = host_.layout();
    const Status status = loop();
    const std::string layout = host_.layout();
    if (path.empty() || layout == before) return status;
    std::error_code ignored;  // a panel of its first size is no reason to complain
    std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
    (void)native::writeFile(path, std::vector<std::uint8_t>(layout.begin(), layout.end()));
    return status;
  }

  Status screenshot() {
    for (int i = 0; i < options_.frames; ++i) {
      window_.poll(0);
      if (const auto drawn = frame(1.0f / 60, app::Picture::Best, i + 1 == options_.frames); !drawn) return drawn.error();
    }
    const IVec2 size = window_.pixelSize();
    return native::writePng(options_.screenshot, size.x, size.y, gl::readPixels(size.x, size.y));
  }

  native::Window& window_;
  const Options& options_;
  std::string program_;
  std::string shown_;              // what load() was asked for
  std::vector<Kept> kept_;         // the one that is shown is at at_, and empty
  std::size_t at_ = 0;
  std::string savedOf_, savedAs_;  // the scene that was saved last, and its file
  native::FileDialog dialog_;
  std::function<void(const std::string&)> chosen_;  // what is done with its path
  bool toldMissing_ = false;
  bool shooting_ = false;  // a picture has its path
  bool moved_ = false;     // the picture itself, in the last frame
  native::Shots shots_;
  native::Versions versions_{dataFolder("versions")};
  native::OwnCoats ownCoats_{dataFolder("coats")};
  app::App app_;
  app::EditorHost host_{app_, editor::FileAccess::Path};
};

}  // namespace

int main(int count, char** values) {
  if (native::asksForHelp(count, values)) return native::showHelp(kUsage);
  Options options;
  if (const std::string wrong = readOptions(count, values, options); !wrong.empty()) {
    return native::refuse(wrong);
  }
  app::App::keepDocuments(&scene::kDocumentKeeping);
  auto window = native::Window::open("wet-fur", options.width, options.height);
  if (!window) return native::fail(window.error());
  Session session(**window, options, values[0]);
  if (const Status status = session.run(); !status) return native::fail(status.error());
  return 0;
}
