// The program without its platform: a furry model, its water, its motion, the camera and the tools.
// Data flows one way: input and time go in, `tick` changes the state, `draw` shows it.
// Knows no window, file or browser; `web/` and `native/` bring those. Needs a current GL context
// only in attach(), draw() and detach().
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/Result.h"
#include "scene/Model.h"
#include "settings/Settings.h"

namespace fur::app {

enum class Tool { Droplet, Dry, None };
enum class PointerKind { Mouse, Touch, Pen };
enum class PointerPhase { Down, Move, Up, Cancel };

struct PointerEvent {
  PointerPhase phase;
  PointerKind kind = PointerKind::Mouse;
  int id = 0;
  Vec2 position{0};      // pixels of the drawing buffer, origin top left
  int buttons = 0;       // bit 0 left, 1 right, 2 middle (what is down after the event)
  bool shift = false, control = false, alt = false;
};

// Keys by their DOM names ("ArrowLeft", "+", "z").
struct KeyEvent {
  std::string_view key;
  bool shift = false, control = false, alt = false;
};

struct CameraOrbit {
  float yaw = 0.35f, pitch = 0.28f, distance = 3.0f;  // radians, radians, model units
  Vec3 target{0};
};

class App {
 public:
  App();
  ~App();

  // --- GL ---
  Status attach();          // builds every GL object in the current context
  void detach(bool lost);   // forgets them; `lost`: the context is gone, its names are not deleted
  void resize(int width, int height, float pixelRatio);

  // --- model ---
  // "sphere", "torus", "plane". A failure leaves the old scene.
  Status loadPrimitive(std::string_view name);
  Status loadModel(std::span<const std::uint8_t> bytes, const std::string& name, const scene::FileSet& others = {});
  // The base colour image that the model came with, still encoded; empty when there is none.
  const scene::EncodedImage& pendingImage() const;
  void provideImage(int width, int height, std::vector<std::uint8_t> rgba);
  const std::string& modelName() const;
  const geometry::Surface& surface() const;

  // --- settings, state ---
  const settings::Settings& settings() const;
  // With undo; changes of one field in quick succession are one step.
  void setSettings(const settings::Settings& settings);
  bool setField(std::string_view name, std::string_view text);
  CameraOrbit camera() const;
  void setCamera(const CameraOrbit& orbit);
  void resetCamera();
  // JSON {version, model, settings (those that differ from the defaults), camera}.
  std::string state() const;
  Status setState(std::string_view json);
  bool undo();
  bool redo();
  // Warnings gathered since the last call.
  Warnings takeWarnings();

  // --- water ---
  void setTool(Tool tool);
  Tool tool() const;
  // At atlas coordinates, or at a pixel of the drawing buffer (returns whether it hit).
  void splashAt(float u, float v, float radius, float amount);
  bool splashPixel(Vec2 pixel, float radius, float amount);
  void setWetness(float amount);  // the whole model: 0 dries it, more soaks it with clumps all over
  void dry(float seconds);
  float wetnessAt(float u, float v) const;
  float meanWetness() const;
  std::uint64_t wetnessHash() const;

  // --- input; each returns whether the app used the event ---
  bool pointer(const PointerEvent& event);
  bool wheel(float notches, Vec2 position);  // positive: away from the person, zooms out
  bool key(const KeyEvent& event);
  void setCameraControls(bool enabled);

  // --- time ---
  // Advances by dt seconds. Returns whether the picture has changed (draw it).
  bool tick(float dt);
  // Whether time alone changes things: keep ticking. False: wait for input.
  bool active() const;
  void draw();
  void invalidate();  // draw at the next tick whatever happened

  struct Stats {
    int vertices, triangles, strands, layers, finEdges;
    std::size_t cpuBytes, gpuBytes, uploadedBytes;  // uploaded: by the last frame
    long framesDrawn;
  };
  Stats stats() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fur::app
