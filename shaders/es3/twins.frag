// Evaluates one shared function at two numbers a pixel and writes the result as 24-bit fixed point
// over [-2, 2): how the tests hold the shaders against their C++ twins. Never drawn on screen.
#if FUNCTION == 19 || FUNCTION == 20
#define POLYNOMIAL 1
#endif
#include "common.glsl"
#if FUNCTION == 9
#define MARSCHNER 1
#endif
#define PRINTED_LIGHT 1
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_classic.glsl"
#include "common_furshadow.glsl"
#include "common_types.glsl"
out vec4 fragColor;
#if (FUNCTION >= 24 && FUNCTION <= 28) || FUNCTION == 43 || FUNCTION == 49 || FUNCTION == 50
uniform sampler2D mask;
#endif

vec3 onCircle(float angle) { return vec3(sin(angle), 0.0, cos(angle)); }

void main() {
  vec2 at = (gl_FragCoord.xy - 0.5) / float(FUR_TWIN_SIZE - 1);  // 0..1, both ends included
#if FUNCTION == 0 || FUNCTION == 19
  float value = arcBend(at.x * 1.35, at.y).x;
#elif FUNCTION == 1 || FUNCTION == 20
  float value = arcBend(at.x * 1.35, at.y).y;
#elif FUNCTION == 2
  float value = clumpProfile(mix(1.0 / 32.0, 1.0, at.x), at.y, 1.0 / 32.0, 1.0 / naturalLog(32.0));
#elif FUNCTION == 3
  float value = furShadow(at.x, 0.6, at.y * 2.0 - 1.0);
#elif FUNCTION == 4
  float value = encodeSrgb(vec3(at.x)).x;
#elif FUNCTION == 5
  float value = kajiyaLobe(at.x * 2.0 - 1.0, at.y * 60.0);
#elif FUNCTION == 7
  float value = shadeStrand(vec3(0.5, 0.3, 0.2), onCircle(at.x * 3.0), onCircle(0.7), onCircle(-0.4), at.y, 0.3, 0.8, 0.5, at.x).x;
#elif FUNCTION == 8
  float value = toneMap(vec3(at.x * 3.0)).x;
#elif FUNCTION == 6 || FUNCTION == 9
  vec3 L = onCircle(at.x * 3.0), V = onCircle(at.y * 3.0) * vec3(1.0, 1.0, 0.8) + vec3(0.0, 0.6 * cos(at.y * 3.0), 0.0);
  vec2 along = vec2(L.x, V.x), across = sqrt(max(vec2(0.0), 1.0 - along * along));
#if FUNCTION == 6
  float value = shiftedCosine(vec4(across.x * across.y, along.x * along.y, along * across.yx), lobeShifts(at.x).y);
#else
  float value = marschnerStrand(vec3(0.4), along, across, dot(L, V), 12.0).g;
#endif
#elif FUNCTION == 13
  float value = clumpPull(mix(1.0 / layers, 1.0, at.x), at.y, sheetOf(at.y, 0.0));
#elif FUNCTION == 18
  float value = clumpingWetness(at.x, 3.0 * at.y, at.y - 0.5);
#elif FUNCTION == 21
  float value = upright(at.x, sheetOf(at.x, 0.0));
#elif FUNCTION == 52
  float value = wetTop(mix(0.5, 1.0, at.x), at.y, 0.5 * at.x, sheetOf(at.y, 0.0));
#elif FUNCTION == 22
  float value = rimTaper(at.x, sheetOf(at.x, 0.0), 1.5 * at.y);
#elif FUNCTION == 23
  float value = decodeSrgb(vec3(at.x)).x;
#elif FUNCTION == 14
  float value = alongStrand(at.x, vec2(at.y, 0.0));
#elif FUNCTION == 15
  float value = wetAlbedo(vec3(at.x), at.y).x;
#elif FUNCTION == 47
  float value = wetCoatAlbedo(vec3(at.x), at.y).x;
#elif FUNCTION == 48
  float value = passedOn(1.3 * at.x, vec3(0.8 * at.y)).x;
#elif FUNCTION == 16
  vec2 mirrored = waterGloss(onCircle(at.x * 3.0), clumpNormal(vec2(at.y, 0.0), 0.4), onCircle(0.7), onCircle(-0.4), 0.9, 0.4, at.x, 0.3 + 0.7 * at.y);
  float value = 0.25 * (mirrored.x + mirrored.y);
#elif FUNCTION == 17
  float value = wetLean(vec2(0.0, at.x), at.y, sheetOf(at.y, 0.0)).y;
#elif FUNCTION == 24
  float value = clumpAt(mask, at).x;
#elif FUNCTION == 25
  float value = chartOf(maskAt(mask, at)) / (FUR_CHART_STEP * float(FUR_CHART_NUMBERS));
#elif FUNCTION == 49
  float value = borderOf(storedAt(mask, at)) / float(FUR_MOST_BORDERS);
#elif FUNCTION == 50
  float value = clumpAt(mask, at).y;
#elif FUNCTION == 26
  vec4 texel = maskAt(mask, at);
  texel.x -= FUR_CHART_STEP * 5.5;  // of chart 5
  float value = float(isBeside(texel));
#elif FUNCTION == 27
  float value = filteredWater(mask, at).x;
#elif FUNCTION == 43
  float value = filteredWater(mask, at).y;
#elif FUNCTION == 28
  float value = sheetOf(clumpAt(mask, at).a, 0.0);
#elif FUNCTION == 33
  float value = sheetOf(at.x, at.y);
#elif FUNCTION == 34
  float value = shortnessOf(at.x);
#elif FUNCTION == 35
  float value = onLock(vec2(at.x - 0.1, 0.2 - 0.4 * at.y), vec2(1.0, 0.2), 0.6).x;
#elif FUNCTION == 36
  float value = clamp(onLock(vec2(at.x - 0.1, 0.2 - 0.4 * at.y), vec2(1.0, 0.2), 0.6).y, -1.0, 1.0);
#elif FUNCTION == 38
  float value = lockPull(at.x, 1.5 * at.y, sheetOf(at.y, 0.0));
#elif FUNCTION == 53
  float value = tuftPull(at.x, tuftsOf(at.y, mix(0.5, 4.0, at.x) * clumpRadius), vec2(3.3, 5.7));
#elif FUNCTION == 54
  float value = lockSheet(at.x, at.y);
#elif FUNCTION == 55
  float value = locksInClump(at.x);
#elif FUNCTION == 39
  float value = 0.4 * clumpShade(at.x * 2.0 - 1.0, 2.0 * at.y - at.x, 1.0 - at.x * at.y, at.y, 1.2 * at.y, sheetOf(at.x, 0.0));
#elif FUNCTION == 51
  float value = mirroredSky(at.x) - 2.0;
#elif FUNCTION == 40
  float value = beadSize(at.x, at.y);
#elif FUNCTION == 46
  float value = litLower(1.2 * at.x);
#elif FUNCTION == 45
  float value = beadRun(at.x, at.y);
#elif FUNCTION == 41
  float value = nearSheet(at.x, at.y);
#elif FUNCTION == 44
  float value = clumpsClosed(0.2 * at.x, 0.3, at.y);
#elif FUNCTION == 42
  float value = liesBy(chanceOfClump(0.005 * at), at.y, at.x);
#elif FUNCTION == 29
  float value = kajiyaPower(at.x * 2.0 - 1.0, at.y * 60.0);
#elif FUNCTION == 30
  float value = clumpDisplacement(mix(1.0 / layers, 1.0, at.x), at.y);
#elif FUNCTION == 31
  float value = printedLight(vec3(0.5, 0.3, 0.2), vec3(1.0), skyLight(0.5), at.x, 0.9 * at.y + 0.1, at.y, at.x).x;
#elif FUNCTION == 32
  vec3 L = onCircle(0.7), V = onCircle(-0.4), T = onCircle(at.x * 3.0);
  float value = dryLight(lightOfShell(L, V, at.y, 0.8, 0.5), vec3(0.5, 0.3, 0.2), vec2(dot(T, L), dot(T, V)), vec2(L.z, V.z), at.y, at.x).x;
#elif FUNCTION == 12
  float value = standsUpTo(at.x, mix(0.5, 1.0, at.y));
#elif FUNCTION == 11
  // Over a square of two units, at the height of the eye.
  float value = furShadowAt(lightSpace(vec3(at.x * 2.0 - 1.0, eye.y, at.y * 2.0 - 1.0)));
#else
  float value = rimLight(at.x * 2.0 - 1.0, at.y * 2.0 - 1.0, 0.7);
#endif
  float fixedPoint = floor(clamp((value + 2.0) / 4.0, 0.0, 0.9999999) * 16777216.0);
  vec3 bytes = floor(mod(fixedPoint / vec3(65536.0, 256.0, 1.0), 256.0));
  fragColor = vec4(bytes / 255.0, 1.0);
}
