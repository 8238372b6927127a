// What App holds, and how it is wired: input -> stages -> frame. Its source files: App.cpp (model, settings, undo),
// AppTime.cpp (what time does), AppFrame.cpp (what is drawn), AppQuality.cpp (how well), AppInput.cpp (pointers and keys), AppGroom.cpp, AppWater.cpp,
// AppCoat.cpp (what programs do with a stage), AppSaving.cpp (files).
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "app/App.h"
#include "app/Picking.h"
#include "app/TypeShelf.h"
#include "app/commands/History.h"
#include "app/stages/BehaviourStage.h"
#include "app/stages/CoatStage.h"
#include "app/stages/GroomStage.h"
#include "app/stages/HairStage.h"
#include "app/stages/MotionStage.h"
#include "app/stages/ShapeStage.h"
#include "app/stages/WaterStage.h"
#include "app/view/QualityGovernor.h"
#include "app/view/View.h"
#include "core/NoteChange.h"
#include "geometry/CoatThickness.h"
#include "render/Renderer.h"
#include "settings/FurTypes.h"

namespace fur::app {

// What a model's file brings besides its shape.
struct Document {
  std::string name;
  struct Picture {
    scene::EncodedImage encoded{};
    bool asked = true;  // it has been decoded, or cannot be
    int width = 0, height = 0;
    Pixels rgba{};  // none: not decoded
  };
  std::vector<Picture> pictures{};
  std::shared_ptr<const scene::SourceFile> file{};    // a document to be saved whole
  Warnings beside{};                                  // that the saved one still needs
  std::vector<scene::Material> materials{scene::Material{}};
  std::size_t main = 0;  // the material that stands for all where there can be only one
  // The picture of a material's base colour; nullptr: it has none, or not yet.
  const Picture* pictureOf(std::size_t material) const;
  void take(scene::Model& model);  // its materials and images
  Picture* pending();  // the first that is still to be decoded
};

// Pointers that are down, and the tool.
struct Hand {
  Tool tool = Tool::Droplet;
  Tool working = Tool::Droplet;  // the one of the stroke: brushes of the coat are others on long hair
  std::map<int, Vec2> pointers{};
  Drag drag = Drag::None;
  Vec2 lastPosition{0}, lastDab{0};
  float lastSpan = 0;
  float pressure = 1;  // of the pen
  Vec2 cursor{0};      // moved by keys: from the middle of the part of the picture that nothing covers, in heights of the picture
  std::optional<Vec2> hover{};  // where a pointer is that may be up
  Vec2 pointed{0};              // where the last one was that moved
  float sincePointed = 1e9f;    // seconds
  unsigned flying = 0;  // a bit for each key of kFlyingKeys (AppInput.cpp) that is down
  float keyHold = 0;   // seconds that a key still holds the tool at the cursor
  // Of a brush of the groom that is held still: seconds that are due, steps since its last dab.
  float due = 0;
  int sinceDab = 0;
};

struct App::State {
  settings::Settings settings;
  Document document;
  std::shared_ptr<ModelShelf> models;  // what this shares with other apps
  // Of App::giveSurface(), for the next model. Only programs that call that carry what reads it.
  std::vector<std::uint8_t> givenSurface;
  std::optional<geometry::Surface> (*readSurface)(std::span<const std::uint8_t> bytes, const geometry::Mesh& mesh) = nullptr;
  TypeShelf shelf;
  // A model that is not shown yet.
  struct Coming {
    scene::Model model;
    Document document;
    geometry::FurMapping mapping;
    std::optional<ShownSurface> given{};              // of App::giveSurface()
    std::optional<ModelShelf::Coming> surface{};      // else
    bool done = false;
  };
  std::optional<Coming> coming;

  BehaviourStage behaviour;
  ShapeStage shape;
  GroomStage groom;
  CoatStage coat;
  WaterStage water;
  MotionStage motion;
  std::unique_ptr<HairStage> hair = HairStage::make();

  View view;
  Hand hand;
  History history;
  Warnings warnings;
  float idleTime = 0;  // seconds since somebody was there
  bool reducedMotion = false;
  bool paused = false;  // as setStanding() said

