#include "render/Programs.h"
#include "shared/Blocks.h"
#include "tests/render/Picture.h"

namespace fur::render {
namespace {

TEST(Programs, EveryVariantCompilesAndLinks) {
  test::Stage stage(16, 16);
  Programs programs;
  for (const auto& [shader, variant] : allVariants()) {
    const auto program = programs.use(shader, variant);
    EXPECT_TRUE(program) << (program ? "" : program.error().message);
  }
}

TEST(Blocks, HaveTheSizeThatTheDriverReserves) {
  test::Stage stage(16, 16);
  Programs programs;
  for (const auto& [shader, variant] : allVariants()) {
    const auto program = programs.use(shader, variant);
    ASSERT_TRUE(program);
    for (const auto& [name, bytes] : {std::pair("FrameBlock", sizeof(shared::FrameBlock)), std::pair("FurBlock", sizeof(shared::FurBlock))}) {
      const int reserved = program.value()->blockSize(name);
      if (reserved > 0) EXPECT_EQ(static_cast<std::size_t>(reserved), bytes) << name << " in shader " << static_cast<int>(shader);
    }
  }
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
