// The program without its platform: a furry model, its water, its motion, the camera and the tools.
// Data flows one way: input and time go in, `tick` changes the state, `draw` shows it.
//
// Drags: on the model the tool's; elsewhere the camera's. Right button: grab; shift: spin the model;
// control: move the light; two fingers: pinch and pan. Keys: arrows orbit, + and - zoom, Home resets
// the view; with shift, or where the view is not theirs, arrows move the tool's cursor over the model, and space puts the
// tool to work there (Rain, Hose and Dryer for a moment); Ctrl+Z and Ctrl+Y.
// With the setting cameraMode "free" what turned the view round the model turns it where the camera is, and the right button does so
// everywhere; meanwhile W A S D, Space or E (up) and Control or Q (down) fly.
//
// Knows no window, file or browser; `web/` and `native/` bring those. Needs a current GL context
// only in attach(), draw() and detach().
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/stages/Touch.h"
#include "app/tools/Actions.h"
#include "app/tools/FurAt.h"
#include "app/tools/GroomEdits.h"
#include "app/tools/HairEdits.h"
#include "app/tools/PictureUses.h"
#include "app/tools/Tools.h"
#include "core/Result.h"
#include "furgen/TilePicture.h"
#include "geometry/Surface.h"
#include "groom/GroomBrush.h"
#include "hair/Scalp.h"
#include "scene/Model.h"
#include "scene/Zip.h"
#include "settings/Settings.h"
#include "wet/MaskTexels.h"
#include "wet/Water.h"
#include "wet/WetnessMask.h"

namespace fur::furgen {
struct Coat;
}
namespace fur::render {
struct ContextObjects;
struct Frame;
struct HairGrowth;
}

namespace fur::app {

enum class PointerKind { Mouse, Touch, Pen };
enum class PointerPhase { Down, Move, Up, Cancel };

struct PointerEvent {
  PointerPhase phase;
  PointerKind kind = PointerKind::Mouse;
  int id = 0;
  Vec2 position{0};      // pixels of the drawing buffer, origin top left
  int buttons = 0;       // bit 0 left, 1 right, 2 middle (what is down after the event)
  bool shift = false, control = false, alt = false;
  float pressure = 1;    // of a pen, 0..1: how much water there is
};

// Keys by their DOM names ("ArrowLeft", "+", "z").
struct KeyEvent {
  std::string_view key;
  bool shift = false, control = false, alt = false;
  bool down = true;
};

struct CameraOrbit {
  float yaw = 0.35f, pitch = 0.28f, distance = 3.0f;  // radians, radians, model units
  Vec3 target{0};
};

// What a picture is for. Best: the same scene gives the same pixels, however long that takes. Moving: one of many, as
// good as the frame budget allows. Still: it stays for a while, as good as is not unbearably slow.
enum class Picture { Best, Moving, Still };

// How far something that takes long has come. Waits: for the graphics driver, with nothing else to do.
enum class Work { Done, GoesOn, Waits };

// What all apps in one GL context share (render/ContextObjects.h). Of use where several contexts or apps live side by side.
class Context {
 public:
  // Of the context that is current, its framebuffer bound. `linksTold`: as gl::setLinksTold() has it.
  explicit Context(bool linksTold = false);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  // After the platform has made it the current one in place of another.
  void use() const;

 private:
  friend class App;
  std::shared_ptr<render::ContextObjects> objects_;
};

class ModelShelf;
std::shared_ptr<ModelShelf> makeModelShelf();

class App {
 public:
  // With a square, which is quick to make. `models`: what it shares with other apps in the program; none: nothing.
  explicit App(std::shared_ptr<ModelShelf> models = nullptr);
  ~App();

  // --- GL ---
  // Builds every GL object in the current context; `with`: what apps in it share. None: there is no other.
  Status attach(const Context* with = nullptr);
  void detach(bool lost);   // forgets them; `lost`: the context is gone, its names are not deleted
  void resize(int width, int height, float pixelRatio);

