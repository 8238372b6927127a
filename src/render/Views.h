// What each view draws, in order: one table.
#pragma once

#include "render/Frame.h"
#include "render/Programs.h"

namespace fur::render {

enum class Part { Shells, Fins, Skin, BareSkin, Arrows };

struct ViewPart {
  View view;
  Part part;
  VariantBits bits;  // that the part's shader has for the view
};

// All but Final, Overdraw and Steps, which draw the whole picture (Renderer.cpp).
inline constexpr ViewPart kViewParts[] = {
    {View::Skin, Part::BareSkin, kPlain},
    {View::Shells, Part::Shells, kPlain},
    {View::Fins, Part::BareSkin, kViewDim},
    {View::Fins, Part::Fins, kPlain},
    {View::Layer, Part::BareSkin, kViewDim},
    {View::Layer, Part::Shells, kViewLayer},
    {View::Exploded, Part::BareSkin, kViewDim},
    {View::Exploded, Part::Shells, kViewLayer | kViewExploded},
    {View::Silhouette, Part::BareSkin, kViewDim},
    {View::Silhouette, Part::Fins, kViewEdges},
    {View::Coverage, Part::Shells, kViewCoverage},
    {View::Tangents, Part::Shells, kViewTangents},
    {View::Normals, Part::BareSkin, kViewNormals},
    {View::Dominance, Part::Shells, kViewDominance},
    {View::Types, Part::Shells, kViewTypes},
    {View::Offset, Part::Shells, kViewOffset},
    {View::Wetness, Part::BareSkin, kViewWetness},
    {View::Clumps, Part::Shells, kViewClumps},
    {View::Clumps, Part::BareSkin, kViewClumps},
    {View::Shadow, Part::Shells, kViewShadow},
    {View::Shadow, Part::Fins, kViewShadow},
    {View::Shadow, Part::Skin, kViewShadow},
    {View::Bends, Part::BareSkin, kViewDim},
    {View::Bends, Part::Arrows, kPlain},
    {View::Forces, Part::BareSkin, kViewDim},
    {View::Forces, Part::Arrows, kViewForces},
    {View::Layout, Part::BareSkin, kViewLayout},
};

}  // namespace fur::render
