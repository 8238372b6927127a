// The coat: strands grown by the settings, one coat a fur type, cut into layers. It grows in slices of a few milliseconds, so
// that the picture never waits; the layers go to a receiver, which keeps them (a renderer, or a test).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/Result.h"
#include "furgen/Coat.h"
#include "furgen/Layers.h"
#include "furgen/Packing.h"
#include "furgen/TilePicture.h"
#include "settings/Settings.h"

namespace fur::app {

// What the settings ask the generator for, one a fur type; `types` has a bit for each that the groom has
// anywhere. Density 0 where one is bald or nowhere; the last, unless it is the only one, has strands.
// Fewer layers than asked for, and a warning, where they would take more than 192 MiB on the GPU.
using CoatParameters = std::vector<furgen::FurParameters>;
CoatParameters coatParameters(const settings::Settings& settings, unsigned types, Warnings* warnings = nullptr);

// The same of one type, as if it were everywhere; its size and layers as the settings have them.
furgen::FurParameters coatParametersOf(const settings::Settings& settings, int type);

// Whether everything but the generator's settings is the same: nothing to draw anew before the coat is there.
bool differOnlyInCoat(const settings::Settings& a, settings::Settings b);

// A coat that was read from a type set; nullptr: none. One a fur type.
using GivenCoat = std::shared_ptr<const furgen::FurVolume>;
using GivenCoats = std::array<GivenCoat, settings::kFurTypes>;

// The coat of type 1 that is drawn: grown from settings, or read from a type set.
class DrawnCoat {
 public:
  DrawnCoat() = default;
  DrawnCoat(std::shared_ptr<const furgen::Coat> grown, std::vector<float> coverage);
  DrawnCoat(GivenCoat volume, std::vector<float> coverage);

  int layers() const;
  int size() const;
  int strandCount() const;
  float weight() const;
  const std::vector<float>& coverage() const { return coverage_; }  // a share for each layer
  furgen::TilePicture tilePicture(int layer, furgen::TileChannel channel) const;
  furgen::TilePicture finPicture(furgen::TileChannel channel) const;
  // nullptr: it was read, or there is none yet.
  const furgen::Coat* grown() const { return grown_.get(); }
  // nullptr: it was grown.
  const furgen::FurVolume* volume() const { return volume_.get(); }

 private:
  std::shared_ptr<const furgen::Coat> grown_;
  GivenCoat volume_;
  std::vector<float> coverage_;
};

// A coat that is whole, as all share it who are to show the same.
struct WholeCoat {
  CoatParameters types;
  GivenCoats given;
  DrawnCoat first;             // of type 1
  std::vector<float> weights;  // one a type, as FurVolume has it
  bool isFor(const CoatParameters& otherTypes, const GivenCoats& otherGiven) const { return types == otherTypes && given == otherGiven; }
};

// Takes the layers of a coat as they come: begin(), each layer and the fin map with their mipmaps in any order, show().
// Another begin() drops what came since the last show().
class CoatReceiver {
 public:
  // Before the first coat grows: a renderer may have shaders compiled meanwhile.
  virtual void prepare() = 0;
  virtual void begin(const furgen::CoatShape& shape) = 0;
  virtual void setLayer(int type, int layer, std::span<const furgen::PackedLevel> levels) = 0;
  virtual void setFin(int type, std::span<const furgen::PackedLevel> levels) = 0;
  // `densities`, one a type: the share of its densest layer that strands cover; 0: it is bald.
  virtual void show(std::span<const float> densities) = 0;
  // What has been shown, for others; and what others have so, if they have it: then it is shown.
  virtual void share(const std::shared_ptr<const WholeCoat>& /*coat*/) {}
  virtual std::shared_ptr<const WholeCoat> showShared(const CoatParameters& /*types*/, const GivenCoats& /*given*/) { return nullptr; }

 protected:
  ~CoatReceiver() = default;
};

// A coat on its way.
class CoatGrowth {
 public:
  // `given` take the place of those that would grow; all follow their size and layers, which are those of the format. `strands`: grown
  // before for the same but the number of layers.
  using Strands = std::vector<std::shared_ptr<const furgen::Coat>>;
  CoatGrowth(CoatParameters types, GivenCoats given, Strands strands = {});
  // Before the first step: its fins stay empty, as no picture shows them.
  void leaveFins() { hasFins_ = false; }