  // Settings and camera before the model came that brought its own, and the settings that it brought.
  struct Look {
    settings::Settings settings;
    CameraOrbit camera;
  };
  std::optional<Look> ownLook;
  std::optional<CameraOrbit> cameraOfFile{};  // where the camera goes home to, if not to startView()
  settings::Settings settingsOfFile;
  // Undo.
  int modelStep = 0;          // for App::takeModelStep()
  unsigned otherChanges = 0;  // for App::changes(): of settings and tool
  float sinceSettingChange = 1e9f;
  const settings::Field* lastField = nullptr;
  std::optional<settings::Settings> changeBefore;  // between beginChange() and endChange()

  // Drawing. `changed` counts visible changes that belong to no stage; `noticed`: the picture's revision that tick() or draw()
  // reported last.
  std::optional<render::Renderer> renderer;
  std::shared_ptr<render::ContextObjects> context;  // in which that is; none: alone
  struct Uploaded {
    std::uint64_t surface = 0, pose = 0, bends = 0, images = 0, materials = 0, shelf = 0;
    std::array<std::uint32_t, settings::kFurTypes + 1> pictures{};  // of types and skin
    std::vector<std::uint8_t> bare{};
    std::vector<groom::Whisker> whiskers{};
    std::uint64_t overPaint = 0;  // what lies over it: 0 nothing, 1 the mask, above 1 a map of hair
    bool painted = false, shaped = false, typed = false;
    struct Scalp {
      std::uint64_t growth = 0, nodes = 0;
    };
    std::vector<Scalp> scalps{};
    bool softened = true;  // the mask
  } uploaded;
  const hair::HairView* hairView = nullptr;
  std::uint64_t changed = 1, noticed = 0, imageRevision = 1, materialsRevision = 1;
  struct {
    std::uint64_t surface = 0;
    float length = -1;
    int count = 1;
    bool found = false;                               // where they stand
    std::optional<geometry::CrowdedSearch> search{};  // that goes on
  } shells;  // Frame::shellCount, and what it is for
  bool saved = false, transparent = false;  // as setSaved() said
  int bottomRow = 0, rows = 0;  // as render::Frame has them
  long framesDrawn = 0;
  std::size_t uploadedBytes = 0;
  QualityGovernor governor;
  float frameBudget = 1000.0f / 60;
  int bestLevel = 0, drawnLevel = 0;
  // Of a picture that stays: samples that are gathered, and how many the picture has that is shown; bands of the next one.
  int samplesDone = 0, samplesShown = 1;
  int bands = 1, bandsDrawn = 0;
  bool stale = false;   // what is gathered lacks a slight change
  std::uint64_t flowsBeside = 0;  // while nothing but water moves: revisionButWater() of what the samples show; or 0
  bool flowing = false;  // the picture that was drawn last is such a sample
  float bustle = 0;     // changes that came lately
  bool refines = true;  // as setRefining() said
  bool governed = false;
  bool warm = false;  // the renderer has warmed up for the coat that grows
  bool casts = false;  // shadows, while the coat is coarse: their shaders are compiled

  // --- App.cpp ---
  CameraOrbit startView() const { return OrbitCamera::fitting(shape.extent().centre, shape.extent().radius); }
  CameraOrbit homeView() const;  // with that, of what is played now
  void begin(scene::Model model, Document document);
  bool workOnComing(double budget);
  Result<ShownSurface> surfaceOfComing();
  void setModel(geometry::Mesh mesh, ShownSurface surface, Document from, scene::Rig rig = {}, std::vector<std::uint8_t> materialOf = {});
  void surfaceChanged(const CameraOrbit& viewBefore);
  // A view that showed all of the model still does; glides there or is there at once.
  void keepInView(const CameraOrbit& before, bool atOnce);
  void restoreOwnLook();
  void takeFurLength(float length);
  geometry::FurMapping mapping() const { return static_cast<geometry::FurMapping>(settings.furMapping); }
  void applySettings(const settings::Settings& next);
  settings::Settings withoutOldFiles(settings::Settings next) const;
  void applyStep(const Step& step, bool undo);
  bool askForModel(int way);

