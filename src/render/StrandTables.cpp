#include "render/StrandTables.h"

#include "hair/Marschner.h"
#include "shared/Blocks.h"

namespace fur::render {

static_assert(hair::kStrandTableM == FUR_STRAND_M);
static_assert(hair::kStrandTableN.x == FUR_STRAND_N_X && hair::kStrandTableN.y == FUR_STRAND_N_Y);

// Silva et al. 2010, Eq. 3 for rho = 0.
float dryShininess(const settings::Settings& settings) { return settings.shininess * (1 - settings.wetGloss); }
float strandLobeWidth(const settings::Settings& settings) { return hair::lobeWidth(dryShininess(settings)); }

std::size_t StrandTables::use(const settings::Settings& settings) {
  if (settings.strandModel == 0) return 0;
  const std::size_t before = bytes();
  std::size_t uploaded = 0;
  const float width = strandLobeWidth(settings);
  if (width != width_) {
    m_ = gl::Texture({gl::TexelFormat::RGBA16F, hair::kStrandTableM, hair::kStrandTableM},
                     gl::bytesOf(hair::strandTableM(width)));
    uploaded = m_.bytes();
    width_ = width;
  }
  if (before == 0) {
    n_ = gl::Texture({gl::TexelFormat::RGBA16F, hair::kStrandTableN.x, hair::kStrandTableN.y},
                     gl::bytesOf(hair::strandTableN()));
    uploaded += n_.bytes();
  }
  m_.bind(FUR_UNIT_STRAND_M);
  n_.bind(FUR_UNIT_STRAND_N);
  return uploaded;
}

}  // namespace fur::render
