#include "native/window/Window.h"

#include <array>
#include <string_view>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace fur::native {

namespace {

constexpr int kSamples = 4;

constexpr std::array<std::pair<int, const char*>, 20> kNamedKeys = {{
    {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_LEFT, "ArrowLeft"},
    {GLFW_KEY_RIGHT, "ArrowRight"},
    {GLFW_KEY_UP, "ArrowUp"},
    {GLFW_KEY_DOWN, "ArrowDown"},
    {GLFW_KEY_PAGE_UP, "PageUp"},
    {GLFW_KEY_PAGE_DOWN, "PageDown"},
    {GLFW_KEY_HOME, "Home"},
    {GLFW_KEY_END, "End"},
    {GLFW_KEY_INSERT, "Insert"},
    {GLFW_KEY_DELETE, "Delete"},
    {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_SPACE, " "},
    {GLFW_KEY_ENTER, "Enter"},
    {GLFW_KEY_KP_ENTER, "Enter"},
    {GLFW_KEY_ESCAPE, "Escape"},
    {GLFW_KEY_LEFT_CONTROL, "Control"},
    {GLFW_KEY_RIGHT_CONTROL, "Control"},
    {GLFW_KEY_KP_ADD, "+"},
    {GLFW_KEY_KP_SUBTRACT, "-"},
}};

// Letters and signs as the keyboard's layout names them.
std::string keyName(int key, int scancode, bool shift) {
  for (const auto& [code, name] : kNamedKeys)
    if (code == key) return name;
  const char* printed = glfwGetKeyName(key, scancode);
  std::string name = printed ? printed : "";
  // The browser names the sign that results; the plus of most layouts is a shifted key.
  if (name == "=" && shift) name = "+";
  return name;
}

std::string utf8(unsigned codepoint) {
  std::string out;
  if (codepoint < 0x80) return {static_cast<char>(codepoint)};
  if (codepoint < 0x800)
    out += static_cast<char>(0xc0 | codepoint >> 6);
  else {
    if (codepoint < 0x10000)
      out += static_cast<char>(0xe0 | codepoint >> 12);
    else {
      out += static_cast<char>(0xf0 | codepoint >> 18);
      out += static_cast<char>(0x80 | (codepoint >> 12 & 0x3f));
    }
    out += static_cast<char>(0x80 | (codepoint >> 6 & 0x3f));
  }
  return out + static_cast<char>(0x80 | (codepoint & 0x3f));
}

int buttonBit(int button) {
  return button == GLFW_MOUSE_BUTTON_LEFT ? 1 : button == GLFW_MOUSE_BUTTON_RIGHT ? 2 : 4;
}

Window& self(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

std::string glfwReason() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

GLFWwindow* create(const char* title, int width, int height, int samples) {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  glfwWindowHint(GLFW_SAMPLES, samples);
  glfwWindowHint(GLFW_DEPTH_BITS, 24);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  return glfwCreateWindow(width, height, title, nullptr, nullptr);
}

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const char* title, int width, int height) {
  if (!glfwInit()) return Error{ErrorId::WebglUnavailable, "no window system: " + glfwReason()};
  GLFWwindow* window = create(title, width, height, kSamples);
  if (!window) window = create(title, width, height, 0);
  if (!window) {
    const std::string reason = glfwReason();
    glfwTerminate();
    return Error{ErrorId::WebglUnavailable, "no window with OpenGL ES 3.0: " + reason};
  }
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  return std::unique_ptr<Window>(new Window(window));
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::connect(app::App& app, app::EditorHost& host) {
  app_ = &app;
  host_ = &host;
  arrow_ = glfwCreateStandardCursor(GLFW_ARROW_CURSOR);
  text_ = glfwCreateStandardCursor(GLFW_IBEAM_CURSOR);
  hand_ = glfwCreateStandardCursor(GLFW_HAND_CURSOR);
  across_ = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
  upDown_ = glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR);
  host.setClipboard([this](const char* text) { setClipboard(text); }, [this] { return clipboard(); });
  glfwSetWindowUserPointer(window_, this);
  installCallbacks();
  resized();
}

void Window::installCallbacks() {
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w).resized(); });
  glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { self(w).resized(); });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w).app_->invalidate(); });
  glfwSetCursorPosCallback(window_,
                           [](GLFWwindow* w, double, double) { self(w).moved(app::PointerPhase::Move); });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
    if (!entered) self(w).host_->pointerLeft();
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
    Window& window = self(w);
    const int before = window.buttons_, bit = buttonBit(button);
    window.buttons_ = action == GLFW_PRESS ? before | bit : before & ~bit;
    // As with DOM pointers: further buttons of a pointer that is down are moves.
    const bool first = before == 0, last = window.buttons_ == 0;
    window.moved(first ? app::PointerPhase::Down : last ? app::PointerPhase::Up : app::PointerPhase::Move);
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double y) {
    // GLFW counts up a page as positive, the program (as the DOM) down.
    Window& window = self(w);
    const Vec2 at = window.cursorPixels();
    const float notches = static_cast<float>(-y);
    if (!window.host_->wheel(notches, at)) window.app_->wheel(notches, at);
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int) {
    self(w).keyed(key, scancode, action);
  });
  glfwSetCharCallback(window_,
                      [](GLFWwindow* w, unsigned codepoint) { self(w).host_->text(utf8(codepoint)); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
    if (!focused) self(w).host_->focusLost();
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    self(w).dropped_.insert(self(w).dropped_.end(), paths, paths + count);
  });
}

