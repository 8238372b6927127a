// Adds opacity to every layer of the fur's shadow map that lies deeper than the fragment.
layout(location = 0) out vec4 layers0;
layout(location = 1) out vec4 layers1;
layout(location = 2) out vec4 layers2;
layout(location = 3) out vec4 layers3;

void addOpacity(float opacity) {
  float z = gl_FragCoord.z * shadowRange - unpack(packedDepths(ivec2(gl_FragCoord.xy)).rg) * shadowRange;
  // Half a layer on, or rounding would count the first surface as lying before itself.
  float deep = z / shadowLayerDepth + 0.5;
  const vec4 four = vec4(0.0, 1.0, 2.0, 3.0);
  layers0 = opacity * step(deep, four);
  layers1 = opacity * step(deep - 4.0, four);
  layers2 = opacity * step(deep - 8.0, four);
  layers3 = opacity * step(deep - 12.0, four);
}
