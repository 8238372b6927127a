// Where the layers of the fur tile are in its textures.
// `between`: less than half a layer, by which the border between two is moved.
float storedLayer(float h, float between) { return h * storedLayers + between - 0.5; }
// What arrays do by themselves, where one texture holds the layers of one fur type.
float nearestLayer(float stored) { return clamp(floor(stored + 0.5), 0.0, storedLayers - 1.0); }
