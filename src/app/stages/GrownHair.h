// Long hair that grows: HairStage for programs that have it.
#pragma once

#include "app/stages/BodyGrip.h"
#include "app/stages/HairStage.h"
#include "hair/HairWater.h"
#include "hair/Simulation.h"

namespace fur::app {

class GrownHair final : public HairStage, private wet::WetHair {
 public:
  void reset() override;
  bool update(const Inputs& inputs) override;
  void settle(const Inputs& inputs) override;
  bool workOnGrowth(const Inputs& inputs) override;
  bool active(const Inputs& inputs) const override;

  void setStyle(hair::Hairstyle style) override;
  std::string describe() const override;

  void beginStroke() override;
  std::optional<HairStep> endStroke() override;
  void apply(const HairStep& step, bool undo) override;
  bool meets(const Look& look) const override;
  void dab(const Dab& dab) override;
  void edit(const ShapeStage& shape, const groom::GroomSurface& skin, std::span<const Vec3> comb, const Edit& edit, Warnings& warnings) override;
  void setValues(std::size_t scalp, const hair::HairValues& values) override;
  void setBody(std::size_t body, const hair::Body& to) override;
  Status setValue(std::size_t scalp, std::string_view name, std::string_view text, Warnings& warnings) override;

  const hair::HairView* view(const Look& look) override;
  const groom::GroomMap& paintUnderView(const groom::GroomMap& paint) override;
  bool pointsElsewhere(const Look& look) override;

  wet::WetHair* wetHair() override { return this; }
  bool isWet() const override;
  void wetBy(const WaterStroke& stroke, const ShapeStage& shape, const geometry::SurfacePoint& at, float pressure, float height) override;
  Vec3 placeOf(const ShapeStage& shape, const geometry::SurfacePoint& at, float height) const override;
  std::vector<float> waterState() const override;
  void setWaterState(std::vector<float> state) override;
  std::optional<Met> meet(const ShapeStage& shape, const Vec3& origin, const Vec3& direction, const std::optional<geometry::SurfacePoint>& hit) override;
  std::span<const wet::Drop> withHanging(std::span<const wet::Drop> drops) override;
  void addWetness(hair::Hairstyle& style) const override;

  Status readFile(const ShapeStage& shape, const groom::GroomSurface& skin, std::span<const std::uint8_t> bytes, const std::string& name) override;
  Result<std::vector<std::uint8_t>> writeFile() const override;
  std::vector<std::uint8_t> save() const override;
  [[nodiscard]] bool restore(std::span<const std::uint8_t> bytes) override;

  std::size_t scalpCount() const override { return scalps_.size(); }
  const Growth& growth(std::size_t scalp) const override { return scalps_[scalp].growth; }
  std::uint64_t growthRevision(std::size_t scalp) const override { return scalps_[scalp].grown; }
  std::span<const hair::GuideNode> nodes(std::size_t scalp) const override { return scalps_[scalp].nodes; }
  std::uint64_t nodesRevision(std::size_t scalp) const override { return scalps_[scalp].moved; }

