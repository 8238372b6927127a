// What all renderers in one GL context share, so that many of them take little more than one: shaders are compiled once.
#pragma once

#include "render/Materials.h"
#include "render/Programs.h"

namespace fur::render {

struct ContextObjects {
  Programs programs;
  SharedPictures pictures;
};

}  // namespace fur::render