  // --- AppTime.cpp ---
  struct LayerUpload;
  BehaviourStage::Inputs behaviourInputs(float seconds);
  ShapeStage::Inputs shapeInputs(float seconds) const;
  GroomStage::Inputs groomInputs() const { return {shape, settings, coat.shownTypes()}; }
  float coatLength() const { return settings::coatLength(settings, coat.shownTypes()); }
  CoatStage::Inputs coatInputs() const { return {.settings = settings, .types = groom.types(), .given = shelf.coatsOf(settings)}; }
  WaterStage::Inputs waterInputs(float seconds, double budget) const;
  MotionStage::Inputs motionInputs(float seconds);
  HairStage::Inputs hairInputs(float seconds);
  bool turns() const { return view.autoRotate && !view.camera.isFree() && !reducedMotion && hand.pointers.empty(); }
  bool updateShape(float seconds);
  void workOnCoat(double budget, bool coarseFirst = false);
  void beginRest();
  // For the first picture of a coat, once its shaders are compiled. Whether it has, or need not any more.
  bool warmUpWhenReady();
  void finishCoat();
  void settleMotion(bool withHair = true);
  void advance(float seconds, double coatBudget);
  // Of all that is seen; another number whenever any of it has changed.
  std::uint64_t pictureRevision() const;
  std::uint64_t revisionButWater() const;  // nor what it weighs
  bool noticeChanges() { return noteChange(noticed, pictureRevision()); }

  // --- AppFrame.cpp ---
  void expect(const scene::FurData& fur, std::span<const scene::Material> materials);  // the shaders of such a model, before it is there
  void upload();
  void uploadMask(bool whole);
  void uploadMaterials();
  void uploadGroom(bool whole);
  void uploadHair();
  void uploadPictures();
  render::HairGrowth hairGrowth(std::size_t scalp) const;
  HairStage::Look hairLook(const std::optional<Vec2>& pixel) const;  // the tool points at that pixel
  // The map that the brush Scalp paints lies over the coat.
  bool showsScalp() const { return hairView && !hairView->instead && !hairView->mapColors.empty(); }
  void uploadLengths(const geometry::TexelRect& changed);
  void uploadEvenReach();
  bool showsTypes() const { return coat.shownTypes() > 1 || (renderer && renderer->hasTypePictures()); }
  bool showsMask() const;  // with the paint, for who is grooming
  bool showsForces() const { return static_cast<render::View>(settings.view) == render::View::Forces; }
  static constexpr int kCrowdedShells = 3, kSlenderShells = 2;
  // `gathered`: for samples of a picture that stays. Seconds that it may take; whether it is chosen.
  bool chooseShellCount(bool gathered, double budget = 1e9);
  render::Frame frame(int level) const;
  render::Frame frame() const { return frame(bestLevel); }

  // --- AppQuality.cpp ---
  struct Drawn {
    int level, sample = 0;
    bool gathers = false;
    int bands = 1, band = 0;
    bool flows = false;
  };
  int levelFor(Picture picture) const;
  int bandsOfBest() const;
  int samplesWanted() const;
  Status drawFrame(const Drawn& drawn);
  Status drawSamples(int level, int samples);
  bool flows() const;  // nothing but water has moved since the last picture
  Status drawFlowing();
  void forgetSamples();

