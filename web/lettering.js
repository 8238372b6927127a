/** The text as a picture of one byte a pixel, turned by `angle`. */
export function pictureOfText(text, size, angle) {
  const context = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  const font = `bold ${Math.round(size)}px sans-serif`;
  context.font = font;
  const long = Math.min(Math.ceil(context.measureText(text).width) + 2, 4096), high = Math.ceil(1.3 * size);
  const [cos, sin] = [Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle))];
  const width = Math.round(long * cos + high * sin), height = Math.round(long * sin + high * cos);
  Object.assign(context.canvas, { width, height });
  Object.assign(context, { font, textAlign: 'center', textBaseline: 'middle' });
  context.translate(width / 2, height / 2);
  context.rotate(angle);
  context.fillText(text, 0, 0, long);
  const { data } = context.getImageData(0, 0, width, height);
  return { coverage: Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + 3]), width, height };
}
