// Lines of their true width: whiskers and strands of long hair. One thinner than a pixel covers that share of it.

// How much of a pixel a line covers whose middle passes at this distance, as if the pixel stood along it; both in pixels.
float lineCoverage(float away, float width) { return clamp(0.5 * width + 0.5 - abs(away), 0.0, min(width, 1.0)); }

// Pixels from its middle to the edge of its ribbon: as far as its share of a pixel reaches, and on to where no sample of such a
// pixel lies. Vertices stand by turns on both sides.
float lineReach(int vertex, float width) { return (float(vertex & 1) - 0.5) * (width + 3.0); }
// That edge, of a ribbon that faces the eye; `pixel`: what one covers there, model units.
vec3 lineEdge(vec3 middle, vec3 tangent, vec3 toEye, float reach, float pixel) {
  vec3 side = cross(tangent, toEye);
  return middle + side * (reach * pixel * inversesqrt(max(dot(side, side), 1e-12)));
}
