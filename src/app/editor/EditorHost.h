// The editor on top of an App: owns the Dear ImGui context, its GL drawing and the panel; carries
// out the panel's commands on the App, and hands those that need the platform (files, clipboard)
// to the caller. Input, from any platform, comes in through it first.
//
//   event:  if (!host.pointer(e)) app.pointer(e);
//   frame:  changed = app.tick(dt); changed |= host.update(dt);
//           if (changed) { app.draw(); host.draw(); }
//   sleep:  until the next event when neither app.active() nor host.active()
//
// The App and a current GL context must outlive attach() ... detach(). Several hosts may live side
// by side.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/App.h"
#include "app/editor/EditModes.h"
#include "app/editor/PanelPictures.h"
#include "app/editor/Studio.h"
#include "editor/Editor.h"
#include "editor/InputQueue.h"
#include "gl/Objects.h"

namespace fur::app {

// What only the platform can do.
struct PlatformCommand {
  enum class Kind {
#define FUR_PLATFORM_COMMAND(id, ...) id,
#include "app/editor/PlatformCommands.inc"
#undef FUR_PLATFORM_COMMAND
  };
  Kind kind;
  std::string text;  // the path, the text to copy, or a name for the file
  const char* name() const;  // "OpenDialog"
};

class EditorHost {
 public:
  EditorHost(App& app, editor::FileAccess fileAccess);
  ~EditorHost();
  EditorHost(const EditorHost&) = delete;
  EditorHost& operator=(const EditorHost&) = delete;

  Status attach();
  void detach();
  void resize(int width, int height, float pixelRatio);  // pixels of the drawing buffer

  // --- input; true: it was meant for the panel, the App must not see it ---
  bool pointer(const PointerEvent& event, double seconds);  // seconds: when, on any clock
  void pointerLeft();
  bool wheel(float notches, Vec2 position);  // as App::wheel: positive is down a page
  bool key(std::string_view name, bool down, const editor::Modifiers& modifiers);
  bool text(std::string_view utf8);
  // Text from the clipboard: into the text field that has the focus, else as state to take over.
  void paste(const std::string& text);
  void focusLost();

  bool wantsPointer() const { return owner_ == Owner::Panel; }
  bool wantsKeyboard() const;
  bool wantsText() const;      // a text field has the focus: show an on-screen keyboard
  bool wantsNumber() const;    // and it takes a number
  const char* cursor() const;  // the CSS name of the pointer's shape over the panel

  // --- frames ---
  // Builds the panel's next frame and carries out its commands. Returns whether it looks different.
  bool update(float dt);
  void draw();          // over what App::draw() left, in the same framebuffer
  bool active() const;  // further frames are needed, although no event may come

  // --- pictures, which the platform writes: see PlatformCommand ---
  // None: it was given up, of which the panel tells the reason.
  std::optional<Studio::Band> nextBand();
  const Studio& studio() const { return studio_; }
  void endPicture() { studio_.end(); }

  // --- scenes that are kept under names, which the platform does: see PlatformCommand ---
  using Version = KeptVersion;
  // Newest first; in place of those before.
  void setVersions(std::vector<Version> versions);
  // Coats that the person has kept, in any order; in place of those before.
  using OwnCoat = editor::OwnCoatView;
  void setOwnCoats(std::vector<OwnCoat> coats);
  // Of the scene as it is.
  Result<std::vector<std::uint8_t>> versionPicture() { return studio_.thumbnail(editor::kVersionPictureWidth, editor::kVersionPictureHeight); }

  // --- the panel's size ---
  // What the person chose, to be kept and given back the next time: see editor::PanelLayout::text().
  std::string layout() const { return editor_.layout(); }
  void setLayout(std::string_view text);
  // Desktop or CSS pixels at the right that the open panel hides with its margin; 0 where it is a sheet.
  float coveredWidth() const { return editor_.covered().x * size_.x / scale_.pixelRatio; }

  // The fur type, 0 to 3, that the panel edits: coats that are opened, dropped or saved are for it.
  int coatType() const { return editor_.coatType(); }

  // --- to and from the platform ---
  std::optional<PlatformCommand> takeCommand();
  void message(std::string text, bool isError);
  // The panel asks what the picture is, and then for PlatformCommand UsePicture of that path.
  void askPicture(std::string path);
  // A clipboard that answers at once, for the panel's text fields. Without it, what is cut or copied
  // there becomes a CopyText, and what is pasted must come in through paste().
  void setClipboard(std::function<void(const char*)> write, std::function<std::string()> read);

 private:
  enum class Owner { None, Panel, App, Modes };

  struct Context;  // makes this host's ImGui context the current one for a scope

  bool covers(Vec2 position) const;
  void wake() { framesLeft_ = kFramesAfterEvent; }
  editor::EditorModel model();
  bool picksColor(const PointerEvent& event);
  bool selects(const PointerEvent& event);
  void handToApp(const PointerEvent& event);
  bool resizeBrush(std::string_view name, bool down);
  void perform(const editor::Command& command);
  void request(PlatformCommand::Kind kind, std::string text = {}) {
    platform_.push_back({kind, std::move(text)});
  }
  void drawRing();
  void begin(const PictureOrder& order, PlatformCommand::Kind kind, std::string name);
  void turn(float dt);
  void stopTurning() { turnLeft_ = 0; }
  void check(const Status& status);
  std::uint64_t pictureHash() const;

  // ImGui settles within this many frames after an event: one to hover, one to act, one to lay out.
  static constexpr int kFramesAfterEvent = 3;
  static constexpr std::size_t kFrameHistory = 120;
  static constexpr std::size_t kMostMessages = 20;

  App& app_;
  ImGuiContext* context_;
  editor::FileAccess fileAccess_;
  editor::Editor editor_;
  editor::InputQueue input_;
  editor::ThemeScale scale_;
  Vec2 size_{0};
  Owner owner_ = Owner::None;  // of the pointer that is down
  int ownerId_ = 0;
  PointerEvent ownerLast_{PointerPhase::Up};  // where it was
  bool attached_ = false, justAttached_ = false;
  int framesLeft_ = kFramesAfterEvent;
  std::uint64_t drawnHash_ = 0, shownHash_ = 0;  // of the panel's triangles and pictures
  PanelPictures pictures_{app_};
  EditModes modes_{app_};
  editor::Selects selects_ = editor::Selects::Nothing;  // what the next press on the model does
  float bodyRadius_ = 0;                                // of a sphere or capsule that it puts there
  float frameTime_ = 0;
  std::deque<PlatformCommand> platform_;
  std::vector<editor::Message> messages_;
  std::vector<float> frameSeconds_;
  std::function<void(const char*)> writeClipboard_;
  std::function<std::string()> readClipboard_;
  std::string clipboard_;
  std::deque<std::string> askedPictures_;  // paths
  std::vector<OwnCoat> ownCoats_;
  Studio studio_{app_};
  int mostPictureSide_ = kMostPictureSide;
  float secondsPerTurn_ = 0, turnLeft_ = 0;  // of a turn that is shown; seconds
  CameraOrbit turnStart_;
};

}  // namespace fur::app
