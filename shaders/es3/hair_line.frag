// A line of a view of hair; what other things hide of it is faint.
precision highp float;
in vec3 vPlace;
flat in vec4 vColor;
flat in float vRadius;
out vec4 fragColor;

void main() {
  float beyond = max(max(-vPlace.y, vPlace.y - vPlace.z), 0.0);
  float alpha = vColor.a * clamp(vRadius + 0.5 - length(vec2(vPlace.x, beyond)), 0.0, min(2.0 * vRadius, 1.0));
#ifdef HIDDEN
  alpha *= 0.22;
#endif
  fragColor = vec4(vColor.rgb * alpha, alpha);
}
