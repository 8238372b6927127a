// Evaluates one shared function at two numbers a pixel and writes the result as 24-bit fixed point
// over [-2, 2): how the tests hold the shaders against their C++ twins. Never drawn on screen.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
out vec4 fragColor;

vec3 onCircle(float angle) { return vec3(sin(angle), 0.0, cos(angle)); }

void main() {
  vec2 at = (gl_FragCoord.xy - 0.5) / float(FUR_TWIN_SIZE - 1);  // 0..1, both ends included
#if FUNCTION == 0
  float value = arcBend(at.x * 1.35, at.y).x;
#elif FUNCTION == 1
  float value = arcBend(at.x * 1.35, at.y).y;
#elif FUNCTION == 2
  float value = clumpProfile(mix(1.0 / 32.0, 1.0, at.x), at.y, 32.0);
#elif FUNCTION == 3
  float value = furShadow(at.x, 0.6, at.y * 2.0 - 1.0);
#elif FUNCTION == 4
  float value = encodeSrgb(vec3(at.x)).x;
#elif FUNCTION == 5
  float value = kajiyaDiffuse(onCircle(at.x * 3.0), onCircle(at.y * 3.0));
#else
  float value = kajiyaSpecular(vec3(1.0, 0.0, 0.0), onCircle(at.x * 3.0), onCircle(at.y * 3.0), 12.0);
#endif
  float fixedPoint = floor(clamp((value + 2.0) / 4.0, 0.0, 0.9999999) * 16777216.0);
  vec3 bytes = floor(mod(fixedPoint / vec3(65536.0, 256.0, 1.0), 256.0));
  fragColor = vec4(bytes / 255.0, 1.0);
}
