// The groom of the model: what brush strokes and edits make of lengths, types, comb, paint, mask, shape and whiskers
// (groom/Groom.h), and what the other stages and the picture need of it at every vertex.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "app/commands/History.h"
#include "app/stages/ShapeStage.h"
#include "app/tools/FurAt.h"
#include "app/tools/GroomEdits.h"
#include "app/tools/PictureUses.h"
#include "app/tools/Tools.h"
#include "core/Random.h"
#include "core/Result.h"
#include "groom/GroomBrush.h"
#include "scene/FurData.h"
#include "settings/Settings.h"

namespace fur::app {

class GroomStage {
 public:
  struct Inputs {
    const ShapeStage& shape;
    const settings::Settings& settings;  // heights of the types; the comb of all
    unsigned grownTypes = 1;             // of the coat that is shown: the longest of them is the coat's length
  };
  // Brushes that only programs with an editor have; the viewer's download is spared them.
  struct EditorBrushes {
    void (*dab)(Tool tool, groom::Groom& groom, const groom::GroomSurface& skin, const groom::Brush& brush, const settings::Settings& settings);
    groom::GroomMap (*paintUnderMask)(const groom::Groom& groom);
  };
  static void setEditorBrushes(const EditorBrushes* brushes);
  static const EditorBrushes* editorBrushes();

  // Of another model: full length, one type, upright; `bare`: see groom::Groom.
  void reset(std::vector<std::uint8_t> bare = {});
  // Brings what it says of the vertices up to date. Whether anything has changed.
  bool update(const Inputs& inputs);
  bool active(const Inputs& inputs) const;
  // Another number whenever the groom has changed.
  std::uint64_t revision() const { return revision_; }

  const groom::Groom& groom() const { return groom_; }
  bool upright() const;  // nothing is combed
  // Where nothing is combed fur lies by itself, as far as the settings say. Not on a model whose file has a comb and does not say so.
  bool isLying() const { return isLying_; }
  bool isCombed() const { return !isLying_ || !upright(); }  // files are to have a comb
  bool isPlain() const { return groom_.isPlain() && groom_.bare == bareAtFirst_; }
  bool isBare(std::size_t material) const { return material < groom_.bare.size() && groom_.bare[material]; }
  // What the functions of groom/ know of the model.
  groom::GroomSurface groomSurface(const ShapeStage& shape);

  // --- of the vertices, as of the last update() ---
  std::uint64_t verticesRevision() const { return verticesRevision_; }
  // Of each type, a share of the coat's length.
  const groom::TypeHeights& typeHeights() const { return heights_; }
  // Height of the coat, a share of the longest; empty: 1 everywhere.
  const std::vector<float>& vertexLengths() const { return vertexLengths_; }
  // The type that most grows there, 0 to 3; empty: 0 everywhere.
  const std::vector<std::uint8_t>& vertexTypes() const { return vertexTypes_; }
  // Bends that the comb, how fur lies by itself, and the comb of the settings give, radians in model space; empty: none.
  const std::vector<Vec3>& rests() const { return rests_; }
  unsigned types() const { return types_; }                        // a bit for each that is anywhere
  bool hasLengths() const { return !plain_[0]; }  // or types: the map says more than full length of one type
  bool hasPaint() const { return !plain_[1]; }
  bool hasMask() const { return !plain_[2]; }
  bool hasShape() const { return !plain_[3]; }
  // What has changed of a map since the last call; everything after another model or size.
  geometry::TexelRect takeChanged(groom::MapKind map);
  // All whiskers' hairs on the skin as it is shown.
  std::vector<groom::WhiskerHair> hairs(const ShapeStage& shape) const;

  // --- strokes: every change is one, and ends in the step that undoes it ---
  void beginStroke(const ShapeStage& shape);
  bool stroking() const { return before_.has_value(); }
  // One dab of the tool, on both sides where the settings say so. Whiskers over the limit give a warning.
  void dab(const ShapeStage& shape, const settings::Settings& settings, Tool tool, const geometry::SurfacePoint& at, Warnings& warnings);
  // Turns the whiskers that the stroke has planted to where a ray (model space) passes their roots.
  void aimWhiskers(const ShapeStage& shape, const settings::Settings& settings, const Vec3& origin, const Vec3& direction);
  std::optional<GroomStep> endStroke();