 private:
  struct LiveScalp {
    std::vector<geometry::SurfacePoint> roots;  // of its guides, on the surface
    std::vector<hair::RootFrame> asMade;        // their frames there
    hair::Simulation simulation;
    hair::Guides guides;           // that it simulates
    std::uint64_t surfaceFor = 0;  // and on which surface
    Growth growth;
    bool lightStale = false;       // its occlusion and base tangents are of the hair as it was before the stroke at work
    hair::HairValues values;       // that it grew by
    std::pair<std::uint64_t, std::uint64_t> plantedFor{};  // roots of the guides and map
    std::vector<hair::GuideNode> nodes;
    std::uint64_t grown = 0, moved = 0;
    hair::HairWater water;
    std::vector<float> felt, seen;  // wetness of its nodes as the motion has it, and as it is shown
    // In world space, as the simulation has it.
    hair::ShownHair shown() const { return {growth.wisps, simulation.nodes(), guides.nodes, hair::shapeOf(values)}; }
  };
  static constexpr groom::GroomMap::Texel kFreshScalp{0, 255, 255, 255};
  void touch();
  struct Near {
    std::size_t guide, node;
    Vec3 shown, rest;
    float distance;  // along the ray
  };
  // The node above its root, of the selected scalp, that is shown nearest to the eye among those within reach of the ray.
  std::optional<Near> nearestNode(const Vec3& origin, const Vec3& direction, float reach) const;
  bool paintScalp(const Dab& dab);
  bool shapeGuides(const Dab& dab);
  void editGuides(const ShapeStage& shape, const Edit& edit, Warnings& warnings);
  bool editAll(const groom::GroomSurface& skin, const Edit& edit, Warnings& warnings);
  bool editBodies(const ShapeStage& shape, const Edit& edit, Warnings& warnings);
  void addBody(const hair::Body& body, Warnings& warnings);
  hair::Body* body();  // that is selected
  void placeBodies(const ShapeStage& shape);
  bool dragBody(const Dab& dab);
  // One part of one scalp after another. Whether all has grown.
  bool growSome(const ShapeStage& shape);
  void growGuides(const hair::Scalp& scalp, LiveScalp& live, const ShapeStage& shape);
  void growWisps(const hair::Scalp& scalp, LiveScalp& live, const ShapeStage& shape);
  void growLight(const hair::Scalp& scalp, LiveScalp& live, const ShapeStage& shape);
  void growStrands(const hair::Scalp& scalp, LiveScalp& live);
  std::vector<hair::RootFrame> rootsNow(const LiveScalp& live, const Inputs& inputs) const;
  // --- GrownHairWater.cpp ---
  double water() const override;
  bool active(const wet::Climate& climate) const override;
  float take(const Vec3& from, const Vec3& way, float water) override;
  double step(const wet::Climate& climate, std::vector<wet::Drop>& drops) override;
  void wetNear(const Vec3& centre, float radius, float amount);
  void growWater(LiveScalp& live);
  void takeState();
  void takeWetness();
  // The wetness of its nodes, with that of the skin at its roots; whether it is to be shown anew.
  static bool wetnessNow(LiveScalp& live, const Inputs& inputs);

  void showNodes(LiveScalp& live, const Inputs& inputs);
  void growWhereStale(const ShapeStage& shape);
  template <class Work>
  void forScalps(const Inputs& inputs, Work work);

  std::optional<Near> pointedNode(const Look& look) const;
  void viewLines(const Look& look);
  void viewGuides(std::size_t scalp, const Look& look);
  void viewPointed(const Look& look);
  void viewSprings(std::size_t scalp, const Look& look);
  void viewBodies(const Look& look);
  void viewColors(const Look& look);
  std::vector<hair::ViewColor> mapColors(const Look& look) const;
  std::vector<hair::ViewColor> wispColors(std::size_t scalp, const Look& look) const;

  std::vector<LiveScalp> scalps_;  // one for each of the style's
  Mat4 worldFromModel_{1.0f};      // of the last update
  std::optional<std::vector<float>> givenState_;  // for hair that has yet to grow
  std::vector<wet::Drop> drops_;   // of withHanging()
  // The stroke of a tool that works on guides: where it was (rest shape), the distance of the plane that it works in, and the guide
  // and node where it began.
  struct Stroke {
    Vec3 last;
    Vec3 planePoint, planeNormal;
    Near first;
  };
  std::optional<Stroke> guideStroke_;
  // Bodies where the model's pose has them, as of the last update; and the way there from where they are as made.
  std::vector<hair::Body> bodies_;
  std::vector<Mat4> bodyMotions_;
  std::vector<Mat4> restInverses_;   // of the rig's nodes
  std::uint64_t restFor_ = 0;        // and for which surface
  // The stroke of the tool that drags bodies: what it has taken hold of, and where in the plane through that place that faces the eye.
  struct BodyStroke {
    BodyGrip grip;
    Vec3 at, normal;
  };
  std::optional<BodyStroke> bodyStroke_;
  hair::HairView view_;
  bool mapOver_ = false;  // its map lies over the coat
  groom::GroomMap paintUnderView_;
  std::uint64_t linesFor_ = 0, colorsFor_ = 0;  // hashes of what view_ is made of
  std::pair<std::size_t, std::size_t> pointedAt_{};  // guide and node
  bool stale_ = false;             // style_ has changed since they grew
  // What grows next, and what is known of that scalp.
  struct Growing {
    std::size_t scalp = 0;
    int part = 0;
    bool otherSurface = false, sameLooks = false;
  };
  Growing growing_;
  bool settled_ = false;
  std::uint64_t surfaceFor_ = 0;
};

}  // namespace fur::app
