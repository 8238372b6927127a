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
  // The first two rows of the matrices that take the mesh's texture coordinates to those of each picture.
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

#define FUR_UNIT_NORMALS 28
#define FUR_UNIT_ROUGHNESS 29
#define FUR_UNIT_OCCLUSION 30
#define FUR_UNIT_EMISSIVE 31

#ifdef __cplusplus
}  // namespace fur::render::shared
#endif
