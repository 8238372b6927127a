// The water on the model: what strokes, drops and time make of the wetness mask, the film on it and the drops
// (wet/Water.h). Remembers the strokes, so that they can be done again. Has a clock of its own, in steps of Water::kStep.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/commands/History.h"
#include "app/commands/WaterStrokes.h"
#include "app/stages/GroomStage.h"
#include "app/stages/HairStage.h"
#include "app/stages/ShapeStage.h"
#include "core/Random.h"
#include "settings/Settings.h"
#include "wet/ChartBorders.h"
#include "wet/MaskEncoding.h"
#include "wet/SurfaceWetting.h"
#include "wet/Water.h"
#include "wet/WetnessMask.h"

namespace fur::app {

class WaterStage {
 public:
  static constexpr int kMaskSize = 256;
  // Steps between two dabs of a brush that is held still.
  static constexpr int kDabSteps = 8;

  struct Inputs {
    const ShapeStage& shape;
    const GroomStage& groom;  // how the fur lies
    const settings::Settings& settings;
    Mat4 worldFromModel{1.0f};  // rigid
    float coatLength = 0.12f;   // of the longest strand, model units
    float wind = 0;             // strength of the settings, or 0
    float shaking = 0;          // 0..1: how hard the model shakes itself
    bool bySkin = false;        // by the motion of its skin, as which water flies off
    float seconds = 0;          // that have passed
    double budget = 1e9;        // seconds of this machine's time for finding the water's ways on a new model
  };

  void reset();  // of another model
  // What it wets beside skin and coat; none until then.
  void setHair(HairStage& hair) { hair_ = &hair; }
  // What says on which materials no fur grows: those take no water. All do until then.
  void setGroom(const GroomStage& groom) { groom_ = &groom; }
  // Time goes by: it dries, runs and falls, and the tool that is held works. Whether anything has changed.
  bool update(const Inputs& inputs);
  bool active(const Inputs& inputs) const { return working() || flows(climate(inputs)); }
  // Another number when what can be seen has changed; water that creeps or dries slowly changes it every few seconds.
  std::uint64_t revision() const { return revision_; }

  // --- strokes: each ends in the step that undoes it ---
  // `head`: all of the stroke but its points.
  void beginStroke(WaterStroke head);
  bool stroking() const { return before_.has_value(); }
  // A stroke, or a part of it, at a point: what the command does there, or all over. `height` above 0: on the long hair that is
  // rooted there, at that share of its length.
  void strokeAt(const ShapeStage& shape, const geometry::SurfacePoint& at, float pressure = 1, float height = 0);
  // The same on both sides where the settings say so.
  void dab(const ShapeStage& shape, const settings::Settings& settings, const geometry::SurfacePoint& at, float pressure, float height = 0);
  // Where the tool of the stroke is held during the next update(); none: off the model.
  void hold(std::optional<geometry::SurfacePoint> at, float pressure, float height = 0);
  // A tool is held that goes on.
  bool working() const { return before_ && held_; }
  bool holds(Tool tool) const { return working() && toolOf(strokes_.back().what) == tool; }
  std::optional<MaskStep> endStroke();
  // A command that is no stroke of its own: Shake, Undo, Redo.
  void note(Command what, float clump);
  void apply(const MaskStep& step, bool undo);
  // Water on parts that have become bare, before the next update() takes it; back again once they are furry.
  DriedParts onBareParts(const ShapeStage& shape);
  void putBack(const DriedParts& parts);

  // Some drops fall from above it; no stroke.
  void sprinkle(const ShapeStage& shape, const Mat4& worldFromModel, int drops);

  const std::vector<WaterStroke>& strokes() const { return strokes_; }
  std::uint32_t steps() const { return steps_; }  // of the clock, since the model came
  // The next step begins now.
  void alignClock() { due_ = 0; }