  // --- AppInput.cpp ---
  Mat4 worldFromModel() const { return motion.worldFromModel(); }
  Ray rayThrough(Vec2 pixel) const { return view.rayThrough(pixel, worldFromModel()); }
  Picking picking() const { return {shape, groom, coat.coat(), water.mask(), motion.bends(), settings, coatLength()}; }
  std::optional<geometry::SurfacePoint> pick(Vec2 pixel) const { return picking().at(rayThrough(pixel)); }
  Vec2 cursorPixel() const { return view.size() * view.camera.middle() + hand.cursor * static_cast<float>(view.height); }
  Vec2 heldPixel() const { return hand.keyHold > 0 ? cursorPixel() : hand.lastPosition; }
  bool held() const { return hand.drag == Drag::Paint || hand.keyHold > 0; }
  // While a stroke is on whose tool keeps acting where the pointer stands still.
  bool toolActsWhileStill() const { return held() && (water.stroking() || groom.stroking() || hair->stroking()) && (goesOn(hand.tool) || repeats(hand.tool)); }
  void holdByKey();
  void letGo();
  bool pointerDown(const PointerEvent& event);
  // An animal looks there. Whether there is one.
  bool pointAt(Vec2 pixel);
  void dragTo(Vec2 position);
  bool useToolAtCursor();
  // Whether the key is one of them.
  bool moveCursor(std::string_view key);
  bool moveCamera(std::string_view key);
  // Beside the model, and what it becomes of a hand that lets go one of two fingers.
  Drag turning() const { return !view.cameraControls ? Drag::None : view.camera.isFree() ? Drag::Look : Drag::Orbit; }
  void look(Vec2 turn);  // radians
  bool looksRound() const { return hand.drag == Drag::Look; }
  bool takeFlyingKey(const KeyEvent& event);
  void fly(float seconds);
  void beginStroke(Vec2 pixel);  // with the tool, which begins there
  void endStroke();
  // One dab of the tool where the pixel hits; false when it misses.
  bool dabAt(Vec2 pixel);
  bool dabAt(Vec2 pixel, const std::optional<geometry::SurfacePoint>& hit);  // what it hits is known
  bool dabHair(Vec2 pixel, const std::optional<geometry::SurfacePoint>& hit);
  bool onHair(Vec2 pixel);  // the tool works on guides, bodies or hair, and one is there
  // The long hair that a pixel shows, where that is nearer than the fur there.
  std::optional<HairStage::Met> hairAt(Vec2 pixel, const std::optional<geometry::SurfacePoint>& hit);
  // Where `height` is above 0: on the hair that is rooted there, as HairStage::Met has it.
  void dabAt(const geometry::SurfacePoint& at, float height = 0);
  // Dabs along the way, so that the speed of the hand changes nothing.
  void paintTo(Vec2 pixel);
  void workWithHand(float seconds);
  // A ring round a place, as it is seen, pixels; `seenAt` gives what of the model is seen for a place on it.
  template <class Seen>
  std::vector<Vec2> ring(const Vec3& centre, const Vec3& normal, float radius, Seen&& seenAt) const;
  std::vector<Vec2> ringOn(const geometry::SurfacePoint& at, float radius) const;
  bool onBall(const Ray& ray) const;
  void touchAt(Vec2 pixel);
  void refreshTouch();  // after another tool, ball size or model

  // --- AppWater.cpp ---
  void beginWaterStroke(Command what, float radius, float flow);
  // A stroke of one point.
  void strokeOnce(Command what, float radius, float flow, const geometry::SurfacePoint& at = {}, float height = 0);
  void note(Command what) { water.note(what, settings.clumpSize); }
  // A point of a recorded stroke.
  void strokeAgain(const WaterStroke& stroke, const WaterStroke::Point& point);

  // --- AppGroom.cpp ---
  void beginGroomStroke();

  // --- AppPoints.cpp ---
  // The work as an undo step of its own, or within the change that is on.
  template <class Work>
  void changeGroom(Work&& work) {
    const bool alone = !changeBefore;
    if (alone || !groom.stroking()) beginGroomStroke();
    work();
    if (alone) endStroke();
  }
  void setWetnessAt(const geometry::SurfacePoint& at, float wetness);

  // --- AppHair.cpp ---
  void beginHairStroke();
  bool haired() const { return !hair->style().empty(); }

  // --- AppSaving.cpp ---
  Vec3 pictureAt(const geometry::SurfacePoint& at) const;
  std::vector<std::uint8_t> paintedPicture() const;
  void keepFile(Document& from, std::span<const std::uint8_t> bytes, const scene::FileSet& others) const;
  scene::FurData furData() const;
  std::vector<Vec3> combOfMesh() const;
  std::vector<std::uint8_t> saveMesh(scene::FurData fur) const;
};

}  // namespace fur::app
