// Long hair: the scalps of the model, what grows on them, and how it moves. Reads shape and motion (where the model is, wind,
// touch); its growth and nodes go to the picture.
//
// Hair is a fifth of a program, and most models have none: this class alone has no hair, ever. Programs that grow it say so
// (app/LongHair.h), and have GrownHair in its place.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/commands/History.h"
#include "app/commands/WaterStrokes.h"
#include "app/stages/ShapeStage.h"
#include "app/tools/HairEdits.h"
#include "app/tools/Tools.h"
#include "core/Result.h"
#include "dynamics/Contact.h"
#include "dynamics/Wind.h"
#include "hair/HairView.h"
#include "hair/MemberStrands.h"
#include "hair/Scalp.h"
#include "hair/Wisps.h"
#include "settings/Settings.h"
#include "wet/WetHair.h"

namespace fur::app {

class HairStage {
 public:
  struct Inputs {
    const ShapeStage& shape;
    const settings::Settings& settings;
    Mat4 worldFromModel{1.0f};
    dynamics::Wind wind;                            // world space
    std::span<const dynamics::Contact> contacts{};  // ball and hand
    std::span<const float> wetness{};               // of the surface's vertices, 0..1; empty: dry. Roots lie in it
    float seconds = 0;                              // that have passed
  };
  // What grows on a scalp.
  struct Growth {
    std::vector<hair::Wisp> wisps;  // in an order by chance
    std::vector<hair::MemberStrand> members;
    hair::StripPicture strips;
    std::vector<std::uint8_t> ambient;  // hair/AmbientOcclusion.h
    std::vector<std::array<std::uint8_t, 4>> baseTangents;  // hair/BaseTangents.h
  };

  // What a person looks at and points at.
  struct Look {
    const settings::Settings& settings;
    Tool tool;
    bool saved = false;     // a picture for a file, on which tools show nothing
    float pixelRatio = 1;
    int mapSize = 0;        // of the groom's maps
    Mat4 worldFromModel{1.0f};
    bool points = false;    // at `direction` (unit) from `origin`, model space
    Vec3 origin{0}, direction{0};
    Vec3 eye{0, 0, 3};      // model space
    float pixel = 0.002f;   // model units that one covers at distance 1
  };

  // What make() gives from then on.
  static void growWith(std::unique_ptr<HairStage> (*maker)());
  static std::unique_ptr<HairStage> make();
  virtual ~HairStage() = default;

  virtual void reset() {}  // of another model: no hair
  // Whether anything that can be seen has changed.
  virtual bool update(const Inputs&) { return false; }
  // Hangs at once as it does at rest.
  virtual void settle(const Inputs&) {}
  // A step of what update() does at once for hair that is new. Whether that was the last.
  virtual bool workOnGrowth(const Inputs&) { return true; }
  virtual bool active(const Inputs&) const { return false; }
  std::uint64_t revision() const { return revision_; }

  int selectedBody() const { return selectedBody_; }  // of style().bodies; -1: none
  const hair::Hairstyle& style() const { return style_; }
  virtual void setStyle(hair::Hairstyle) {}
  std::size_t selected() const { return selected_; }  // the scalp that tools work on
  void select(std::size_t scalp) { selected_ = scalp; }
  // JSON: [{"name","guides","wisps","selected","values":{all of them}}].
  virtual std::string describe() const { return "[]"; }

  // --- strokes: every change is one, and ends in the step that undoes it ---
  virtual void beginStroke() {}
  bool stroking() const { return before_.has_value(); }
  virtual std::optional<HairStep> endStroke() { return std::nullopt; }
  virtual void apply(const HairStep&, bool) {}
  // Whether the tool has something to take hold of where it points: a guide of the selected scalp that is not hidden, or a body.
  virtual bool meets(const Look&) const { return false; }
  // Within a stroke: a dab of the tool where a ray (model space) goes, on both sides where the settings say so.
  struct Dab {
    Tool tool;
    Vec3 origin, direction;  // unit
    std::optional<geometry::SurfacePoint> skin;  // that it meets
    const groom::GroomSurface& surface;
    const groom::GroomMap& mask;  // the groom's
    const settings::Settings& settings;
    const ShapeStage& shape;
    float pixel = 0.002f;  // model units that one covers at distance 1
  };
  virtual void dab(const Dab&) {}
  // Within a stroke: see HairEdits.inc; numbers are finite. `comb`: bends of the coat at rest, one a vertex, or none.
  struct Edit {
    HairEdit what;
    float value;
    Vec3 direction;
    float coat = 0;  // height of the coat, on which hair lies; model units
    std::span<const std::uint8_t> bare{};  // materials on which nothing grows, by their numbers
  };
  virtual void edit(const ShapeStage&, const groom::GroomSurface&, std::span<const Vec3> /*comb*/, const Edit&, Warnings&) {}
  virtual void setValues(std::size_t /*scalp*/, const hair::HairValues&) {}
  virtual void setBody(std::size_t /*body*/, const hair::Body&) {}
  // Within a stroke: a value of HairFields.inc, or "name".
  virtual Status setValue(std::size_t scalp, std::string_view name, std::string_view text, Warnings& warnings);