  // --- numbers of one place (GroomPoints.cpp) ---
  // What App::furAt() tells, but for wetness.
  FurAt numbersAt(const ShapeStage& shape, const geometry::SurfacePoint& at);
  // Within a stroke: makes one of them `value` or, of the comb, `bend`, there and on the other side where the settings say so; less
  // towards the brush's rim. The stroke begins anew with it, so that a slider may be drawn to and fro.
  void setNumber(const ShapeStage& shape, const settings::Settings& settings, FurNumber what, const geometry::SurfacePoint& at, float value, const Vec3& bend);
  // Likewise a whisker.
  void setWhisker(std::size_t index, const groom::Whisker& to);
  void removeWhisker(std::size_t index);
  // Its direction, when its tip is drawn to where a ray (model space) passes its root.
  Vec3 aimed(const ShapeStage& shape, const groom::Whisker& whisker, const Vec3& origin, const Vec3& direction) const;
  // Hairs of a few whiskers on the skin as it is shown.
  std::vector<groom::WhiskerHair> hairsOf(const ShapeStage& shape, std::span<const groom::Whisker> whiskers) const;

  // Within a stroke: see GroomEdits.inc; numbers are finite.
  void clear(const ShapeStage& shape);  // GroomEdit::Clear
  void edit(const ShapeStage& shape, GroomEdit edit, float value, const Vec3& direction, const settings::Settings& settings, Warnings& warnings);
  // An image, RGBA8, in the model's texture coordinates or, by the name of its file (groom/MapPictures.h), over the atlas.
  void readImage(const ShapeStage& shape, groom::ImageOf what, std::string_view file, int width, int height, std::span<const std::uint8_t> rgba);
  // What a picture means for the fur, likewise.
  void usePicture(const ShapeStage& shape, const settings::Settings& settings, PictureUse use, int width, int height, std::span<const std::uint8_t> rgba, Warnings& warnings);
  void apply(const ShapeStage& shape, const GroomStep& step, bool undo);
  // Within a stroke.
  void setBare(std::size_t material, bool bare);

  // --- files ---
  // What a file says of the vertices of the model's mesh.
  void read(const ShapeStage& shape, const scene::FurData& fur, Warnings& warnings);
  // Of maps, comb and whiskers.
  std::uint64_t hash(const ShapeStage& shape);
  std::vector<std::uint8_t> save(const ShapeStage& shape);
  // False: they are not bytes of save() for this model, and nothing has changed.
  [[nodiscard]] bool restore(const ShapeStage& shape, std::span<const std::uint8_t> bytes);

 private:
  void touch() { ++revision_; }
  void needComb(const ShapeStage& shape);
  static std::vector<groom::WhiskerHair> posed(const ShapeStage& shape, std::vector<groom::WhiskerHair> hairs);
  void turnOver(std::size_t material, Warnings& warnings);
  void plant(const ShapeStage& shape, const settings::Settings& settings, const geometry::SurfacePoint& at, Warnings& warnings);
  void readLengths(const ShapeStage& shape);
  float lieFor(const settings::Settings& settings) const;
  void followLie(const ShapeStage& shape, const settings::Settings& settings);
  void readRests(const ShapeStage& shape);
  // From a whisker's root to where a ray passes it, as far from the eye.
  static Vec3 pullAt(const Vec3& root, const Vec3& origin, const Vec3& direction);

  groom::Groom groom_{groom::GroomMap(), {}, {}};  // its comb is empty until needComb(): upright
  std::optional<geometry::AtlasTexels> atlas_;     // made when first needed: read it through groomSurface()
  std::uint64_t atlasFor_ = 0;                     // the surface that it is of
  std::uint64_t revision_ = 1;
  std::vector<std::uint8_t> bareAtFirst_;  // as the model came
  bool isLying_ = true;                    // fur lies by itself where it is not combed: a file has not combed all of it

  // As of the last update(), and what it was for.
  std::uint64_t updatedFor_ = 0, surfaceFor_ = 0, lieSurfaceFor_ = 0, verticesRevision_ = 0;
  groom::TypeHeights heights_ = groom::kAllFull;
  Vec3 combOfAll_{0};
  float lieFor_ = 0;
  std::vector<Vec3> lie_;  // as GroomSurface has it
  std::vector<float> vertexLengths_;
  std::vector<std::uint8_t> vertexTypes_;
  std::vector<std::uint8_t> bareFor_;
  std::vector<Vec3> rests_;
  unsigned types_ = 1;
  std::array<bool, std::size(groom::kMaps)> plain_{true, true, true, true};
  std::array<geometry::TexelRect, std::size(groom::kMaps)> changed_{};

  // All whiskers' hairs on the skin at rest, and what they are of.
  mutable std::vector<groom::WhiskerHair> hairs_;
  mutable std::vector<groom::Whisker> hairsOf_;
  mutable std::uint64_t hairsFor_ = 0;  // the surface

  std::optional<groom::Groom> before_;  // the stroke at work
  std::optional<Vec3> lastDab_;         // its last dab, model space
  Random random_{1};                    // seeds of whiskers
};

}  // namespace fur::app
