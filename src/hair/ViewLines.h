// Lines and colours of views of hair (HairView.h), of guides, springs and collision shapes.
#pragma once

#include <span>

#include "hair/Body.h"
#include "hair/Guides.h"
#include "hair/HairView.h"

namespace fur::hair {

// From blue by green and yellow to red, as weights are shown elsewhere; 0..1.
Vec3 heatColor(float x);
// One of many that neighbours in number do not share.
Vec3 colorOfNumber(std::uint32_t number);
ViewColor packColor(const Vec3& color, float alpha = 1);

// How a guide is drawn: `dots`: the width of its nodes, 0: none.
struct GuideStyle {
  Vec4 color{1};
  float width = 1, dots = 0, lift = 0;
};
void addGuide(std::vector<ViewLine>& lines, std::span<const GuideNode> chain, bool cubic, const GuideStyle& style);
// A chain's springs: from each node to its reference node (Simulation::references()), coloured by how far it is from there for the
// length of its segment, green to red.
void addSprings(std::vector<ViewLine>& lines, std::span<const Vec3> nodes, std::span<const Vec3> references, float pixels);
// A sphere or capsule by circles on it.
void addBody(std::vector<ViewLine>& lines, const Body& body, const Vec4& color, float width);

}  // namespace fur::hair
