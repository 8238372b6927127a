// The materials of the model's parts: furry ones give the coat and the skin under it their picture and colour, bare ones are
// drawn as glTF has them (passes/bare).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/SharedThings.h"
#include "gl/Objects.h"
#include "scene/Material.h"
#include "shared/Blocks.h"

namespace fur::render {

// A picture on the GPU. It keeps its pixels, whose place stands for them while it is there.
using Pixels = std::shared_ptr<std::vector<std::uint8_t>>;
struct SharedPicture {
  Pixels pixels;
  gl::Texture texture;
};

class Materials {
 public:
  // One plain one. Needs a context. Returns the bytes that were uploaded, as all here.
  std::size_t create();
  // Of another model, at least one, without pictures; `main`: which of them stands for all where there can be only one.
  std::size_t set(std::span<const scene::Material> materials, std::size_t main);
  // One of each, 0 or 1; none: none is.
  void setBare(std::span<const std::uint8_t> bare);
  // Straight RGBA8 in sRGB, of the model's images; taken from `shared` where others show the same pixels.
  std::size_t setImage(std::size_t image, int width, int height, const Pixels& rgba, SharedThings& shared);

  std::size_t count() const { return parts_.size(); }
  std::size_t main() const { return main_; }
  const scene::Material& at(std::size_t i) const { return parts_[i].material; }
  bool isBare(std::size_t i) const { return parts_[i].bare; }
  bool anyBare() const { return anyBare_; }
  // A furry one has one, which is white where others have it and it has none.
  bool hasPicture() const { return hasPicture_; }

  // The coat in the colours of each furry one.
  void updateCoat(std::size_t i, const shared::FurBlock& coat) { parts_[i].coat.update(gl::bytesOf(coat)); }
  // Its picture and its coat, for the shaders of skin and fur.
  void bind(std::size_t i) const;
  // All its pictures and values, for the shader of bare parts.
  void bindBare(std::size_t i) const;
  std::size_t bytes() const;

 private:
  struct Part {
    scene::Material material;
    gl::Buffer coat, block;
    bool bare = false;
  };
  const gl::Texture& pictureOf(const scene::MaterialTexture& texture, const gl::Texture& without) const;
  void findPictures();

  std::vector<Part> parts_;
  std::vector<std::shared_ptr<SharedPicture>> images_;
  gl::Texture white_, flat_;  // flat: the normal of a surface without bumps
  std::size_t main_ = 0;
  bool anyBare_ = false, hasPicture_ = false;
};

}  // namespace fur::render
