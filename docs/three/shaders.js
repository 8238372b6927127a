// What a shell does with the layers of wet-fur/core. three.js adds the usual uniforms and attributes.
export const vertexShader = /* glsl */ `
in vec4 surfaceTangent;
uniform float layers, furLength;
out vec2 vUv;
out vec3 vNormal, vAlong, vAcross, vToEye;
flat out float vHeight;

void main() {
  vHeight = (float(gl_InstanceID) + 1.0) / layers;
  vec4 place = modelMatrix * vec4(position + normal * (furLength * vHeight), 1.0);
  place.y -= 0.3 * furLength * vHeight * vHeight;  // its weight
  vUv = uv;
  vNormal = mat3(modelMatrix) * normal;
  vAlong = mat3(modelMatrix) * surfaceTangent.xyz;
  vAcross = cross(vNormal, vAlong) * surfaceTangent.w;
  vToEye = cameraPosition - place.xyz;
  gl_Position = projectionMatrix * viewMatrix * place;
}`;

export const fragmentShader = /* glsl */ `
precision highp sampler2DArray;
uniform sampler2DArray fur;   // tangent x and y, variance, coverage
uniform sampler2D mask;       // clump centre u and v, radius, wetness
uniform vec2 repeat;
uniform vec3 toLight;
uniform float layers, clumpShape;
in vec2 vUv;
in vec3 vNormal, vAlong, vAcross, vToEye;
flat in float vHeight;
out vec4 fragColor;

// Silva et al. 2010, Eq. 1, with the distance in radii of the clump.
float clumpProfile(float h) { return (1.0 - clumpShape) * h + clumpShape * (1.0 + log(max(h, 1.0 / layers)) / log(layers)); }

void main() {
  vec2 root = vUv;
  float along = vHeight, wetness = 0.0;
  vec4 clump = texture(mask, fract(vUv));
  if (clump.a > 0.0) {
    wetness = clump.a;
    float pull = clumpProfile(vHeight) * min(wetness, 0.85);
    vec2 from = (fract(vUv) - clump.xy) / (1.0 - pull);  // the exact inverse
    if (dot(from, from) > clump.z * clump.z) discard;    // Algorithm 2: a strand of another clump
    root = clump.xy + from;
    along *= 1.0 + 0.5 * dot(from, from) / (clump.z * clump.z);  // outer strands end lower
  }
  if (along > 1.0) discard;
  // A neighbour's derivatives may be those of another clump: the level of detail goes by the unmoved coordinates.
  vec2 dx = dFdx(vUv) * repeat, dy = dFdy(vUv) * repeat;
  vec4 strand = textureGrad(fur, vec3(root * repeat, floor(along * layers - 0.5)), dx, dy);
  float alpha = smoothstep(0.25, 0.6, strand.a);
  if (alpha < 0.04) discard;

  vec2 tilt = 2.0 * strand.xy - 1.0;
  vec3 T = normalize(tilt.x * normalize(vAlong) + tilt.y * normalize(vAcross) + sqrt(max(0.05, 1.0 - dot(tilt, tilt))) * normalize(vNormal));
  vec3 V = normalize(vToEye), N = normalize(vNormal);
  vec2 cosines = vec2(dot(T, toLight), dot(T, V)), sines = sqrt(1.0 - cosines * cosines);
  // Kajiya and Kay, with a narrower highlight on wet fur, and dark roots.
  float diffuse = mix(sines.x, max(dot(N, toLight), 0.0), 0.5) * clamp(dot(N, toLight) + 0.5, 0.0, 1.0);
  float glint = pow(max(0.0, sines.x * sines.y - cosines.x * cosines.y), mix(14.0, 70.0, wetness)) * clamp(2.0 * dot(N, toLight), 0.0, 1.0);
  vec3 color = mix(vec3(0.10, 0.06, 0.035), vec3(0.62, 0.42, 0.24), vHeight) * (0.7 + 0.6 * strand.z) * (1.0 - 0.5 * wetness);
  color = color * (1.3 * diffuse + 0.35) + (0.12 + 0.3 * wetness) * glint;
  color *= 0.35 + 0.65 * vHeight;
  fragColor = vec4(pow(color, vec3(1.0 / 2.2)), alpha);
}`;
