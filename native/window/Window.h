// A desktop window with an OpenGL ES 3 context, and its input in the program's own terms: pixels of
// the drawing buffer, DOM key names. Input goes to the editor first, then to the App.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/App.h"
#include "app/editor/EditorHost.h"
#include "core/Result.h"

struct GLFWwindow;
struct GLFWcursor;

namespace fur::native {

class Window {
 public:
  // Opens it and makes its context current. Sizes in desktop pixels.
  static Result<std::unique_ptr<Window>> open(const char* title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // From now on events go to these two, which must outlive the window's last poll().
  void connect(app::App& app, app::EditorHost& host);

  bool closing() const;
  // Takes what has come in, after sleeping until something does but for at most that many seconds.
  void poll(double longestSleep);
  void present();
  IVec2 pixelSize() const { return size_; }
  // Files dropped since the last call.
  std::vector<std::string> takeDropped() { return std::exchange(dropped_, {}); }
  std::string clipboard() const;
  void setClipboard(const std::string& text);
  void setCursor(const char* cssName);

 private:
  explicit Window(GLFWwindow* window) : window_(window) {}
  void installCallbacks();
  void resized();
  void moved(app::PointerPhase phase);
  void keyed(int key, int scancode, int action);
  editor::Modifiers modifiers() const;
  Vec2 cursorPixels() const;

  GLFWwindow* window_;
  app::App* app_ = nullptr;
  app::EditorHost* host_ = nullptr;
  IVec2 size_{0};
  int buttons_ = 0;
  std::vector<std::string> dropped_;
  GLFWcursor *arrow_ = nullptr, *text_ = nullptr, *hand_ = nullptr, *across_ = nullptr, *upDown_ = nullptr;
};

}  // namespace fur::native