void Window::resized() {
  float scaleX = 1, scaleY = 1;
  glfwGetFramebufferSize(window_, &size_.x, &size_.y);
  glfwGetWindowContentScale(window_, &scaleX, &scaleY);
  app_->resize(size_.x, size_.y, scaleX);
  host_->resize(size_.x, size_.y, scaleX);
}

Vec2 Window::cursorPixels() const {
  double x = 0, y = 0;
  int width = 1, height = 1;
  glfwGetCursorPos(window_, &x, &y);
  glfwGetWindowSize(window_, &width, &height);
  return Vec2(x, y) * Vec2(size_) / glm::max(Vec2(width, height), Vec2(1));
}

void Window::moved(app::PointerPhase phase) {
  app::PointerEvent event{phase};
  event.position = cursorPixels();
  event.buttons = buttons_;
  const editor::Modifiers held = modifiers();
  event.shift = held.shift;
  event.control = held.control;
  event.alt = held.alt;
  if (!host_->pointer(event, glfwGetTime())) app_->pointer(event);
}

editor::Modifiers Window::modifiers() const {
  // Not the bits of the event: on X11 those still hold a modifier that this very event lets go.
  const auto down = [this](int left, int right) {
    return glfwGetKey(window_, left) == GLFW_PRESS || glfwGetKey(window_, right) == GLFW_PRESS;
  };
  return {
      down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
      down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) || down(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER),
      down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

void Window::keyed(int key, int scancode, int action) {
  const editor::Modifiers held = modifiers();
  const std::string name = keyName(key, scancode, held.shift);
  if (host_->key(name, action != GLFW_RELEASE, held) || name.empty()) return;
  app::KeyEvent event{name};
  event.shift = held.shift;
  event.control = held.control;
  event.alt = held.alt;
  event.down = action != GLFW_RELEASE;
  app_->key(event);
}

bool Window::closing() const { return glfwWindowShouldClose(window_); }

void Window::poll(double longestSleep) {
  if (longestSleep > 0)
    glfwWaitEventsTimeout(longestSleep);
  else
    glfwPollEvents();
}

void Window::present() { glfwSwapBuffers(window_); }

std::string Window::clipboard() const {
  const char* text = glfwGetClipboardString(window_);
  return text ? text : "";
}

void Window::setClipboard(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

void Window::setCursor(const char* cssName) {
  const std::string_view name = cssName;
  glfwSetCursor(window_, name == "text" ? text_ : name == "pointer" ? hand_ : name == "ew-resize" ? across_ : name == "ns-resize" ? upDown_ : arrow_);
}

}  // namespace fur::native
