// The stages without a context: each by itself, and all of them in the order in which the app updates them.
#include <gtest/gtest.h>

#include "app/stages/CoatStage.h"
#include "app/stages/GroomStage.h"
#include "app/stages/MotionStage.h"
#include "app/stages/ShapeStage.h"
#include "app/stages/WaterStage.h"
#include "geometry/Primitives.h"
#include "scene/Model.h"
#include "scene/Tentacle.h"

namespace fur::app {
namespace {

// Keeps what a coat sends, as a renderer would.
struct Layers : CoatReceiver {
  void prepare() override { ++prepared; }
  void begin(const furgen::CoatShape& shape) override { expected = shape.layers * shape.types, received = 0; }
  void setLayer(int, int, std::span<const furgen::PackedLevel>) override { ++received; }
  void setFin(int, std::span<const furgen::PackedLevel>) override { ++fins; }
  void show(std::span<const float> densities) override { ++shown, types = densities.size(); }

  int prepared = 0, expected = 0, received = 0, fins = 0, shown = 0;
  std::size_t types = 0;
};

struct Model {
  Model() {
    settings.layers = 8;
    settings.tileSize = 0;
    geometry::Mesh mesh = geometry::makeSphere();
    mesh.uv.clear();
    auto surface = geometry::buildSurface(mesh, geometry::FurMapping::Charts);
    shape.setModel(std::move(mesh), std::move(*surface), {});
    groom.update({shape, settings});
    motion.settle(motionInputs(0));
  }
  MotionStage::Inputs motionInputs(float seconds) {
    MotionStage::Inputs inputs{.shape = shape, .groom = groom, .water = water, .coatWeights = coat.weights(), .settings = settings, .coatLength = settings.furLength};
    inputs.seconds = seconds;
    inputs.idleTime = 1000;
    return inputs;
  }
  WaterStage::Inputs waterInputs(float seconds) {
    WaterStage::Inputs inputs{.shape = shape, .groom = groom, .settings = settings, .coatLength = settings.furLength};
    inputs.seconds = seconds;
    return inputs;
  }
  CoatStage::Inputs coatInputs() { return {.settings = settings, .types = groom.types(), .receiver = &layers}; }
  void step(float seconds) {
    groom.update({shape, settings});
    coat.update(coatInputs(), warnings);
    motion.update(motionInputs(seconds));
    water.update(waterInputs(seconds));
  }
  void stroke(Command what, float flow) {
    water.beginStroke({what, 0.2f, flow, 0.05f, Vec3(0, 0, 3)});
    water.strokeAt(shape, {0, Vec3(1, 0, 0), 0});
    last = water.endStroke();
  }
  std::size_t texelsTaken(bool all) {
    std::size_t sum = 0;
    for (const wet::TexelRect& band : water.takeChanged(shape, all)) sum += water.texels(shape, band, true).texels.size();
    return sum;
  }
  float longestBend() const {
    float most = 0;
    for (const Vec4& bend : motion.bends()) most = std::max(most, glm::length(Vec3(bend)));
    return most;
  }

