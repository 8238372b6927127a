#include "render/Look.h"

#include "render/passes/shadow/FurShadow.h"

namespace fur::render {

namespace {

constexpr VariantBits kFurOnly = kGroomed | kTypes;

// Of a look, what a view shows, so that fewer shaders are compiled.
VariantBits shown(VariantBits look, VariantBits view) {
  VariantBits kept = ~VariantBits{0};
  constexpr VariantBits kStands = kWet | kGroomed | kTypes | kShaped;  // where strands stand
  if (view & (kViewTangents | kViewCoverage | kViewDominance | kViewTypes | kViewOffset | kViewClumps | kViewSteps)) kept = kStands;
  if (view & kViewShadow) kept = ~(kMarschner | kTextured | kPainted);
  if (view & kViewLayer) kept = kStands | kTextured | kPainted;
  if (view & (kViewOverdraw | kViewEdges)) kept = kPlain;
  return (look & kept) | view;
}

VariantBits finalLook(const Frame& frame, bool textured) {
  return (frame.wet ? kWet : kPlain) | (textured ? kTextured : kPlain) | (frame.settings.strandModel ? kMarschner : kPlain) |
         shadowVariant(frame.settings) | (frame.types ? kTypes : kPlain) |
         (frame.groomed || frame.types || frame.shaped ? kGroomed : kPlain) | (frame.painted ? kPainted : kPlain) |
         (frame.shaped ? kShaped : kPlain);
}

bool showsClassic(const settings::Settings& s) {
  const auto view = static_cast<View>(s.view);
  return s.technique == 1 && (view == View::Final || view == View::Shells || view == View::Fins);
}

VariantBits printedVariant(const Frame& frame) {
  const settings::Settings& s = frame.settings;
  return (s.printedLobe && !s.strandModel ? kPrintedLobe : kPlain) | (s.printedClumps && frame.wet ? kPrintedClumps : kPlain) |
         (s.printedLight ? kPrintedLight : kPlain);
}

// Skin has no strands of its own.
constexpr VariantBits kNotOfSkin = kWet | kMarschner | kShaped;

}  // namespace

Look::Look(const Frame& frame, bool furry, bool textured, bool skinPictured)
    : furry_(furry), wetHair_(frame.wetHair), classic_(showsClassic(frame.settings)), notOfBare_(skinPictured ? +kPlain : kFurOnly), final_(finalLook(frame, textured)),
      bend_(curveVariant(frame.settings)), borders_(frame.wet && isFiner(frame) ? kBorders : kPlain), printed_(printedVariant(frame)) {}

VariantBits Look::shells(VariantBits view) const { return bend_ | shown(final_, view) | (view == kPlain || view == kViewClumps ? borders_ : +kPlain); }

// Edges that pass the fins' test are lines, which do not bend.
VariantBits Look::fins(VariantBits view) const { return view & kViewEdges ? view : bend_ | shown(final_, view); }

VariantBits Look::skin(VariantBits view) const {
  VariantBits look = final_ & ~kNotOfSkin;
  if (view == kViewShadow) look &= ~kFurOnly;
  else if (!furry_) look &= ~notOfBare_;
  if (furry_) look |= kUnderFur | (view == kPlain ? final_ & kWet : +kPlain);
  if (furry_ && classic_) look |= kClassic;
  return shown(look, view);
}

VariantBits Look::bareSkin(VariantBits view) const { return view ? view : final_ & ~(kNotOfSkin | notOfBare_); }

VariantBits Look::whiskers() const { return bend_ | (final_ & ~(kTextured | kFurOnly | kPainted | kShaped)); }

// Its guides bend it, and it has colours of its own.
VariantBits Look::hair() const { return (final_ & (kMarschner | kShadowDepth | kShadowLayers)) | (wetHair_ ? kWet : kPlain); }

}  // namespace fur::render
