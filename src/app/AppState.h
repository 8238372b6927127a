// What App holds, shared by its source files: App.cpp (scene, settings, time, drawing),
// AppCoat.cpp (the coat), AppGroom.cpp (the groom), AppMaps.cpp (its maps as pictures), AppSaving.cpp (files of it), AppPicture.cpp (pictures beside what is shown), AppQuality.cpp (levels), AppPose.cpp (animations), AppTouch.cpp
// (touch, breathing), AppWater.cpp (water by itself), Input.cpp (pointers, keys), Painting.cpp (water by hand).
#pragma once

#include <map>
#include <optional>

#include "app/App.h"
#include "app/CoatWork.h"
#include "app/History.h"
#include "app/ModelMotion.h"
#include "app/OrbitCamera.h"
#include "app/QualityGovernor.h"
#include "app/Touch.h"
#include "core/Random.h"
#include "dynamics/BendField.h"
#include "geometry/SurfaceQuery.h"
#include "groom/Groom.h"
#include "render/Renderer.h"
#include "scene/Pose.h"
#include "wet/MaskEncoding.h"
#include "wet/SurfaceWetting.h"
#include "wet/Water.h"
#include "wet/WetnessMask.h"

namespace fur::app {

inline constexpr int kMaskSize = 256;

// Two directions along the skin, square to each other.
std::pair<Vec3, Vec3> axesOn(const Vec3& normal);

// Of this machine's clock.
double secondsNow();

struct ModelRay {
  Vec3 origin, direction;  // model space
};

struct App::State {
  settings::Settings settings;
  OrbitCamera camera;
  // What they were before the model came that brought its own, and what it brought.
  struct Look {
    settings::Settings settings;
    CameraOrbit camera;
  };
  std::optional<Look> ownLook;
  settings::Settings settingsOfFile;
  ModelMotion motion;
  History history;
  int modelStep = 0;  // for App::takeModelStep()
  unsigned otherChanges = 0;  // for App::changes(): of settings and tool
  Warnings warnings;
  Tool tool = Tool::Droplet;

  // The model.
  std::string modelName;
  geometry::Mesh mesh;  // what the surface is made of, kept for another furMapping
  geometry::Surface surface;
  std::uint64_t surfaceRevision = 0;
  geometry::SurfaceQuery query;
  std::optional<wet::SurfaceWetting> wetting;
  scene::EncodedImage pendingImage, sourceImage;  // to be decoded; decoded, kept for saving
  Warnings lostOfFile;  // by saving
  Vec4 baseColorFactor{1.0f};
  int imageWidth = 0, imageHeight = 0;
  std::vector<std::uint8_t> image;
  float groundHeight = -1;
  // A sphere that holds the skin, whatever the animation does with it.
  struct Extent {
    Vec3 centre{0};
    float radius = 1;
  } extent;
  int measuredFor = -1;  // animation that it and the ground are for
  int shellCount = 1;  // Frame::shellCount, for a coat of this length
  float shellCountFor = -1;
  // What it plays. The surface stays as it was made; `skin` is where it is shown, one of each a vertex.
  scene::Rig rig;
  std::optional<scene::Pose> pose;  // none for a model without animations
  struct {
    std::vector<Vec3> positions, normals, tangents;
    std::vector<std::uint32_t> sources;  // vertices of the mesh, and those inserted between them
    // Of a surface with hard edges: the way its fur grows and a tangent in the frame of the pose without it, and which
    // vertices share them.
    struct Lean {
      Vec3 normal, tangent;
      std::uint32_t point;
    };
    std::vector<Lean> leans;
  } skin;
  std::vector<Vec3> firstTangents;
  std::pair<int, double> posedFor{-1, 0};  // animation and time of the pose
  double animationTime = 0;
  geometry::SurfaceQuery posedQuery;  // read it through shownQuery()
  bool posedQueryStale = true;

  // Water and motion.
  wet::WetnessMask mask{kMaskSize};
  std::vector<float> vertexWetness;  // read it through wetnessOfVertices()
  bool vertexWetnessStale = false;
  dynamics::BendField bends;
  Touch touch;
  double windClock = 0;
  float idleTime = 0;  // since somebody was there
  wet::Water water;
  // The water's own clock: strokes remember its steps. Seconds that are due; steps since the model came.
  float waterDue = 0;
  std::uint32_t waterSteps = 0;
  std::vector<std::uint8_t> puddles;  // how wet the ground is, as Frame has it
  std::uint32_t shownPuddles = 0;     // the water's groundRevision() that they are of
  std::uint32_t puddlesRevision = 0;  // of them
  bool forcesChanged = true;

