#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

#include "scene/Material.h"

namespace fur::scene {

namespace {

// Words begin so.
constexpr std::string_view kBare[] = {
    "eye",   "iris",  "pupil", "cornea", "sclera",  "lens",  "claw",  "nail",  "toe",  "hoof",   "hoov",   "horn",   "antler", "tusk",  "teeth",  "tooth",
    "fang",  "tongue", "gum",  "mouth",  "nose",    "beak",  "bill",  "pad",   "cloth",  "collar", "shirt",  "pants",  "trouser", "dress", "shoe",
    "boot",  "belt",  "buckle", "glass", "metal",   "leather", "plastic", "harness", "saddle", "bridle", "armor", "armour", "scarf", "button", "jewel",
    "bell",  "strap",
};
constexpr std::string_view kBareWhole[] = {"hat", "tag", "bow", "cap"};
constexpr std::string_view kFurry[] = {"fur", "coat", "pelt", "wool", "fleece", "hair", "mane", "tail", "plush"};

enum class Says { Nothing, Bare, Furry };

Says saysWord(const std::string& word) {
  const auto begins = [&](std::string_view with) { return word.starts_with(with); };
  if (std::any_of(std::begin(kFurry), std::end(kFurry), begins)) return Says::Furry;
  const bool whole = std::find(std::begin(kBareWhole), std::end(kBareWhole), word) != std::end(kBareWhole);
  return whole || std::any_of(std::begin(kBare), std::end(kBare), begins) ? Says::Bare : Says::Nothing;
}

// Words end where other than letters stand and where a capital follows a small letter. What speaks of fur counts more.
Says saysName(const std::string& name) {
  Says says = Says::Nothing;
  std::string word;
  bool small = false;
  const auto end = [&] {
    const Says now = saysWord(word);
    if (now == Says::Furry || says == Says::Nothing) says = now;
    word.clear();
  };
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool capital = std::isupper(byte);
    if (!std::isalpha(byte) || (capital && small)) end();
    small = std::islower(byte);
    if (std::isalpha(byte)) word += static_cast<char>(std::tolower(byte));
  }
  end();
  return says;
}

}  // namespace

void guessBare(std::vector<Material>& materials) {
  for (Material& material : materials) {
    const Says says = saysName(material.name);
    material.bare = says == Says::Bare || (says == Says::Nothing && material.alpha == AlphaMode::Blend);
  }
  if (std::all_of(materials.begin(), materials.end(), [](const Material& material) { return material.bare; }))
    for (Material& material : materials) material.bare = false;
}

}  // namespace fur::scene
