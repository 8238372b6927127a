#include "render/Look.h"

#include "render/Views.h"

namespace fur::render {
namespace {

using Variants = std::set<std::pair<Shader, VariantBits>>;

Look lookOf(const Frame& frame) { return Look(frame, true, false); }

void addView(const Look& look, const ViewPart& part, Variants& asked) {
  switch (part.part) {
    case Part::Shells: asked.insert({Shader::Shell, look.shells(part.bits)}); break;
    case Part::Fins: asked.insert({Shader::Fin, look.fins(part.bits)}); break;
    case Part::Arrows: asked.insert({Shader::Arrow, look.arrows(part.bits)}); break;
    case Part::Skin: asked.insert({Shader::Skin, look.skin(part.bits)}); break;
    case Part::BareSkin: asked.insert({Shader::Skin, look.bareSkin(part.bits)}); break;
  }
}

// Of all kinds of frames: of the coat, with and without a picture on the model, and of all views.
Variants askedFor() {
  Variants asked;
  for (unsigned bits = 0; bits < 1u << 9; ++bits)
    for (int shadows = 0; shadows < 3; ++shadows) {
      const auto bit = [bits](int i) { return (bits >> i & 1u) != 0; };
      Frame frame;
      frame.wet = bit(0), frame.groomed = bit(1), frame.types = bit(2), frame.painted = bit(3), frame.shaped = bit(4);
      frame.settings.strandModel = bit(5);
      frame.settings.bendCurve = bit(6);
      frame.settings.shadows = shadows;
      frame.sample = bit(8);
      const Look look(frame, true, bit(7)), bald(frame, false, bit(7));
      // The skin's picture needs the types' shaders, and is one of the pictures.
      if (frame.types && frame.groomed && bit(7) && !frame.painted && !frame.shaped) {
        asked.insert({Shader::Skin, Look(frame, false, true, true).skin(kPlain)});
        asked.insert({Shader::Skin, Look(frame, true, true, true).bareSkin(kPlain)});
      }
      for (const VariantBits view : {+kPlain, +kViewSteps, +kViewOverdraw}) asked.insert({Shader::Shell, look.shells(view)});
      for (const VariantBits view : {+kPlain, +kViewOverdraw}) {
        asked.insert({Shader::Fin, look.fins(view)});
        asked.insert({Shader::Skin, look.skin(view)});
      }
      for (const VariantBits view : {+kPlain, +kViewOverdraw, +kViewShadow}) asked.insert({Shader::Skin, bald.skin(view)});
      asked.insert({Shader::Whisker, look.whiskers()});
      for (const ViewPart& part : kViewParts) addView(look, part, asked);
    }
  return asked;
}

TEST(Look, AsksForVariantsThatTestsCompileAndForAllOfThem) {
  const std::vector<std::pair<Shader, VariantBits>> listed = allVariants();
  const Variants compiled(listed.begin(), listed.end()), asked = askedFor();
  // Of those with paint, with Sheppard's bend and with borders a sample is compiled: what they add stands alone in the shaders.
  for (const auto& [shader, variant] : asked)
    if (!(variant & (kPainted | kPolynomial | kBorders))) EXPECT_TRUE(compiled.contains({shader, variant})) << static_cast<int>(shader) << " " << std::hex << variant;
  for (const auto& [shader, variant] : compiled)
    if (!(variant & kClassic) && (shader == Shader::Shell || shader == Shader::Fin || shader == Shader::Skin || shader == Shader::Whisker || shader == Shader::Arrow))
      EXPECT_TRUE(asked.contains({shader, variant})) << static_cast<int>(shader) << " " << std::hex << variant;
}

TEST(Look, OfTheMarchHasNothingOfTheTechniqueShells) {
  Frame frame;
  frame.wet = true;
  settings::Settings& s = frame.settings;
  const Look march = lookOf(frame);
  s.printedLobe = s.printedClumps = s.printedLight = true;
  s.finEdges = 1;
  const Look printed = lookOf(frame);
  for (const VariantBits view : {+kPlain, +kViewLayer, +kViewShadow, +kViewOverdraw}) {
    EXPECT_EQ(march.shells(view), printed.shells(view));
    EXPECT_EQ(march.fins(view), printed.fins(view));
    EXPECT_EQ(march.skin(view), printed.skin(view));
  }
  EXPECT_FALSE(printed.classic());
  s.technique = 1;
  EXPECT_TRUE(lookOf(frame).classic());
  EXPECT_EQ(lookOf(frame).classicFur() & (kPrintedLobe | kPrintedClumps | kPrintedLight), kPrintedLobe | kPrintedClumps | kPrintedLight);
  frame.wet = false;
  s.strandModel = 1;
  EXPECT_EQ(lookOf(frame).classicFur() & (kPrintedLobe | kPrintedClumps), 0u) << "of dry fur there are no clumps, and Marschner has a lobe of his own";
}

TEST(Look, OfViewsThatStudyTheMarchIsTheMarchs) {
  Frame frame;
  frame.settings.technique = 1;
  for (const View view : {View::Final, View::Shells, View::Fins}) {
    frame.settings.view = static_cast<int>(view);
    EXPECT_TRUE(lookOf(frame).classic());
  }
  for (const View view : {View::Layer, View::Overdraw, View::Steps, View::Shadow}) {
    frame.settings.view = static_cast<int>(view);
    EXPECT_FALSE(lookOf(frame).classic());
  }
}

TEST(Look, OfAViewHasNothingThatTheViewDoesNotShow) {
  Frame plain, lit;
  lit.settings.strandModel = 1;
  lit.settings.shadows = 2;
  lit.painted = true;
  for (const VariantBits view : {kViewTangents, kViewCoverage, kViewDominance, kViewTypes, kViewOffset, kViewClumps, kViewSteps})
    EXPECT_EQ(lookOf(plain).shells(view), lookOf(lit).shells(view)) << view;
  EXPECT_NE(lookOf(plain).shells(kPlain), lookOf(lit).shells(kPlain));
  // But where strands stand shows in all of them.
  Frame wet;
  wet.wet = true;
  for (const VariantBits view : {kViewTangents, kViewCoverage, kViewLayer, kViewShadow}) EXPECT_NE(lookOf(plain).shells(view), lookOf(wet).shells(view)) << view;
}

TEST(Look, OfSkinKnowsOfFurOnlyWhereItIsUnderFur) {
  Frame frame;
  frame.wet = frame.groomed = frame.types = true;
  const Look furry(frame, true, false), bald(frame, false, false);
  EXPECT_EQ(furry.skin(kPlain) & (kUnderFur | kWet | kGroomed | kTypes), kUnderFur | kWet | kGroomed | kTypes);
  EXPECT_EQ(bald.skin(kPlain) & (kUnderFur | kWet | kGroomed | kTypes), 0u);
  EXPECT_EQ(bald.skin(kPlain), furry.bareSkin(kPlain)) << "the view of the skin shows it as if it were bald";
}

TEST(Views, EachDrawsSomethingButThoseThatAreTheWholePicture) {
  for (int view = 0; view <= static_cast<int>(View::Layout); ++view) {
    const bool whole = View(view) == View::Final || View(view) == View::Overdraw || View(view) == View::Steps;
    const bool listed = std::any_of(std::begin(kViewParts), std::end(kViewParts), [&](const ViewPart& part) { return part.view == View(view); });
    EXPECT_NE(whole, listed) << view;
  }
}

}  // namespace
}  // namespace fur::render