  // --- model ---
  // "sphere", "torus", "plane". A failure leaves the old scene.
  Status loadPrimitive(std::string_view name);
  // A scene that was saved brings its groom and, unless keepState, its settings and camera. They go with it: unless
  // they were changed, the next model without any is shown as the one before was.
  Status loadModel(std::span<const std::uint8_t> bytes, const std::string& name, const scene::FileSet& others = {},
                   bool keepState = false);
  // The same in pieces, for programs that have others to answer meanwhile: the one before is shown until showComing(). What takes long
  // is done by workOnComing(), for so many seconds, or a step if that takes longer; it returns whether all is.
  Status beginPrimitive(std::string_view name);
  Status beginModel(std::span<const std::uint8_t> bytes, const std::string& name, const scene::FileSet& others = {});
  bool workOnComing(float seconds);
  Status showComing(bool keepState = false);
  // The same of what the next picture needs and takes long: coat, shells and shaders. `coarse`: with a coat of fewer layers, where none is
  // shown yet; the whole one follows by tick().
  Work workOnPicture(float seconds, bool coarse = false);
  // What was set on top of the settings that the model brought, counts as them: it is no work of a person's.
  void settingsCameWithModel();
  // What was made of the model, as bytes for another program of the same build, whose next load takes it instead of making it
  // anew: most of the time that a large model takes. What does not fit is made anew.
  std::vector<std::uint8_t> saveSurface() const;
  void giveSurface(std::span<const std::uint8_t> bytes);
  // The next of the images that the model came with, still encoded, until provideImage() gives it decoded, or empty where it cannot be;
  // empty when there are no more.
  const scene::EncodedImage& pendingImage() const;
  void provideImage(int width, int height, std::vector<std::uint8_t> rgba);
  const std::string& modelName() const;
  const geometry::Surface& surface() const;
  std::uint64_t surfaceRevision() const;  // another one, above 0, whenever there is another surface
  // Names of what the model can play, one a line, for the setting `animation`, which counts from 1.
  std::string animations() const;
  // Of an animal (app/tools/Actions.inc): what it can do, one a line; what it does now; has it do that as soon as it can. Empty and
  // false for others.
  std::string actions() const;
  std::string action() const;
  bool act(std::string_view name);
  // The model as .fo, with its fur coordinates at the repeat of the settings, lengths, types and the comb.
  std::vector<std::uint8_t> saveFo() const;
  // Model, picture, groom, coat, what is wet, settings and camera as .glb, which other programs show without fur. A glTF document
  // goes back whole in programs that said so with keepDocuments(), before the model came; without, the viewer's download is spared it.
  std::vector<std::uint8_t> saveScene() const;
  // What that leaves out, each in some words.
  Warnings lostBySaving() const;
  static void keepDocuments(const scene::DocumentKeeping* with);

  // --- settings, state ---
  const settings::Settings& settings() const;
  // With undo; changes of one field in quick succession are one step.
  void setSettings(const settings::Settings& settings);
  bool setField(std::string_view name, std::string_view text);
  // Every change of settings between the two is one undo step, however long it takes (a slider
  // that is held). No step when nothing changed. Not nested.
  void beginChange();
  void endChange();
  CameraOrbit camera() const;
  void setCamera(const CameraOrbit& orbit);
  void resetCamera();
  // JSON {version, model, settings (those that differ from the defaults), camera}.
  std::string state() const;
  Status setState(std::string_view json);
  bool undo();
  bool redo();
  bool canUndo() const;
  bool canRedo() const;
  // Undo and redo lead from model to model, which the program that loads them keeps with what the save functions give.
  // takeModelStep() tells it to bring the one before (-1) or the one after (1); 0: neither. followModel() says of a model
  // that has just come that undo leads to another.
  int takeModelStep();
  void followModel();
  // What can be undone and redone with this model, as bytes that only this build reads. `leaves`: another takes its place.
  std::vector<std::uint8_t> saveHistory(bool leaves = false) const;
  Status restoreHistory(std::span<const std::uint8_t> bytes);  // of none: nothing
  // Another number whenever the settings, the tool or what can be undone have changed.
  unsigned changes() const;
  // Warnings gathered since the last call.
  Warnings takeWarnings();
  void addWarning(std::string text);

