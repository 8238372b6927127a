// Four guides as they are shown.
#pragma once

#include "hair/GuideBlocks.h"

namespace fur::hair {

// Of a block, where `share` of the way lies between its last two steps as seen from its roots, with the roots where they are now;
// `shown`: guide after guide, all of them.
void showBlock(const GuideBlocks& guides, std::size_t block, const FrameLanes& now, float share, std::span<GuideNode> shown);

}  // namespace fur::hair
