// The layer of the fur tile that is shown at a height, in shells and shadows alike: layer l from l / N to (l + 1) / N. It was cut
// half a layer higher, and furgen/Coat.h says why.
float storedLayer(float h) { return h * storedLayers - 0.5; }
// What arrays do by themselves, where one texture holds the layers of one fur type.
float nearestLayer(float stored) { return clamp(floor(stored + 0.5), 0.0, storedLayers - 1.0); }
// Where the strands of a spot of the coverage (tile, layer, mip level) are: two layers may share them (furgen/Packing.h).
vec3 strandSpot(vec4 spot) {
  float layer = floor(spot.z + 0.5), type = floor((layer + 0.5) / storedLayers);
  return vec3(spot.xy, floor(strandShare * (layer - type * storedLayers)) + type * ceil(strandShare * storedLayers));
}
