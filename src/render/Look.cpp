#include "render/Look.h"

#include "render/passes/shadow/FurShadow.h"

namespace fur::render {

namespace {

constexpr unsigned kFurOnly = kGroomed | kTypes;

// Of a look, what a view shows, so that fewer shaders are compiled.
unsigned shown(unsigned look, unsigned view) {
  unsigned kept = ~0u;
  constexpr unsigned kStands = kWet | kGroomed | kTypes | kShaped;  // where strands stand
  if (view & (kViewTangents | kViewCoverage | kViewDominance | kViewTypes | kViewOffset | kViewClumps | kViewSteps)) kept = kStands;
  if (view & kViewShadow) kept = ~(kMarschner | kTextured | kPainted);
  if (view & kViewLayer) kept = kStands | kTextured | kPainted;
  if (view & (kViewOverdraw | kViewEdges)) kept = kPlain;
  return (look & kept) | view;
}

unsigned finalLook(const Frame& frame, bool textured) {
  return (frame.wet ? kWet : kPlain) | (textured ? kTextured : kPlain) | (frame.settings.strandModel ? kMarschner : kPlain) |
         shadowVariant(frame.settings) | (frame.types ? kTypes : kPlain) |
         (frame.groomed || frame.types || frame.shaped ? kGroomed : kPlain) | (frame.painted ? kPainted : kPlain) |
         (frame.shaped ? kShaped : kPlain);
}

// Skin has no strands of its own.
constexpr unsigned kNotOfSkin = kWet | kMarschner | kShaped;

}  // namespace

Look::Look(const Frame& frame, bool furry, bool textured)
    : furry_(furry), wetHair_(frame.wetHair), final_(finalLook(frame, textured)), bend_(curveVariant(frame.settings)) {}

unsigned Look::shells(unsigned view) const { return bend_ | shown(final_, view); }

// Edges that pass the fins' test are lines, which do not bend.
unsigned Look::fins(unsigned view) const { return view & kViewEdges ? view : bend_ | shown(final_, view); }

unsigned Look::skin(unsigned view) const {
  unsigned look = final_ & ~kNotOfSkin;
  if (!furry_ || view == kViewShadow) look &= ~kFurOnly;
  if (furry_) look |= kUnderFur | (view == kPlain ? final_ & kWet : +kPlain);
  return shown(look, view);
}

unsigned Look::bareSkin(unsigned view) const { return view ? view : final_ & ~(kNotOfSkin | kFurOnly); }

unsigned Look::whiskers() const { return bend_ | (final_ & ~(kTextured | kFurOnly | kPainted | kShaped)); }

// Its guides bend it, and it has colours of its own.
unsigned Look::hair() const { return (final_ & (kMarschner | kShadowDepth | kShadowLayers)) | (wetHair_ ? kWet : kPlain); }

}  // namespace fur::render
