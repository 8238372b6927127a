// How much of a pixel hair covers.
#include "shared/Hair.h"

// A whole number of its samples, by chance: drivers differ in what they make of the shares between.
float wholeSamples(float alpha, float chance) { return floor(alpha * samples + chance) / samples; }
