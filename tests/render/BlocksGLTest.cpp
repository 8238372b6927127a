#include <cstddef>
#include <string>
#include <vector>

#include "render/Programs.h"
#include "shared/Blocks.h"
#include "shared/Hair.h"
#include "shared/Material.h"
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

#define FUR_MEMBER(block, name) \
  Member { #name, offsetof(shared::block, name), sizeof(shared::block::name) }

struct Member {
  const char* name;
  std::size_t offset, size;
};

// In the order of shared/Blocks.h and Hair.h.
std::vector<Member> frameMembers() {
  return {
      FUR_MEMBER(FrameBlock, clipFromModel), FUR_MEMBER(FrameBlock, clipFromWorld), FUR_MEMBER(FrameBlock, worldFromModel),
      FUR_MEMBER(FrameBlock, lightFromModel), FUR_MEMBER(FrameBlock, eye), FUR_MEMBER(FrameBlock, light),
      FUR_MEMBER(FrameBlock, lightWorld), FUR_MEMBER(FrameBlock, up), FUR_MEMBER(FrameBlock, keyLight),
      FUR_MEMBER(FrameBlock, backLight), FUR_MEMBER(FrameBlock, sky), FUR_MEMBER(FrameBlock, floorLight),
      FUR_MEMBER(FrameBlock, backgroundTop), FUR_MEMBER(FrameBlock, backgroundBottom), FUR_MEMBER(FrameBlock, ballCentre),
      FUR_MEMBER(FrameBlock, chance),
      FUR_MEMBER(FrameBlock, pixelsPerUnit), FUR_MEMBER(FrameBlock, lightIntensity), FUR_MEMBER(FrameBlock, fillLight),
      FUR_MEMBER(FrameBlock, exposure), FUR_MEMBER(FrameBlock, samples), FUR_MEMBER(FrameBlock, viewLayer),
      FUR_MEMBER(FrameBlock, pictureHeight), FUR_MEMBER(FrameBlock, bottomRow), FUR_MEMBER(FrameBlock, groundCentre),
      FUR_MEMBER(FrameBlock, groundHeight), FUR_MEMBER(FrameBlock, groundHalfSide),
      FUR_MEMBER(FrameBlock, ballRadius), FUR_MEMBER(FrameBlock, shadowExtinction), FUR_MEMBER(FrameBlock, shadowBias),
      FUR_MEMBER(FrameBlock, shadowLayerDepth), FUR_MEMBER(FrameBlock, shadowSurface), FUR_MEMBER(FrameBlock, shadowRange),
      FUR_MEMBER(FrameBlock, stepLength), FUR_MEMBER(FrameBlock, sampleShare), FUR_MEMBER(FrameBlock, transparent),
      FUR_MEMBER(FrameBlock, finer), FUR_MEMBER(FrameBlock, drawnShare),
  };
}
std::vector<Member> furMembers() {
  return {
      FUR_MEMBER(FurBlock, rootColors), FUR_MEMBER(FurBlock, tipColors), FUR_MEMBER(FurBlock, skinColors),
      FUR_MEMBER(FurBlock, typeGrows), FUR_MEMBER(FurBlock, typeVariance), FUR_MEMBER(FurBlock, typeRise),
      FUR_MEMBER(FurBlock, typeDensity), FUR_MEMBER(FurBlock, typeShadow), FUR_MEMBER(FurBlock, typeOcclusion),
      FUR_MEMBER(FurBlock, typeSpecular), FUR_MEMBER(FurBlock, typeShininess), FUR_MEMBER(FurBlock, typeDryShininess),
      FUR_MEMBER(FurBlock, typePicture), FUR_MEMBER(FurBlock, furLength), FUR_MEMBER(FurBlock, tilesPerUnit),
      FUR_MEMBER(FurBlock, layers), FUR_MEMBER(FurBlock, layersLog), FUR_MEMBER(FurBlock, tileTexels),
      FUR_MEMBER(FurBlock, storedLayers), FUR_MEMBER(FurBlock, densest), FUR_MEMBER(FurBlock, maskTexels),
      FUR_MEMBER(FurBlock, lambert), FUR_MEMBER(FurBlock, textureAmount), FUR_MEMBER(FurBlock, chartsOverlap),
      FUR_MEMBER(FurBlock, clumpShape), FUR_MEMBER(FurBlock, wetDarkening), FUR_MEMBER(FurBlock, wetGloss),
      FUR_MEMBER(FurBlock, lobePeak), FUR_MEMBER(FurBlock, skinPicture), FUR_MEMBER(FurBlock, clumpRadius),
      FUR_MEMBER(FurBlock, strandShare),
  };
}
std::vector<Member> hairMembers() {
  return {
      FUR_MEMBER(HairBlock, hairRootColor), FUR_MEMBER(HairBlock, hairTipColor), FUR_MEMBER(HairBlock, nodesLow),
      FUR_MEMBER(HairBlock, nodesSpan), FUR_MEMBER(HairBlock, guideNodes), FUR_MEMBER(HairBlock, cubicGuides),
      FUR_MEMBER(HairBlock, curl), FUR_MEMBER(HairBlock, curls), FUR_MEMBER(HairBlock, tipWidth),
      FUR_MEMBER(HairBlock, hairDepth), FUR_MEMBER(HairBlock, strandWidth), FUR_MEMBER(HairBlock, hairVariance),
      FUR_MEMBER(HairBlock, firstWisp), FUR_MEMBER(HairBlock, strandsDrawn), FUR_MEMBER(HairBlock, pointStep),
      FUR_MEMBER(HairBlock, hairOpacity), FUR_MEMBER(HairBlock, hairShininess), FUR_MEMBER(HairBlock, widening),
      FUR_MEMBER(HairBlock, hairExtinction), FUR_MEMBER(HairBlock, hairShadowBias),
      FUR_MEMBER(HairBlock, hairOcclusion), FUR_MEMBER(HairBlock, hairGloss), FUR_MEMBER(HairBlock, hairBlend), FUR_MEMBER(HairBlock, skinCover),
      FUR_MEMBER(HairBlock, wispsDrawn), FUR_MEMBER(HairBlock, wispWidening),
  };
}

std::vector<Member> materialMembers() {
  return {
      FUR_MEMBER(MaterialBlock, baseColorFactor), FUR_MEMBER(MaterialBlock, emissiveFactor), FUR_MEMBER(MaterialBlock, normalRows),
      FUR_MEMBER(MaterialBlock, roughnessRows), FUR_MEMBER(MaterialBlock, occlusionRows), FUR_MEMBER(MaterialBlock, emissiveRows),
      FUR_MEMBER(MaterialBlock, metallicFactor), FUR_MEMBER(MaterialBlock, roughnessFactor), FUR_MEMBER(MaterialBlock, normalScale),
      FUR_MEMBER(MaterialBlock, occlusionStrength), FUR_MEMBER(MaterialBlock, alphaMode), FUR_MEMBER(MaterialBlock, alphaCutoff),
  };
}

struct Block {
  const char* name;
  std::size_t bytes;
  std::vector<Member> members;
};

std::vector<Block> blocks() {
  return {
      {"FrameBlock", sizeof(shared::FrameBlock), frameMembers()},
      {"FurBlock", sizeof(shared::FurBlock), furMembers()},
      {"HairBlock", sizeof(shared::HairBlock), hairMembers()},
      {"MaterialBlock", sizeof(shared::MaterialBlock), materialMembers()},
  };
}

// In slices, which run side by side in as many shares as there are cores: compiling every variant takes longest of all GL tests, so
// that each is compiled once for all that is asked of it.
class ProgramsSlice : public testing::TestWithParam<std::size_t> {};

constexpr std::size_t kSlices = 8;

TEST_P(ProgramsSlice, EveryVariantCompilesAndLinksAndHasItsBlocksAsWeFillThem) {
  test::Stage stage(16, 16);
  Programs programs;
  const auto all = allVariants();
  for (std::size_t i = GetParam(); i < all.size(); i += kSlices) {
    const gl::Program* program = programs.use(all[i].first, all[i].second);
    ASSERT_TRUE(program) << programs.error().message;
    for (const Block& block : blocks()) {
      const int reserved = program->blockSize(block.name);
      if (reserved == 0) continue;
      EXPECT_EQ(static_cast<std::size_t>(reserved), block.bytes) << block.name << " in shader " << static_cast<int>(all[i].first);
      for (const Member& member : block.members) {
        const int offset = program->offsetInBlock(member.name);
        if (offset >= 0) EXPECT_EQ(static_cast<std::size_t>(offset), member.offset) << member.name << " in shader " << static_cast<int>(all[i].first);
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Programs, ProgramsSlice, testing::Range(std::size_t{0}, kSlices));

TEST(Blocks, HaveNoPaddingBetweenTheirMembersWhichAreAllListedHere) {
  for (const auto& [name, bytes, members] : blocks()) {
    std::size_t end = 0;
    for (const Member& member : members) {
      EXPECT_EQ(member.offset, end) << member.name;
      end = member.offset + member.size;
    }
    // A block ends with a whole vec4.
    EXPECT_EQ((end + 15) / 16 * 16, bytes) << name;
  }
}

TEST(Blocks, HaveNoMemberThatNoShaderReads) {
  test::Stage stage(16, 16);
  Programs programs;
  std::vector<std::string> unread;
  for (const Block& block : blocks())
    for (const Member& member : block.members) unread.push_back(member.name);
  // Later variants read most of them: from the last on, and no further than is needed.
  const auto all = allVariants();
  for (auto one = all.rbegin(); one != all.rend() && !unread.empty(); ++one) {
    const gl::Program* program = programs.use(one->first, one->second);
    ASSERT_TRUE(program);
    std::erase_if(unread, [&](const std::string& name) { return program->offsetInBlock(name.c_str()) >= 0; });
  }
  EXPECT_EQ(unread, std::vector<std::string>());
}

TEST(Programs, ARefusedShaderIsATypedErrorWithTheDriversWords) {
  test::Stage stage(16, 16);
  const auto program = gl::Program::link("broken", "void main() { gl_Position = nowhere; }", "void main() {}");
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().id, ErrorId::WebglUnavailable);
  EXPECT_NE(program.error().message.find("broken.vert"), std::string::npos);
  EXPECT_NE(program.error().message.find("nowhere"), std::string::npos);
}

}  // namespace
}  // namespace fur::render