  // --- coat ---
  // A change of a generator setting grows a new coat in slices of tick(); the one before stays in the picture
  // until it is whole. settle() and finishCoat() do all of it.
  void finishCoat();
  // 0..1: how far the coat is that the settings ask for; 1: it is the one that is drawn.
  float coatProgress() const;
  // A number that is another one whenever another coat is drawn.
  std::uint64_t coatRevision() const;
  // One layer of the coat (0 = skin), or its fin map (row 0 at the bottom), as a picture for people.
  furgen::TilePicture tilePicture(int layer, furgen::TileChannel channel) const;
  furgen::TilePicture finPicture(furgen::TileChannel channel) const;
  int coatLayers() const;
  // Share of each layer that strands cover, from the skin up.
  std::span<const float> coverageByHeight() const;
  // A type set (.fts) takes the place of a type's (0 to 3) grown coat until one of its generator settings changes; a saved coat
  // (.coat) that of all that the type has, with its name. One undo step. A failure leaves the coat as it was.
  Status loadTypeSet(std::span<const std::uint8_t> bytes, const std::string& name, int type = 0);
  bool coatGiven(int type = 0) const;  // it came from one
  // A type's coat as .fts: 256 x 256 texels and 16 layers whatever the settings, as the format has it.
  std::vector<std::uint8_t> saveTypeSet(int type = 0) const;
  // A type's whole coat under that name, or under its own, as .coat (scene/CoatFile.h).
  std::vector<std::uint8_t> saveCoat(std::string_view name = {}, int type = 0) const;
  // The settings of a preset (settings/Presets.h) for a type, as one undo step. False, and a warning
  // that lists the names: there is none of that one.
  bool applyPreset(std::string_view name, int type = 0);
  // A type's colour map, in the model's texture coordinates, in place of the model's own picture: the file, which is kept for
  // saving, and RGBA8. One undo step. setField("type2.picture", "") takes it away. bad-file: it is no PNG, JPEG or WebP. Of
  // type settings::kSkin: what the skin is coloured like, in place of its colour and the model's picture.
  Status setTypePicture(int type, std::vector<std::uint8_t> file, int width, int height, std::vector<std::uint8_t> rgba);
  // Numbers of those that scenes have brought and nobody has decoded yet; their files (empty where there is none); what is in them.
  std::vector<std::uint32_t> pendingPictures() const;
  const scene::EncodedImage& typePicture(std::uint32_t number) const;
  void provideTypePicture(std::uint32_t number, int width, int height, std::vector<std::uint8_t> rgba);
  // All type sets and colour maps, for another program that has the same state: bad-file for other bytes.
  std::vector<std::uint8_t> saveTypeFiles() const;
  Status restoreTypeFiles(std::span<const std::uint8_t> bytes);

  // --- water ---
  void setTool(Tool tool);
  Tool tool() const;
  // At atlas coordinates, or at a pixel of the drawing buffer (returns whether it hit).
  void splashAt(float u, float v, float radius, float amount);
  bool splashPixel(Vec2 pixel, float radius, float amount);
  void setWetness(float amount);  // the whole model: 0 dries it, more soaks it with clumps all over
  void dry(float seconds);
  // The model shakes itself for a second, and its water flies off.
  void shake();
  // So many drops fall on it from above, as when rain begins; undo does not take them back.
  void sprinkle(int drops);
  // Wets what is opaque in a picture (one byte a texel, row by row from the top) with one clump beside the other, where
  // it lies over the model: letters. `across`: its width in pixels of the drawing buffer; `amount`: how wet they are, which
  // runs from letter to letter in seconds where fur holds much more than the default.
  void stamp(std::span<const std::uint8_t> coverage, int width, int height, Vec2 centre, float across, float amount = 0.7f);
  // All that was done with water since the model came, as JSON, see commands/WaterStrokes.h. replay() does it again on the same model, advancing the clock
  // by steps of 1/60 s between, each stroke as an undo step of its own.
  std::string recordedStrokes() const;
  Status replay(std::string_view json);
  // Those that fall or hang, in world space; the puddles and accounts are water()'s.
  std::span<const wet::Drop> drops() const;
  const wet::Water& water() const;
  float wetnessAt(float u, float v) const;
  float meanWetness() const;
  std::uint64_t wetnessHash() const;
  // The whole mask, and its way back: size * size texels.
  const wet::WetnessMask& wetnessMask() const;
  // As the shaders read it (wet/MaskEncoding.h).
  wet::MaskTexels shownMask() const;
  void restoreWetness(std::vector<Vec4> texels, std::vector<float> film = {});
  // All water and what was done with it, to go on in another App with the same model. No file: bytes that a later build may not know.
  std::vector<std::uint8_t> saveWater() const;
  Status restoreWater(std::span<const std::uint8_t> bytes);
  // The surface's atlas coordinates under a pixel of the drawing buffer; none off the model.
  std::optional<Vec2> pick(Vec2 pixel) const;
  static constexpr std::size_t kRingCorners = 64;  // the largest rings are seen as round; furapp.js has them, too
  // The footprint that the tool would have there: a ring of kRingCorners on the skin, in pixels; empty off the model, or of no brush.
  // `ofMirror`: what it would have at the same time on the other side, by the setting `mirror`.
  std::vector<Vec2> brushRing(Vec2 pixel, bool ofMirror = false) const;
  // The pixel where keys put the tool to work.
  Vec2 cursor() const;