  // --- what there is ---
  const wet::WetnessMask& mask() const { return mask_; }
  bool isWet() const;  // anything is: the mask, hair, the ground, or a drop is on its way
  const wet::Water& water() const { return water_; }
  // Triangles on which drops or a tool have brought water since forgetLanded(); some of them, if they are many.
  std::span<const std::uint32_t> landed() const { return landed_; }
  void forgetLanded() { landed_.clear(); }
  // How charts go on beyond their borders, where it is anew since the last call, or `all`; else, and while nothing has been wet, null. All texels
  // are to be taken after it.
  const wet::ChartBorders* takeBorders(const ShapeStage& shape, bool all);
  // Parts of the mask that have changed for the picture since the last call, or all of it: in bands, as all at once would be another mask's
  // memory.
  static constexpr int kBandTexels = 8192;
  std::vector<wet::TexelRect> takeChanged(const ShapeStage& shape, bool all);
  // What the picture takes of a part. `softened`: see wet/MaskEncoding.h.
  wet::MaskTexels texels(const ShapeStage& shape, const wet::TexelRect& part, bool softened);
  // All of it, whatever has changed, with gutters that lead nowhere.
  wet::MaskTexels texels(const ShapeStage& shape);
  // 0..1, one a vertex of the surface; vertices of one point have the same. Changes by what fur feels of it, vertexRevision() with it.
  const std::vector<float>& vertexWetness(const ShapeStage& shape);
  std::uint64_t vertexRevision(const ShapeStage& shape) { return vertexWetness(shape), vertexRevision_; }
  float meanWetness(const ShapeStage& shape);
  // How wet the ground is, 0..255, as render::Frame has it; empty: dry. Of the last readPuddles(), which changes its
  // revision when the change is visible.
  void readPuddles();
  const std::vector<std::uint8_t>& puddles() const { return puddles_; }
  std::uint32_t puddlesRevision() const { return puddlesRevision_; }

  // --- files ---
  // Texels and film of a mask of kMaskSize.
  void restoreMask(std::vector<Vec4> texels, std::vector<float> film = {});
  // Of a mask of another size, row-major.
  void readMask(const std::vector<Vec4>& texels, int size);
  // All water and, unless it is for a file, what was done with it, to go on in another program with the same model.
  std::vector<std::uint8_t> save(bool forFile = false) const;
  // False: these are no bytes of save() for this model, and nothing has changed.
  [[nodiscard]] bool restore(std::span<const std::uint8_t> bytes);

 private:
  struct Held {
    geometry::SurfacePoint at;
    float pressure, height;
  };
  wet::WetHair* wetHair() const { return hair_ ? hair_->wetHair() : nullptr; }
  bool flows(const wet::Climate& climate) const { return water_.active(mask_, climate) || (wetHair() && wetHair()->active(climate)); }
  // Of the point where the tool is held, as it is shown; model space.
  Vec3 placeOfHeld(const ShapeStage& shape) const { return hair_ ? hair_->placeOf(shape, held_->at, held_->height) : shape.shownPosition(held_->at); }
  wet::WaterAround* around(const ShapeStage& shape);
  // What the texels of the mask lie on.
  const wet::SurfaceWetting& wetting(const ShapeStage& shape);
  wet::Climate climate(const Inputs& inputs) const;
  void layDown(const GroomStage& groom);
  void work(const Inputs& inputs);
  void pourFromHose(const Inputs& inputs);
  void mark(const geometry::SurfacePoint& at, float pressure, float height = 0) { strokes_.back().points.push_back({steps_, at, pressure, height}); }
  void scatter(const ShapeStage& shape, const Vec3& centre, const Vec3& normal, float radius, float clump, float amount);
  void soak(const ShapeStage& shape, float amount, float clump);
  void touch();
  void noteStep(float change);
  void placeVertices(const ShapeStage& shape);
  void noteLanded(std::span<const std::uint32_t> triangles);

  std::vector<std::uint32_t> landed_;
  wet::WetnessMask mask_{kMaskSize};
  wet::Water water_;
  HairStage* hair_ = nullptr;
  const GroomStage* groom_ = nullptr;
  std::optional<wet::SurfaceWetting> wetting_;  // made when first needed: read it through wetting()
  std::optional<wet::WaterAround> around_;      // likewise, through around()
  std::optional<wet::ChartBorders> borders_;    // made with around_
  bool bordersAnew_ = false;
  std::uint64_t wettingFor_ = 0, layFor_ = 0;   // revisions of surface and groom
  std::vector<std::uint8_t> bareFor_;
  std::uint64_t revision_ = 1;
  float unseen_ = 0;                            // sum of what steps have changed since, each where it changed most
  std::uint32_t unseenSteps_ = 0;

  std::vector<WaterStroke> strokes_;
  std::optional<MaskImage> before_;  // the stroke at work
  std::vector<float> hairBefore_, groundBefore_;
  std::optional<Held> held_;
  int sinceDab_ = 0;   // steps
  Random random_{1}, sprinkled_{23};
  float due_ = 0;      // seconds
  std::uint32_t steps_ = 0;

  std::vector<float> vertexWetness_;
  std::uint64_t vertexRevision_ = 0;
  std::vector<std::uint32_t> vertexTexels_;  // in which the vertices of the surface lie
  std::vector<float> pointVertices_, pointSums_;  // of each point of the surface: how many vertices, and what they have
  std::uint64_t vertexWetnessFor_ = 0, vertexSurfaceFor_ = 0;
  std::vector<std::uint8_t> puddles_;
  std::uint32_t puddlesFor_ = 0, puddlesRevision_ = 0;
};

}  // namespace fur::app
