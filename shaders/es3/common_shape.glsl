// What brushes add to the shape of the strands: curls, frizz and locks, by moving strands aside with their height.
// Neighbours move nearly alike, so the strand that is seen at a point roots about as far aside as one rooted there moves.
uniform sampler2D shapeMap;     // r: curl  g: frizz  b: locks

const float kCurl = 0.1, kCurlTurns = 1.5;  // radius in fur lengths; turns from root to tip
const float kLocksPull = 0.7;               // at the tips

bool sameLock(vec2 centre, vec2 other) { return dot(centre - other, centre - other) < 0.02; }

struct ShapedStrand {
  vec2 root;   // tile
  float open;  // 0: between two locks; more than 1 where many strands are drawn together
  float pull;  // as Strand has it (shell_march.glsl)
};
// The strand at height h over the tile point `at`. `amount`: of the map; `lying`: tiles that it covers when it lies.
ShapedStrand shapedStrandAt(vec2 at, float h, vec3 amount, float lying) {
  ShapedStrand strand = ShapedStrand(at, 1.0, 0.0);
  // Frizz: kinks that only a few strands share, in texels.
  vec2 few = at * tileTexels;
  vec2 kinks = 3.0 * sin(0.17 * few.yx + vec2(17.0, 14.0) * h) + 1.5 * sin(0.41 * few.yx + few * 0.13 + vec2(29.0, 37.0) * h);
  strand.root -= kinks * (amount.y * min(3.0 * h, 1.0) / tileTexels);
  // Curls: circles, of which those beside each other begin elsewhere.
  vec2 wave = strand.root / (2.0 * kCurl * lying);
  float turn = 1.7 * (sin(wave.x + 0.6 * wave.y) + sin(wave.y - 0.4 * wave.x + sin(0.31 * wave.x))) + 6.2832 * kCurlTurns * h;
  strand.root -= kCurl * lying * amount.x * smoothstep(0.0, 0.6, h) * vec2(cos(turn), sin(turn));
  if (amount.z > 0.0) {
    float perTile = tileTexels * (FUR_LOCKS_ACROSS / FUR_LOCKS_TEXELS);
    vec2 seen = strand.root * perTile, centre = lockCentre(seen);
    strand.pull = kLocksPull * amount.z * h * (2.0 - h);
    // As with water: a root in another lock is no strand of this one.
    vec2 root = centre + (seen - centre) / (1.0 - strand.pull);
    strand.open = float(sameLock(lockCentre(root), centre)) * (1.0 + 2.0 * strand.pull);
    strand.root = root / perTile;
  }
  return strand;
}
