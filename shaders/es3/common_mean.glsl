// Between a picture as it is shown and the light of it, of which means are taken: so grain has the brightness that it has from afar, and
// bright strands before dark gaps are not too dark. Exact, that one sample comes back as it was.
vec3 lightOf(vec3 c) { return mix(c / 12.92, pow((max(c, 0.0) + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
vec3 shownOf(vec3 c) { return mix(c * 12.92, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