  // --- views ---
  // What views and tools show now, until the next call; nullptr: nothing.
  virtual const hair::HairView* view(const Look&) { return nullptr; }
  // The coat's paint with the colours of that view over it.
  virtual const groom::GroomMap& paintUnderView(const groom::GroomMap& paint) { return paint; }
  // Whether the pointer is at another node than when it was last asked, so that view() changes.
  virtual bool pointsElsewhere(const Look&) { return false; }

  // --- water (wet/WetHair.h) ---
  // The hair as water meets it; none where none ever grows.
  virtual wet::WetHair* wetHair() { return nullptr; }
  virtual bool isWet() const { return false; }
  // What a point of a stroke of water does to it. Where it is `height` above 0 up the hair that is rooted there, else on the skin.
  virtual void wetBy(const WaterStroke&, const ShapeStage&, const geometry::SurfacePoint& /*at*/, float /*pressure*/, float /*height*/) {}
  // The place of such a point as it is shown; model space.
  virtual Vec3 placeOf(const ShapeStage& shape, const geometry::SurfacePoint& at, float /*height*/) const { return shape.shownPosition(at); }
  // All of its water, for undo and files. Empty: it is dry; of other hair: it becomes dry.
  virtual std::vector<float> waterState() const { return {}; }
  virtual void setWaterState(std::vector<float>) {}
  // Where a ray (model space, `direction` unit) meets hair: its root on the surface, the share of its length up to there, how far
  // along the ray, and what scalp it is of.
  struct Met {
    geometry::SurfacePoint root;
    float height, distance;
    std::size_t scalp;
  };
  // `hit`: what the ray meets of the fur otherwise, which hides what is behind it.
  virtual std::optional<Met> meet(const ShapeStage&, const Vec3& /*origin*/, const Vec3& /*direction*/, const std::optional<geometry::SurfacePoint>& /*hit*/) { return std::nullopt; }
  // Those drops and what hangs from hair; world space. Until the next call.
  virtual std::span<const wet::Drop> withHanging(std::span<const wet::Drop> drops) { return drops; }
  // Adds the wetness of each scalp to a copy of the style, for files.
  virtual void addWetness(hair::Hairstyle&) const {}

  // --- files ---
  // Within a stroke: the strands of a .hair file become the guides of the selected scalp, or of a new one.
  virtual Status readFile(const ShapeStage&, const groom::GroomSurface&, std::span<const std::uint8_t>, const std::string& name);
  // All strands of the selected scalp, as they are now, as .hair. bad-file where there are none.
  virtual Result<std::vector<std::uint8_t>> writeFile() const;
  virtual std::vector<std::uint8_t> save() const { return {}; }
  // False: they are not bytes of save(), and nothing has changed.
  [[nodiscard]] virtual bool restore(std::span<const std::uint8_t> bytes) { return bytes.empty(); }

  // --- of each scalp, as of the last update() ---
  virtual std::size_t scalpCount() const { return 0; }
  virtual const Growth& growth(std::size_t scalp) const;
  virtual std::uint64_t growthRevision(std::size_t) const { return 0; }
  // Of its guides, model space, guide after guide.
  virtual std::span<const hair::GuideNode> nodes(std::size_t) const { return {}; }
  virtual std::uint64_t nodesRevision(std::size_t) const { return 0; }

 protected:
  hair::Hairstyle style_;
  std::size_t selected_ = 0;
  int selectedBody_ = -1;
  std::optional<std::vector<std::uint8_t>> before_;  // the stroke at work
  std::uint64_t revision_ = 0;
};

}  // namespace fur::app
