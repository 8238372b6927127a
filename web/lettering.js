// Letters that fur can be wetted with: wet strands hang out of them by their own length, so they are thin and stand apart.

// As the ghost of the page (page.css).
const fontOf = (size) => ({ font: `${Math.round(size)}px sans-serif`, letterSpacing: `${0.12 * size}px` });

/** The text as a picture of one byte a pixel, turned by `angle`. */
export function pictureOfText(text, size, angle) {
  const context = Object.assign(new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true }), fontOf(size));
  const long = Math.min(Math.ceil(context.measureText(text).width) + 2, 4096), high = Math.ceil(1.3 * size);
  const [cos, sin] = [Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle))];
  const width = Math.round(long * cos + high * sin), height = Math.round(long * sin + high * cos);
  Object.assign(context.canvas, { width, height });
  Object.assign(context, fontOf(size), { textAlign: 'center', textBaseline: 'middle' });
  context.translate(width / 2, height / 2);
  context.rotate(angle);
  context.fillText(text, 0, 0, long);
  const { data } = context.getImageData(0, 0, width, height);
  return { coverage: Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + 3]), width, height };
}