  // The groom. The two optionals are made when they are first needed: read them through groomSurface().
  groom::Groom groom;  // its comb is empty until then: upright
  std::optional<groom::SurfacePoints> points;
  std::optional<geometry::AtlasTexels> groomAtlas;
  std::uint64_t groomRevision = 1;
  bool groomStale = false;    // fur and renderer do not know the newest yet
  bool groomed = false;       // the map is not plain
  bool shaped = false;        // nor is the map of shapes
  bool painted = false;       // the paint that is shown is not, nor is the mask over it
  std::vector<float> vertexLengths;  // what it says at the vertices; empty when it is plain
  std::optional<groom::Groom> groomBefore;  // the stroke at work
  std::optional<Vec3> lastDab;              // where its last dab was, model space
  std::vector<groom::Whisker> shownWhiskers;  // that the renderer has
  bool shownMask = false;  // likewise

  // Input.
  std::map<int, Vec2> pointers;
  Drag drag = Drag::None;
  Vec2 lastPosition{0};
  float lastSpan = 0;
  float pressure = 1;  // of the pen
  std::optional<MaskImage> strokeBefore;
  // What was done with water, to be done again: `what` is a Tool or a WaterAction. Rain, Hose and Dryer are where their newest
  // spot says, up to the last one, where they end.
  enum WaterAction { kSplash = 100, kSplashAtlas, kSoak, kDryOff, kShake, kUndo, kRedo };
  struct StrokePoint {
    std::uint32_t step;
    geometry::SurfacePoint at;
    float pressure;
  };
  struct Stroke {
    int what;
    float radius, flow, clump;
    Vec3 eye;  // where it was done from; model space
    std::vector<StrokePoint> spots;
  };
  std::vector<Stroke> strokes;
  StrokePoint held{};             // where the tool that is held is at work
  int sinceDab = 0;        // steps
  float keyHold = 0;       // seconds that a key holds it there
  bool replaying = false;  // a recorded stroke does
  Vec2 cursor{0};          // that keys move: from the middle of what is free of the picture, in its heights
  Vec2 lastSpot{0};
  Random sprayRandom{1};
  bool cameraControls = true, autoRotate = false;

  // The coat. `furChanged`: settings and groom ask for another one than coatWork or, without it, the drawn one.
  DrawnCoat coat;
  GivenCoat given;   // the coat of type 1 that was read, until a setting that grows another changes
  unsigned furTypes = 1;  // those that the groom has anywhere: groom::typesPresent()
  groom::TypeHeights typeHeights = groom::kAllFull;  // by the settings, as far as vertexLengths knows them
  unsigned workTypes = 1, shownTypes = 1;  // likewise, of coatWork and of the coat that is drawn
  std::optional<CoatWork> coatWork;
  double coatSeconds = 0;  // that coatWork has taken
  std::uint64_t coatRevision = 0;
  bool furChanged = true;
  bool coatUploaded = false;  // the renderer has a coat to draw

  // Drawing.
  std::optional<render::Renderer> renderer;
  int width = 300, height = 150;
  int bottomRow = 0;
  bool saved = false, transparent = false;  // as setSaved() said
  bool stands = false;  // as setStanding() said
  float pixelRatio = 1;
  bool pictureChanged = true;
  long framesDrawn = 0;
  std::size_t uploadedBytes = 0;
  QualityGovernor governor;
  float frameBudget = 1000.0f / 60;
  int bestLevel = 0, drawnLevel = 0;
  int bands = 1, bandsDrawn = 0;  // of the best picture, since the last one that was shown
  bool governed = false;
  float sinceSettingChange = 1e9f;
  const settings::Field* lastField = nullptr;
  std::optional<settings::Settings> changeBefore;  // between beginChange() and endChange()
  bool reducedMotion = false;

  // --- App.cpp ---
  CameraOrbit startView() const { return OrbitCamera::fitting(extent.centre, extent.radius); }
  void adopt(geometry::Mesh source, geometry::Surface built, std::string name, scene::Rig moved = {});
  void restoreOwnLook();
  void takeSurface(geometry::Surface built);
  geometry::FurMapping mapping() const { return static_cast<geometry::FurMapping>(settings.furMapping); }
  void uploadMask(const wet::TexelRect& changed);
  void uploadScene();
  void settleBends();
  bool showsForces() const { return static_cast<render::View>(settings.view) == render::View::Forces; }
  void uploadBends();  // or the forces, where those are shown
  render::Frame frame(int level) const;
  render::Frame frame() const { return frame(bestLevel); }
  void chooseShellCount();
  Status drawBand(int level, int band, int bands);
  dynamics::BendForces forces() const;
  float wind() const { return reducedMotion ? 0 : settings.wind; }
  bool turns() const { return autoRotate && !reducedMotion && pointers.empty(); }
  bool gusty() const { return (wind() > 0 && (settings.gust > 0 || settings.turbulence > 0)) || breath() > 0; }
  void applySettings(const settings::Settings& next);
  void applyStep(const Step& step, bool undo);
  bool askForModel(int way);

  // --- AppCoat.cpp ---
  void workOnCoat(double budget);
  void finishCoat();
  void showCoat(DrawnCoat next);
  void uploadCoat();

