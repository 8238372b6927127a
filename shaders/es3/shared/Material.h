// What the shader of bare parts shares with C++, as Blocks.h; apart from it, as a block counts as used wherever it is declared.
#ifdef __cplusplus
#pragma once
#include "shared/Blocks.h"
namespace fur::render::shared {
#endif

// A material of glTF (2.0, 3.9). One a bare part.
FUR_BLOCK(MaterialBlock) {
  vec4 baseColorFactor;  // linear
  vec4 emissiveFactor;   // linear
  // The first two rows of the matrices that take the mesh's texture coordinates to those of each picture. w: 1 takes its others.
  vec4 normalRows[2];
  vec4 roughnessRows[2];
  vec4 occlusionRows[2];
  vec4 emissiveRows[2];

  float metallicFactor;
  float roughnessFactor;
  float normalScale;
  float occlusionStrength;

  float alphaMode;       // 0: opaque, 1: what is below the cutoff is not there, 2: blended
  float alphaCutoff;
};

#define FUR_MATERIAL_BINDING 3

// Those of long hair, which binds its own before each draw: coats find theirs as they were, whichever is drawn first.
#define FUR_UNIT_NORMALS 24
#define FUR_UNIT_ROUGHNESS 25
#define FUR_UNIT_OCCLUSION 26
#define FUR_UNIT_EMISSIVE 27

#ifdef __cplusplus
}  // namespace fur::render::shared
#endif
