// What fur types have from files: coats (.fts) and colour maps. Settings, undo and states hold their numbers, which are made of
// what is in the file; this holds what they stand for.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <span>
#include <vector>

#include "app/stages/CoatStage.h"
#include "scene/FurData.h"
#include "settings/Settings.h"

namespace fur::app {

struct ColorMap {
  scene::EncodedImage file;
  int width = 0, height = 0;        // decoded, of `rgba`
  std::vector<std::uint8_t> rgba{};  // empty: it is to be decoded
};

class TypeShelf {
 public:
  // Both return the number.
  std::uint32_t add(GivenCoat coat, std::vector<std::uint8_t> file);
  std::uint32_t add(ColorMap map);
  // nullptr: there is none of that number.
  GivenCoat coat(std::uint32_t number) const;
  const ColorMap* picture(std::uint32_t number) const;

  // Pictures that are to be decoded; what they are, RGBA8.
  std::vector<std::uint32_t> pending() const;
  void provide(std::uint32_t number, int width, int height, std::vector<std::uint8_t> rgba);

  GivenCoats coatsOf(const settings::Settings& settings) const;
  // As files have them: all that the settings name, none where they name none. The last is of the skin.
  std::array<scene::TypeFiles, settings::kFurTypes + 1> filesOf(const settings::Settings& settings) const;
  // The numbers of what a file has, 0 where it has none. Error: one of them cannot be read.
  struct Numbers {
    std::array<std::uint32_t, settings::kFurTypes + 1> pictures{}, typeSets{};
  };
  Result<Numbers> addFiles(std::span<const scene::TypeFiles> files, const std::string& name);
  // Drops all others.
  void keepOnlyThoseOf(std::initializer_list<const settings::Settings*> all);
  std::uint64_t revision() const { return revision_; }  // another one whenever a picture has come or gone

 private:
  struct Coat {
    GivenCoat volume;
    std::vector<std::uint8_t> file;
  };
  std::map<std::uint32_t, Coat> coats_;
  std::map<std::uint32_t, ColorMap> pictures_;
  std::uint64_t revision_ = 1;
};

}  // namespace fur::app
