// The text of the shaders of long hair, which only programs that grow hair carry.
#pragma once

namespace fur::render {

// To be called before any hair is drawn.
void provideHairShaders();

}  // namespace fur::render