  // --- AppGroom.cpp ---
  groom::GroomSurface groomSurface();
  void newGroom();  // of another model
  void takeFur(const scene::FurData& fur);
  bool upright() const;  // nothing is combed
  void groomTouched();
  // Brings the fur's rest and lengths, and what is drawn, up to date with the groom.
  void refreshGroom();
  void readGroomMap();
  void uploadGroom(const geometry::TexelRect& changed);
  void uploadPaint(const geometry::TexelRect& changed);
  void uploadShape(const geometry::TexelRect& changed);
  void beginGroomStroke();
  void endGroomStroke();
  void groomAt(const geometry::SurfacePoint& at);
  // The place on the other side, where the settings ask for one.
  std::optional<geometry::SurfacePoint> mirrored(const geometry::SurfacePoint& at) const;
  Vec3 mirroredWay(Vec3 way) const;
  // The point of the surface nearest to a place in model space.
  std::optional<geometry::SurfacePoint> nearest(const Vec3& place) const;
  // With the paint, for who is grooming.
  bool showsMask() const;
  void refreshPaint();
  void plantWhisker(const geometry::SurfacePoint& at);
  // Turns the one that the stroke has planted to where the pixel pulls it.
  void aimWhisker(Vec2 pixel);
  void uploadWhiskers();
  void applyGroomStep(const GroomStep& step, bool undo);

  // --- AppSaving.cpp ---
  Vec3 pictureAt(const geometry::SurfacePoint& at) const;
  std::vector<std::uint8_t> paintedPicture() const;

  // --- AppPose.cpp ---
  int animation() const;  // that the settings ask for; -1: none
  bool animates() const;
  void takeRig();
  void takeSkin();
  void leanAsMade();
  void measure(bool atOnce);   // how far the animation goes; a view that showed all still does, glides or is there at once
  bool refreshPose(float dt);  // whether the shape has changed
  void uploadPose();
  // Of the surface as it is shown.
  const geometry::SurfaceQuery& shownQuery();
  Vec3 shownPosition(const geometry::SurfacePoint& at) const;
  Vec3 shownNormal(const geometry::SurfacePoint& at) const;
  void carry(std::vector<groom::WhiskerHair>& hairs) const;

  // --- AppTouch.cpp ---
  float breath() const;  // wind that idle fur stirs in
  bool onBall(const ModelRay& ray) const;
  void touchAt(Vec2 pixel);
  void refreshTouch();  // after another tool, ball size or model

  // --- AppQuality.cpp ---
  int levelFor(Picture picture) const;

  // --- AppWater.cpp ---
  bool holds(Tool one) const;
  bool atWork() const { return (strokeBefore || groomBefore) && (goesOn(tool) || repeats(tool)) && holds(tool); }
  Vec2 cursorPixel() const { return Vec2(width, height) * camera.middle() + cursor * static_cast<float>(height); }
  Vec2 cursorReach() const { return Vec2(width, height) * (0.5f / static_cast<float>(height)); }
  Vec2 heldPixel() const { return keyHold > 0 ? cursorPixel() : lastPosition; }
  // Has a tool that goes on work at the cursor for a moment.
  void holdByKey();
  wet::Climate climate();
  Vec3 dryerWind() const;  // world space, as BendForces has it
  bool runWater(float dt, double budget);
  void readPuddles();
  void workOnWith();
  void dabOn();
  void runHose();

  // --- Picking.cpp ---
  struct CoatShell;
  float coatHeight() const;
  ModelRay rayThrough(Vec2 pixel) const;
  // The root of the fur that is seen there, or bare skin.
  std::optional<geometry::SurfacePoint> pick(Vec2 pixel);
  // Where the fur is seen that is rooted there; model space.
  Vec3 seenAt(const geometry::SurfacePoint& at) const;

  // --- Painting.cpp ---
  void beginStroke();      // with the tool
  void beginWaterStroke(int what, float radius, float flow);
  void lay(const geometry::SurfacePoint& at);  // a droplet of kSplash
  void note(int deed);  // one that is no stroke
  void mark(const geometry::SurfacePoint& at = {}, float pressed = 1);  // in the stroke: it was there, now
  void endStroke();
  // One spray of the tool where the pixel hits; false when it misses.
  bool sprayAt(Vec2 pixel);
  void dabAt(const geometry::SurfacePoint& at);
  void sprayOn(const geometry::SurfacePoint& at);
  // Sprays along the way, so that the speed of the hand changes nothing.
  void paintTo(Vec2 pixel);
  void scatter(const Vec3& centre, const Vec3& normal, float radius, float amount);
  void soak(float amount);
  void dryOff(float seconds, float rate);
  void maskTouched();
  // Brought up to date when it is read: a stroke sprays many times between two steps of the fur.
  const std::vector<float>& wetnessOfVertices();
};

}  // namespace fur::app