  // The ball of the tool Ball, world space; none without that tool.
  std::optional<Ball> ball() const;

  // --- groom (groom/Groom.h); belongs to the model ---
  // What the fur at a pixel is coloured like, 0xRRGGBB: paint, or coat and the model's picture. None off the model.
  std::optional<std::uint32_t> colorAt(Vec2 pixel) const;
  // `color`: of markings, 0xRRGGBB, in place of the setting paintColor.
  void groomAll(GroomEdit edit, float value = 1, const Vec3& direction = Vec3(0, -1, 0), std::optional<std::uint32_t> color = {});
  // An image, RGBA8 in the model's own texture coordinates.
  void groomFromImage(groom::ImageOf what, int width, int height, std::span<const std::uint8_t> rgba);
  // The same by the name of its file: one that saveMaps() wrote goes back over the atlas, whatever `what` says.
  void groomFromFile(groom::ImageOf what, std::string_view name, int width, int height, std::span<const std::uint8_t> rgba);
  // As a person has said that a picture is meant; one that saveMaps() wrote, by its name, goes back all the same. `file`: as it
  // came, which scenes keep where the picture is a colour map; else a PNG is made of it. bad-file, too-large: as setTypePicture().
  Status usePicture(PictureUse use, std::string_view name, int width, int height, std::span<const std::uint8_t> rgba, std::vector<std::uint8_t> file = {});
  // Length, types, paint, mask, shape, comb (groom/MapPictures.h), wetness (grey, 255 is saturated) and the layout of the charts as
  // PNG files of the model's name, mapsName().
  std::vector<scene::NamedFile> saveMaps() const;
  std::string mapsName() const;
  // The place of the skin, model space, whose fur is seen at a pixel; none off the model.
  std::optional<Vec3> placeAt(Vec2 pixel) const;
  // The materials of the model as JSON: [{"name","triangles","furry"}], in the order of their numbers.
  std::string materials() const;
  int materialCount() const;  // its materials
  const std::string& materialName(int material) const;
  bool isFurry(int material) const;
  // Whether fur grows on one of several; with undo. bad-file for a number that is none of theirs.
  Status setFurry(int material, bool furry);
  int materialAt(Vec2 pixel) const;  // -1: off the model
  groom::Coverage groomCoverage() const;
  std::uint64_t groomRevision() const;  // another one, above 0, whenever it has changed
  bool groomed() const;  // any of it is not as a new model's
  const groom::GroomMap& groomMap() const;
  const groom::Groom& groom() const;
  std::size_t whiskerCount() const;
  // Of maps, comb and whiskers.
  std::uint64_t groomHash() const;
  // What moves over when another program takes over, likewise: bad-file for other bytes.
  std::vector<std::uint8_t> saveGroom() const;
  Status restoreGroom(std::span<const std::uint8_t> bytes, bool undoable = false);
  void clearGroom();  // GroomEdit::Clear

