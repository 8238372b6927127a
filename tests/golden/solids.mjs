// Solids with hard edges, as programs for construction write them: few triangles, flat normals, a vertex for each face.
const subtract = (a, b) => a.map((x, i) => x - b[i]);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const unit = (a) => a.map((x) => x / Math.hypot(...a));
const around = (count, radius) => Array.from({ length: count }, (_, i) => {
  const angle = (2 * Math.PI * i) / count;
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
});

// A convex polygon in x and y, counter-clockwise, as thick as 2 z. `round`: its side has the normals of a circle's.
function prism(outline, z, round = false) {
  const faces = outline.map((a, i) => {
    const b = outline[(i + 1) % outline.length];
    const corners = [[...a, -z], [...b, -z], [...b, z], [...a, z]];
    return { corners, normals: round ? corners.map(([x, y]) => unit([x, y, 0])) : undefined };
  });
  const cap = (height) => outline.map((p) => [...p, height]);
  return [...faces, { corners: cap(z) }, { corners: cap(-z).reverse() }];
}
const box = (x, y, z) => prism([[-x, -y], [x, -y], [x, y], [-x, y]], z);

const solids = {
  cube: () => box(1, 1, 1),
  cylinder: () => prism(around(32, 0.7), 1, true),
  plate: () => box(1, 0.7, 0.025),
  sheet: () => box(1, 0.7, 0).slice(4, 5),
};

/** A solid by its name, as the text of an .obj file. */
export function solid(name) {
  const lines = [];
  let count = 0;
  for (const { corners, normals } of solids[name]()) {
    const flat = unit(cross(subtract(corners[1], corners[0]), subtract(corners[2], corners[0])));
    const first = count + 1;
    corners.forEach((corner, i) => {
      lines.push(`v ${corner.join(' ')}`, `vn ${(normals?.[i] ?? flat).join(' ')}`);
      ++count;
    });
    for (let i = first + 1; i < count; ++i) lines.push(`f ${[first, i, i + 1].map((v) => `${v}//${v}`).join(' ')}`);
  }
  return `${lines.join('\n')}\n`;
}
