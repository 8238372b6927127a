// Chains of nodes and balls that meet them: what the tools of GuideEdits.h are made of.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "groom/GroomBrush.h"
#include "hair/Guides.h"

namespace fur::hair {

inline bool isFinite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool isUsable(const groom::Brush& brush);

// The greatest weight along the line through the nodes.
float weightOfLine(const groom::Brush& brush, std::span<const Vec3> chain);
// The length of the chain up to where it enters the ball; all of it where it does not.
float lengthBefore(const groom::Brush& brush, std::span<const Vec3> chain);
// The nodes up to that length, the last of them there.
std::vector<Vec3> cutAt(std::span<const Vec3> chain, float length);

std::vector<float> segmentLengths(std::span<const Vec3> chain);
// From node `first` on, each is drawn along by the one before, as a rope: into its length from there.
void draw(std::span<Vec3> chain, std::span<const float> lengths, std::size_t first);

}  // namespace fur::hair