  settings::Settings settings;
  ShapeStage shape;
  GroomStage groom;
  CoatStage coat;
  WaterStage water;
  MotionStage motion;
  Layers layers;
  Warnings warnings;
  std::optional<MaskStep> last;
};

TEST(CoatStage, SendsEveryLayerOnceAndThenRests) {
  Model model;
  EXPECT_TRUE(model.coat.active(model.coatInputs()));
  EXPECT_EQ(model.coat.progress(model.coatInputs()), 0);
  EXPECT_TRUE(model.coat.update(model.coatInputs(), model.warnings));
  EXPECT_EQ(model.layers.received, 8);
  EXPECT_EQ(model.layers.received, model.layers.expected);
  EXPECT_EQ(model.layers.fins, 1);
  EXPECT_EQ(model.layers.shown, 1);
  EXPECT_EQ(model.layers.prepared, 1);
  EXPECT_EQ(model.coat.coat().layers(), 8);
  EXPECT_GT(model.coat.coat().strandCount(), 0);
  EXPECT_FALSE(model.coat.active(model.coatInputs()));
  const std::uint64_t revision = model.coat.revision();
  EXPECT_FALSE(model.coat.update(model.coatInputs(), model.warnings));
  EXPECT_EQ(model.coat.revision(), revision);
}

TEST(CoatStage, GrowsAnewForASettingOfTheGeneratorAndForNoOther) {
  Model model;
  model.coat.update(model.coatInputs(), model.warnings);
  model.settings.furLength *= 2;
  EXPECT_FALSE(model.coat.active(model.coatInputs()));
  model.settings.curl += 0.3f;
  EXPECT_TRUE(model.coat.active(model.coatInputs()));
  EXPECT_TRUE(model.coat.update(model.coatInputs(), model.warnings));
  EXPECT_EQ(model.layers.shown, 2);
}

TEST(CoatStage, GrowsInSlicesWhileTheOneBeforeStays) {
  Model model;
  model.coat.update(model.coatInputs(), model.warnings);
  model.settings.density *= 0.5f;
  CoatStage::Inputs slice = model.coatInputs();
  slice.budget = 0;
  const std::uint64_t before = model.coat.revision();
  int slices = 0;
  float progress = 0;
  while (!model.coat.update(slice, model.warnings)) {
    ASSERT_EQ(model.coat.revision(), before);
    EXPECT_GE(model.coat.progress(slice), progress);
    progress = model.coat.progress(slice);
    ASSERT_LT(++slices, 100000);
  }
  EXPECT_GT(slices, 8);
  EXPECT_EQ(model.coat.progress(slice), 1);
}

TEST(CoatStage, ShowsFewerLayersFirstWhereThatIsAskedForAndEndsWithTheSameCoat) {
  Model model, whole;
  model.settings.layers = whole.settings.layers = 12;
  whole.coat.update(whole.coatInputs(), whole.warnings);
  CoatStage::Inputs first = model.coatInputs();
  first.coarseFirst = true;
  EXPECT_TRUE(model.coat.update(first, model.warnings));
  EXPECT_TRUE(model.coat.shows(first));
  EXPECT_TRUE(model.coat.isCoarse());
  EXPECT_LT(model.layers.received, 12);
  EXPECT_EQ(model.coat.coat().strandCount(), whole.coat.coat().strandCount());
  EXPECT_LT(model.coat.progress(first), 1);
  EXPECT_TRUE(model.coat.update(model.coatInputs(), model.warnings));
  EXPECT_FALSE(model.coat.isCoarse());
  EXPECT_EQ(model.layers.shown, 2);
  EXPECT_EQ(model.layers.received, 12);
  EXPECT_EQ(model.coat.coat().coverage(), whole.coat.coat().coverage());
  EXPECT_EQ(model.coat.weights(), whole.coat.weights());
  // Another coat takes the place of one that is there whole.
  model.settings.curl += 0.3f;
  EXPECT_FALSE(model.coat.shows(first));
  EXPECT_TRUE(model.coat.update(first, model.warnings));
  EXPECT_FALSE(model.coat.isCoarse());
}

TEST(CoatStage, SendsAllAgainToAReceiverThatHasForgotten) {
  Model model;
  model.coat.update(model.coatInputs(), model.warnings);
  model.coat.forgetLayers();
  EXPECT_FALSE(model.coat.shown());
  EXPECT_TRUE(model.coat.update(model.coatInputs(), model.warnings));
  EXPECT_EQ(model.layers.prepared, 2);
  EXPECT_EQ(model.layers.received, 8);
}

TEST(CoatStage, ShowsWhatOthersHaveGrownForTheSame) {
  struct Shelf final : Layers {
    void share(const std::shared_ptr<const WholeCoat>& coat) override { coats.push_back(coat); }
    std::shared_ptr<const WholeCoat> showShared(const CoatParameters& types, const GivenCoats& given) override {
      for (const auto& coat : coats)
        if (coat->isFor(types, given)) return coat;
      return nullptr;
    }
    std::vector<std::shared_ptr<const WholeCoat>> coats;
  } shelf;
  const auto inputsOf = [&](Model& model, double budget) {
    CoatStage::Inputs inputs = model.coatInputs();
    inputs.receiver = &shelf;
    inputs.budget = budget;
    return inputs;
  };
  Model first, second, other;
  first.coat.update(inputsOf(first, 1e9), first.warnings);
  EXPECT_EQ(shelf.shown, 1);
  EXPECT_TRUE(second.coat.update(inputsOf(second, 0), second.warnings));
  EXPECT_EQ(shelf.shown, 1);
  EXPECT_TRUE(second.coat.shown());
  EXPECT_EQ(&second.coat.coat(), &first.coat.coat());
  EXPECT_EQ(second.coat.weights(), first.coat.weights());
  other.settings.curl += 0.3f;
  EXPECT_FALSE(other.coat.update(inputsOf(other, 0), other.warnings));
  // One that is on its way gives way to one that comes sooner.
  first.settings.curl += 0.3f;
  first.coat.update(inputsOf(first, 1e9), first.warnings);
  EXPECT_TRUE(other.coat.update(inputsOf(other, 0), other.warnings));
  EXPECT_EQ(&other.coat.coat(), &first.coat.coat());
}

TEST(ModelShelf, HasASurfaceOnceForAsLongAsItIsShown) {
  ModelShelf shelf;
  const geometry::Mesh sphere = geometry::makeSphere(), torus = geometry::makeTorus();
  const auto surface = [&](const geometry::Mesh& mesh, geometry::FurMapping mapping = geometry::FurMapping::Charts) {
    return *shelf.surfaceOf(mesh, mapping);
  };
  std::optional<ShownSurface> first = surface(sphere);
  EXPECT_EQ(&**first, &*surface(sphere));
  EXPECT_EQ(&first->query(), &surface(sphere).query());
  EXPECT_NE(&**first, &*surface(torus));
  EXPECT_NE(&**first, &*surface(sphere, geometry::FurMapping::Cube));
  geometry::Mesh moved = sphere;
  moved.positions[0] *= 0.99f;
  EXPECT_NE(&**first, &*surface(moved));
  EXPECT_FALSE(shelf.surfaceOf({}, geometry::FurMapping::Charts));

  const Pixels pixels = shelf.pixels({1, 2, 3, 4});
  EXPECT_EQ(shelf.pixels({1, 2, 3, 4}), pixels);
  EXPECT_NE(shelf.pixels({1, 2, 3, 5}), pixels);
}

TEST(GroomStage, TellsWhatAStrokeChangedAndUndoesIt) {
  Model model;
  const std::uint64_t before = model.groom.revision(), hash = model.groom.hash(model.shape);
  for (const auto map : {groom::kLengthMap, groom::kPaintMap, groom::kMaskMap, groom::kShapeMap}) (void)model.groom.takeChanged(map);
  model.groom.beginStroke(model.shape);
  model.settings.groomStrength = 1;
  model.groom.dab(model.shape, model.settings, Tool::Trim, {0, Vec3(1, 0, 0), 0}, model.warnings);
  auto step = model.groom.endStroke();
  ASSERT_TRUE(step);
  EXPECT_GT(model.groom.revision(), before);
  EXPECT_TRUE(model.groom.active({model.shape, model.settings}));
  EXPECT_TRUE(model.groom.update({model.shape, model.settings}));
  EXPECT_FALSE(model.groom.update({model.shape, model.settings}));
  EXPECT_TRUE(model.groom.hasLengths());
  EXPECT_EQ(model.groom.vertexLengths().size(), model.shape.surface().vertices.size());
  EXPECT_FALSE(model.groom.takeChanged(groom::kLengthMap).empty());
  EXPECT_TRUE(model.groom.takeChanged(groom::kLengthMap).empty());
  EXPECT_TRUE(model.groom.takeChanged(groom::kPaintMap).empty());
  model.groom.apply(model.shape, *step, true);
  model.groom.update({model.shape, model.settings});
  EXPECT_FALSE(model.groom.hasLengths());
  EXPECT_EQ(model.groom.hash(model.shape), hash);
}

TEST(WaterStage, AStrokeWetsTheVerticesRoundItAndItsStepTakesThatBack) {
  Model model;
  const std::uint64_t before = model.water.revision();
  model.stroke(Command::Droplet, 0.8f);
  ASSERT_TRUE(model.last);
  EXPECT_GT(model.water.revision(), before);
  const std::vector<float>& wetness = model.water.vertexWetness(model.shape);
  EXPECT_GT(*std::max_element(wetness.begin(), wetness.end()), 0.1f);
  EXPECT_GT(model.water.meanWetness(model.shape), 0);
  EXPECT_GT(model.texelsTaken(false), 0u);
  EXPECT_EQ(model.texelsTaken(false), 0u);
  model.water.apply(*model.last, true);
  EXPECT_TRUE(model.water.mask().isDry());
  EXPECT_EQ(model.water.strokes().size(), 1u);
}

TEST(WaterStage, GivesThePictureAllOfTheMaskInBandsThatAreNoMasksMemory) {
  Model model;
  model.stroke(Command::Soak, 0.1f);
  int next = 0;
  for (const wet::TexelRect& part : model.water.takeChanged(model.shape, true)) {
    const wet::MaskTexels band = model.water.texels(model.shape, part, true);
    const geometry::TexelRect rows{0, next, band.size, band.rect.y1};
    EXPECT_EQ(band.rect, rows);
    EXPECT_LE(band.texels.size(), static_cast<std::size_t>(WaterStage::kBandTexels));
    EXPECT_EQ(band.texels.size(), static_cast<std::size_t>(band.rect.y1 - band.rect.y0) * WaterStage::kMaskSize);
    next = band.rect.y1;
  }
  EXPECT_EQ(next, WaterStage::kMaskSize);
}

TEST(WaterStage, TellsThePictureAloneWhatLiesBeyondTheBordersOfCharts) {
  Model model;
  EXPECT_FALSE(model.water.takeBorders(model.shape, true)) << "nothing has been wet";
  model.stroke(Command::Soak, 0.1f);
  EXPECT_TRUE(model.water.takeBorders(model.shape, false));
  EXPECT_FALSE(model.water.takeBorders(model.shape, false)) << "not anew";
  EXPECT_TRUE(model.water.takeBorders(model.shape, true)) << "of another context";
  const auto mostV = [](const wet::MaskTexels& texels) {
    float most = 0;
    for (const Vec4& texel : texels.texels) most = std::max(most, texel.y);
    return most;
  };
  const int size = WaterStage::kMaskSize;
  EXPECT_GT(mostV(model.water.texels(model.shape, {0, 0, size, size}, true)), static_cast<float>(FUR_BORDER_STEP));
  EXPECT_LT(mostV(model.water.texels(model.shape)), static_cast<float>(FUR_BORDER_STEP)) << "as clumps lie";
}

TEST(WaterStage, DriesInTimeAndThenRests) {
  Model model;
  model.settings.dryRate = 1;
  model.stroke(Command::Soak, 0.1f);
  EXPECT_TRUE(model.water.active(model.waterInputs(0)));
  for (int i = 0; i < 600 && model.water.active(model.waterInputs(0)); ++i) model.water.update(model.waterInputs(0.1f));
  EXPECT_TRUE(model.water.mask().isDry());
  EXPECT_FALSE(model.water.active(model.waterInputs(0)));
  EXPECT_FALSE(model.water.update(model.waterInputs(0.1f)));
}

TEST(WaterStage, AToolThatIsHeldWorksUntilItsStrokeEnds) {
  Model model;
  model.water.beginStroke({Command::Hose, 0.2f, 1, 0.05f, Vec3(0, 0, 3)});
  EXPECT_FALSE(model.water.working());
  model.water.hold(geometry::SurfacePoint{0, Vec3(1, 0, 0), 0}, 1);
  EXPECT_TRUE(model.water.holds(Tool::Hose));
  for (int i = 0; i < 30; ++i) model.water.update(model.waterInputs(1.0f / 60));
  EXPECT_GT(model.water.water().drops().size(), 10u);
  EXPECT_TRUE(model.water.endStroke() || model.water.mask().isDry());
  EXPECT_FALSE(model.water.working());
  // Where it began, and where it ended.
  EXPECT_EQ(model.water.strokes().back().points.size(), 2u);
}

TEST(WaterStage, GoesOnInAnotherProgramAsItWouldHaveHere) {
  Model model, other;
  model.stroke(Command::Soak, 0.9f);
  for (int i = 0; i < 20; ++i) model.water.update(model.waterInputs(0.05f));
  ASSERT_TRUE(other.water.restore(model.water.save()));
  EXPECT_EQ(other.water.mask().hash(), model.water.mask().hash());
  EXPECT_EQ(writeStrokes(other.water.strokes()), writeStrokes(model.water.strokes()));
  std::vector<std::uint8_t> cut = model.water.save();
  cut.pop_back();
  const std::uint64_t before = other.water.revision();
  EXPECT_FALSE(other.water.restore(cut));
  EXPECT_EQ(other.water.revision(), before);
}

TEST(MotionStage, RestsUntilAForceOrWaterChanges) {
  Model model;
  model.step(0.1f);
  for (int i = 0; i < 200 && model.motion.active(model.motionInputs(0)); ++i) model.step(0.1f);
  ASSERT_FALSE(model.motion.active(model.motionInputs(0)));
  const std::uint64_t revision = model.motion.revision();
  EXPECT_FALSE(model.motion.update(model.motionInputs(0.1f)));
  EXPECT_EQ(model.motion.revision(), revision);
  model.settings.gravity = 0;
  EXPECT_TRUE(model.motion.active(model.motionInputs(0)));
  model.settings.gravity = settings::Settings().gravity;
  EXPECT_FALSE(model.motion.active(model.motionInputs(0)));
  model.stroke(Command::Soak, 0.8f);
  EXPECT_TRUE(model.motion.active(model.motionInputs(0)));
  EXPECT_TRUE(model.motion.update(model.motionInputs(0.1f)));
}

TEST(MotionStage, ReducedMotionHasNoWind) {
  Model model;
  model.settings.wind = 1;
  model.settings.gravity = 0;
  model.settings.lie = 0;
  model.groom.update({model.shape, model.settings});
  MotionStage::Inputs inputs = model.motionInputs(0);
  inputs.reducedMotion = true;
  model.motion.settle(inputs);
  EXPECT_EQ(model.longestBend(), 0);
  model.motion.settle(model.motionInputs(0));
  EXPECT_GT(model.longestBend(), 0.1f);
}

TEST(MotionStage, CombedFurLiesAtOnceWhenItSettles) {
  Model model;
  model.settings.gravity = 0;
  model.groom.beginStroke(model.shape);
  model.groom.edit(model.shape, GroomEdit::Comb, 1, Vec3(0, -1, 0), {}, model.warnings);
  EXPECT_TRUE(model.groom.endStroke());
  model.groom.update({model.shape, model.settings});
  EXPECT_FALSE(model.groom.rests().empty());
  model.motion.settle(model.motionInputs(0));
  EXPECT_GT(model.longestBend(), 0.5f);
}

TEST(ShapeStage, PlaysAnAnimationAndItsQueriesFollow) {
  auto model = scene::importModel(scene::Tentacle().build(), "tentacle.glb");
  ASSERT_TRUE(model);
  auto surface = geometry::buildSurface(model->mesh, geometry::FurMapping::Charts);
  ASSERT_TRUE(surface);
  ShapeStage shape;
  shape.setModel(std::move(model->mesh), std::move(*surface), std::move(model->rig));
  const int wave = shape.animationOf(1);
  EXPECT_EQ(wave, 0);
  EXPECT_EQ(shape.animationOf(7), -1);
  EXPECT_TRUE(shape.active({0, wave, 1}));
  EXPECT_FALSE(shape.active({0, wave, 0}));
  shape.update({0, wave, 1});
  const std::uint64_t before = shape.revision(), surfaceBefore = shape.surfaceRevision();
  const std::vector<Vec3> still = shape.skin()->positions;
  EXPECT_TRUE(shape.update({0.5f, wave, 1}));
  EXPECT_GT(shape.revision(), before);
  EXPECT_EQ(shape.surfaceRevision(), surfaceBefore);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < still.size(); ++i) moved += still[i] != shape.skin()->positions[i];
  EXPECT_GT(moved, still.size() / 4);
  const Vec3 at = shape.shownPosition({0, Vec3(0.4f, 0.3f, 0.3f), 0}), normal = shape.shownNormal({0, Vec3(0.4f, 0.3f, 0.3f), 0});
  const auto hit = shape.shownQuery().castRay(at + 0.01f * normal, -normal);
  ASSERT_TRUE(hit);
  EXPECT_LT(glm::distance(shape.shownPosition(*hit), at), 0.01f);
  EXPECT_FALSE(shape.update({0.5f, wave, 0}));
}

TEST(ShapeStage, AModelWithoutAnimationsIsShownAsItWasMade) {
  Model model;
  EXPECT_EQ(model.shape.skin(), nullptr);
  EXPECT_EQ(&model.shape.shownQuery(), &model.shape.query());
  const std::uint64_t revision = model.shape.revision();
  EXPECT_FALSE(model.shape.update({1, 0, 1}));
  EXPECT_EQ(model.shape.revision(), revision);
}

TEST(GroomStage, TheCombOfTheSettingsLeansAllFurThatWayBesideWhatIsCombedByHand) {
  Model model;
  model.settings.lie = 0;
  model.groom.update({model.shape, model.settings});
  EXPECT_TRUE(model.groom.rests().empty());
  model.settings.combStrength = 0.8f;
  EXPECT_TRUE(model.groom.active({model.shape, model.settings}));
  model.groom.update({model.shape, model.settings});
  const auto& vertices = model.shape.surface().vertices;
  ASSERT_EQ(model.groom.rests().size(), vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3& rest = model.groom.rests()[i];
    EXPECT_LE(glm::length(rest), groom::kMaxComb * 1.001f);
    EXPECT_NEAR(glm::dot(rest, vertices[i].normal), 0, 1e-4f);
    if (std::abs(vertices[i].normal.y) < 0.7f) EXPECT_LT(rest.y, -0.3f) << "downwards";
  }
  EXPECT_TRUE(model.groom.upright()) << "nobody has combed it";
  model.settings.combStrength = 0;
  model.groom.update({model.shape, model.settings});
  EXPECT_TRUE(model.groom.rests().empty());
}

TEST(GroomStage, FurLiesByItselfUnlessTheFileHasCombedIt) {
  Model model;
  const auto restsWith = [&](float lie, float combStrength = 0) {
    model.settings.lie = lie;
    model.settings.combStrength = combStrength;
    model.groom.update({model.shape, model.settings});
    EXPECT_FALSE(model.groom.active({model.shape, model.settings}));
    return model.groom.rests();
  };
  const auto longest = [](const std::vector<Vec3>& rests) {
    float most = 0;
    for (const Vec3& rest : rests) most = std::max(most, glm::length(rest));
    return most;
  };
  EXPECT_NEAR(longest(restsWith(0.8f)), 0.8f * groom::kMaxComb, 1e-3f);
  EXPECT_NEAR(longest(restsWith(0.4f)), 0.4f * groom::kMaxComb, 1e-3f);
  EXPECT_TRUE(restsWith(0).empty());
  const std::vector<Vec3> combed = restsWith(0, 1);
  EXPECT_EQ(restsWith(0.8f, 1), combed) << "the vector of the settings takes its place";
  EXPECT_TRUE(model.groom.upright()) << "nobody has combed it";
  EXPECT_FALSE(model.groom.isCombed());

  // One vertex is combed; the file does not say that the others lie.
  scene::FurData fur;
  fur.comb.assign(model.shape.mesh().positions.size(), Vec3(0));
  fur.comb[1000] = 0.5f * normalizeOr(glm::cross(model.shape.mesh().normals[1000], Vec3(1, 2, 3)), Vec3(0));
  Warnings warnings;
  for (const bool lies : {false, true}) {
    model.groom.reset();
    fur.isLying = lies;
    model.groom.read(model.shape, fur, warnings);
    EXPECT_EQ(model.groom.isLying(), lies);
    EXPECT_NEAR(longest(restsWith(0.8f)), lies ? 0.8f * groom::kMaxComb : 0.5f, 1e-3f);
    EXPECT_NEAR(longest(restsWith(0)), 0.5f, 1e-3f) << "combs stay as they are";
  }
}

}  // namespace
}  // namespace fur::app
