// What all renderers in one GL context share, so that many of them take little more than one: shaders are compiled once.
#pragma once

#include "render/FurTextures.h"
#include "render/Materials.h"
#include "render/Programs.h"

namespace fur::render {

struct ContextObjects {
  Programs programs;
  gl::PlatformFramebuffer framebuffer{};
  SharedThings pictures{};  // of models: SharedPicture, by where their pixels are and how they repeat
  SharedThings coats{};     // FurTextures::Coat, by what they were grown for
};

}  // namespace fur::render