  // --- single places and whiskers (AppPoints.cpp); between beginChange() and endChange() all of it is one undo step ---
  std::optional<FurAt> furAt(Vec2 pixel) const;             // none off the model
  std::optional<FurAt> furAt(const Vec3& place) const;      // of the skin, model space; the nearest
  // Makes one number of a place `value` or, of the comb, `bend` (radians, model space), over the brush's size.
  void setFurAt(const Vec3& place, FurNumber what, float value, const Vec3& bend = Vec3(0));
  std::vector<Vec2> ringRound(const Vec3& place) const;     // brushRing() of what that changes
  Vec2 pixelOf(const Vec3& place) const;                    // where the fur is seen that is rooted there
  // The whisker whose line is seen nearest to the pixel, within `reach` pixels.
  std::optional<std::size_t> whiskerAt(Vec2 pixel, float reach) const;
  std::vector<Vec2> whiskerLine(std::size_t whisker) const;  // from its root, pixels; none of one off the model
  std::optional<std::size_t> plantWhisker(Vec2 pixel);       // as the tool Whisker does
  void setWhisker(std::size_t whisker, const groom::Whisker& to);
  void removeWhisker(std::size_t whisker);
  void aimWhisker(std::size_t whisker, Vec2 pixel);          // its tip goes there
  void aimPlanted(Vec2 pixel);                               // likewise those that the change has planted, on both sides

  // --- long hair (hair/Scalp.h); belongs to the model ---
  // One undo step; what cannot be done is a warning. Values and direction: HairEdits.inc.
  void editHair(HairEdit edit, float value = 1, const Vec3& direction = Vec3(0));
  // A value of a scalp (hair/HairFields.inc) from text, or its "name"; an undo step. bad-file where there is no such scalp or value.
  Status setHairValue(int scalp, std::string_view name, std::string_view text);
  // All values of a scalp; between beginChange() and endChange() one undo step with what comes there.
  void setHairValues(std::size_t scalp, const hair::HairValues& values);
  // A sphere or capsule that hair does not enter, of hairstyle().bodies; likewise.
  void setBody(std::size_t body, const hair::Body& to);
  int selectedBody() const;  // -1: none
  bool hasBones() const;     // the model can be posed by a rig
  std::size_t wispCount(std::size_t scalp) const;
  // JSON: [{"name","guides","wisps","selected","values":{all of them}}].
  std::string scalps() const;
  // Strands of a .hair file (scene/HairFile.h), as guides of the selected scalp or of a new one; one undo step. And all strands of
  // the selected scalp as they are now.
  Status loadHair(std::span<const std::uint8_t> bytes, const std::string& name);
  Result<std::vector<std::uint8_t>> saveHairFile();
  const hair::Hairstyle& hairstyle() const;
  bool haired() const;                 // there is a scalp, or a sphere for one
  std::size_t selectedScalp() const;
  // Scalps, guides and values for restoreHair() of a program with the same model.
  std::vector<std::uint8_t> saveHair() const;
  Status restoreHair(std::span<const std::uint8_t> bytes, bool undoable = false);

  // --- input; each returns whether the app used the event ---
  bool pointer(const PointerEvent& event);
  // Where a pointer is that is not down; none: it is elsewhere. Only tools of hair look at it.
  void hover(std::optional<Vec2> pixel);
  bool wheel(float notches, Vec2 position);  // positive: away from the person, zooms out
  bool key(const KeyEvent& event);
  bool looksRound() const;  // the free camera is at work: keys are for flying
  void setCameraControls(bool enabled);
  // Once nobody has been there for some seconds the camera turns round the model, unless less motion is asked for.
  void setAutoRotate(bool enabled);
  void setFieldOfView(float radians);  // of the picture's height; 10 to 90 degrees
  // How much of the picture something hides, from the right edge and from the bottom edge, as shares
  // of its width and height (a panel): the model glides to the middle of the rest. atOnce: without gliding.
  void setCovered(Vec2 shares, bool atOnce = false);
  // The same by what lies over the picture beside the panel: left, top, right, bottom. The larger of the two counts.
  void setPadding(const Vec4& shares, bool atOnce = false);
  // For a picture that is saved: while `saved`, as if nothing were covered, and without the mask that grooming tools show.
  // `transparent`: as Frame has it.
  void setSaved(bool saved, bool transparent = false);

