// Marschner's tables (hair/Marschner.h) as textures, made when a frame first asks for that model.
#pragma once

#include "gl/Objects.h"
#include "settings/Settings.h"

namespace fur::render {

// The exponent of the highlight on dry strands, in both models of light.
float dryShininess(const settings::Settings& settings);
// beta_R of Marschner's lobes on dry strands; the shaders narrow them where strands are wet.
float strandLobeWidth(const settings::Settings& settings);

class StrandTables {
 public:
  // Binds them to their units; nothing unless the settings choose Marschner. Bytes that were uploaded.
  std::size_t use(const settings::Settings& settings);
  std::size_t bytes() const { return m_.bytes() + n_.bytes(); }

 private:
  gl::Texture m_, n_;
  float width_ = 0;  // that m_ was made for
};

}  // namespace fur::render
