// Each node on a spring to where the rest shape has it (Halen & Wester 2007, 4.4). Springs are solved implicitly, for any stiffness:
// a node that coasts ends where |p - coasting|^2 + w |p - goal|^2 is least. Other forces act beside them; at rest these are the
// lengths' to hold.
#include "hair/Lengths.h"
#include "hair/MotionModels.h"

namespace fur::hair {

void springModel(const FourGuides& four, const StepValues& values, Lanes3* next) {
  for (int i = 2; i < four.nodes; ++i) {
    const Lanes light = four.lightness(i);
    const Lanes w = min(four.stiffness[i] * light * (values.tilt * kStep * kStep), splat(kStiffest));
    const Lanes3 coasting = four.stepped(values, i, Lanes3{});
    next[i] = coasting + (four.goals[i] - coasting) * (w / (1.0f + w)) + four.acceleration(values, i, light) * splat(kStep * kStep);
  }
  relaxLengths(four.lengths, four.nodes, four.positions, next);
}

}  // namespace fur::hair