  // --- time ---
  // Advances by dt seconds. Returns whether the picture has changed (draw it).
  // `coatBudget`: seconds of this machine's time that may go into a coat that grows; by default all it needs.
  bool tick(float dt, float coatBudget = 1e9f);
  // The fur takes the lean that the steady forces give it at once, as after a load.
  void settle();
  // Whether time alone changes things: keep ticking. False: wait for input. Fur that breathes stops after some seconds
  // without input.
  bool active() const;
  // The person asked for less motion: wind and breathing count as 0 and animations stand while true; the setting stays as it is.
  void setReducedMotion(bool reduced);
  // The mean of so many samples (render/Samples.h), 1 to mostSamples(). A shader that the driver refuses is the error.
  Status draw(Picture picture = Picture::Best, int samples = 1);
  void invalidate();  // draw at the next tick whatever happened
  // A part of a picture of another size than what is shown, as setSaved() and draw() would: `rows` of them from `bottom` on,
  // counted from the lowest, into a platform's framebuffer that has just those. What is shown next is as it was.
  struct PicturePart {
    int width, height, bottom, rows;
    bool transparent;
    int samples = 1;
  };
  Status drawPart(const PicturePart& part);
  // While true no time goes by: tick() leaves all as it is.
  void setStanding(bool stands);
  // What draw(Picture::Best) shows, for another renderer than ours: camera and light; the grown coat, nullptr when it was read
  // from a type set; how far the fur leans at every vertex of surface().
  render::Frame frame() const;
  const furgen::Coat* grownCoat() const;
  std::span<const Vec4> bends() const;
  // What grows on a scalp of hairstyle(), and where its guides' nodes are, model space.
  render::HairGrowth hairGrowth(std::size_t scalp) const;
  std::span<const hair::GuideNode> hairNodes(std::size_t scalp) const;

  // --- quality (app/QualityGovernor.h) ---
  // The best level to draw with, and whether moving and still pictures may have cheaper ones: as many as it takes to
  // hold the frame budget, by what frameShown() tells. At first level 0, and no others.
  void setQuality(int best, bool governed);
  void setFrameBudget(float milliseconds);
  // After each of several moving pictures that were drawn one right after another: milliseconds since the one before
  // was shown; of a recent one's drawing alone on the graphics processor, 0 where that cannot be known.
  void frameShown(float milliseconds, float drawing = 0);
  // Whether there is a better picture than the one that was drawn last: with all that quality levels leave out, and where the setting
  // `refine` is on of more samples, up to mostSamples(). Then there is none any more, until something changes.
  bool improvable() const;
  // A step towards that, for when nothing moves: as draw(Picture::Still), then sample after sample of the best picture in bands, out of
  // sight, of which none takes longer than a tenth of a second by what frameShown() told. Whether the framebuffer has another picture now.
  Result<bool> improve();
  // What improve() has gathered so far, once more, where nothing has changed since; false: draw() it.
  Result<bool> showAgain();
  // Of a picture that is saved: several where pictures that stay have more.
  int savedSamples() const;
  // While false pictures that stay are of one sample: for steps of given length, whose pictures are to be the same everywhere.
  void setRefining(bool refines);

  struct Stats {
    // triangles: of the model; vertices: with those that its surface has at seams and near hard edges.
    int vertices, triangles, strands, layers, finEdges;
    std::size_t cpuBytes, gpuBytes, uploadedBytes;  // cpu: the model's own data; uploaded: by the last frame
    long framesDrawn;
    // Of the last picture: its level (0 best), the pixels drawn. Median time of moving ones, ms; 0: not known.
    int level;
    long pixels;
    float frameTime;
  };
  Stats stats() const;

 private:
  void turnLight(Vec2 step);
  void changeSettings(const settings::Settings& next);  // one undo step
  Status wearCoat(std::span<const std::uint8_t> bytes, const std::string& name, int type);

  struct State;
  std::unique_ptr<State> state_;
};

int mostSamples();  // of a picture

// App::tick() for a frame, which on a slow machine takes long: in steps of at most a tenth of a second, or what is quick, as an animal that
// shakes itself, would be over between two. What is made ready, a coat or water's ways, may take `coatBudget` seconds, or a quarter of the frame
// where that is more. More than half a second is a leap, and one step. Whether there is another picture.
bool advanceFrame(App& app, float seconds, float coatBudget);
// Lets the time between two frames of a film pass, seconds, in equal steps of at most 1/60 s: the same on every machine.
void advanceFilm(App& app, float seconds);

}  // namespace fur::app