  // Some milliseconds of work; returns whether the coat is whole and shown. Not to be called after.
  bool step(CoatReceiver& receiver);
  float progress() const;  // 0..1
  DrawnCoat take() { return std::move(first_); }
  Strands takeStrands() { return std::move(strands_); }
  const std::vector<float>& weights() const { return weights_; }  // one a type, as FurVolume has it

 private:
  enum class Stage { Grow, Fin, Paint, Upload };

  std::size_t type() const { return densities_.size(); }
  const GivenCoat& given() const { return given_[type()]; }
  // The next type that has strands is at work.
  void beginType();
  // Whether that was the last.
  bool finishType(CoatReceiver& receiver);

  CoatParameters types_;
  GivenCoats given_;
  DrawnCoat first_;
  std::vector<float> densities_, weights_;  // of the types that are whole
  furgen::CoatShape shape_;
  // The type at work, and its layer.
  Stage stage_ = Stage::Grow;
  bool hasFins_ = true;
  std::optional<furgen::CoatGrower> grower_;
  Strands strands_;  // one a type, as far as they have grown
  std::optional<furgen::LayerPainter> painter_;
  furgen::LayerMaps maps_;
  std::vector<float> coverage_;  // of the layers that are out
};

class CoatStage {
 public:
  struct Inputs {
    const settings::Settings& settings;
    unsigned types = 1;               // those that the groom has anywhere
    GivenCoats given{};               // in place of grown ones
    CoatReceiver* receiver = nullptr;  // none: nothing grows
    double budget = 1e9;              // seconds of this machine's time; what comes out does not depend on it
    bool coarseFirst = false;         // where none is shown, one of fewer layers is, before the whole one
  };

  // Goes on with the coat that the inputs ask for; the one before stays until it is whole. Whether another one is shown.
  // A coat on its way is finished first when the inputs change again, unless it has taken long.
  bool update(const Inputs& inputs, Warnings& warnings);
  // What is on its way is given up if the inputs ask for another coat.
  void dropUnlessFor(const Inputs& inputs);
  bool active(const Inputs& inputs) const { return growth_ || asksForAnother(inputs); }
  std::uint64_t revision() const { return revision_; }

  // The receiver has lost its layers, or is another: all grow anew.
  void forgetLayers();

  bool shown() const { return shown_; }  // the receiver has a coat
  // What the inputs ask for, if only of fewer layers.
  bool shows(const Inputs& inputs) const { return shown_ && !asksForAnother(inputs) && (!growth_ || showsCoarse_); }
  bool growing() const { return growth_.has_value(); }
  bool isCoarse() const { return coarse_ || showsCoarse_; }  // the one that is shown, or is to be next
  // 0..1: how far the coat is that the inputs ask for; 1: it is shown.
  float progress(const Inputs& inputs) const;
  const DrawnCoat& coat() const { return coat_->first; }  // that is shown
  unsigned shownTypes() const { return shownTypes_; }
  // One a type.
  std::array<float, settings::kFurTypes> weights() const;

 private:
  bool asksForAnother(const Inputs& inputs) const;
  void begin(const Inputs& inputs, Warnings& warnings);
  void take(std::shared_ptr<const WholeCoat> coat);
  void takeCoarse();

  std::shared_ptr<const WholeCoat> coat_ = std::make_shared<WholeCoat>();
  std::optional<CoatGrowth> growth_;
  bool coarse_ = false, showsCoarse_ = false;  // that is one of fewer layers; it was one, and the whole one follows
  // What `growth_` or, without it, the coat that is shown was grown for.
  CoatParameters grownFor_;
  GivenCoats givenFor_;
  unsigned types_ = 1, shownTypes_ = 1;  // likewise; of the coat that is shown
  double seconds_ = 0;  // that growth_ has taken
  bool shown_ = false, changed_ = true;
  std::uint64_t revision_ = 0;
};

}  // namespace fur::app
