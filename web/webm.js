// A film as a WebM file: encoded frames with their times, in a subset of Matroska (RFC 9559) that every player knows.

const bytesOf = (...parts) => {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
};

function bigEndian(value, count) {
  const out = new Uint8Array(count);
  for (let i = count - 1; i >= 0; i--) {
    out[i] = value % 256;
    value = Math.floor(value / 256);
  }
  return out;
}

const hexadecimal = (text) => Uint8Array.from(text.match(/../g), (pair) => parseInt(pair, 16));
const text = (words) => new TextEncoder().encode(words);
const number = (value) => bigEndian(value, value < 256 ? 1 : 8);
const float = (value) => new Uint8Array(new Float64Array([value]).buffer).reverse();  // of a little-endian machine, as all are

/** Identifier, size in eight bytes, content. */
const element = (id, ...parts) => {
  const content = bytesOf(...parts);
  return bytesOf(hexadecimal(id), [1], bigEndian(content.length, 7), content);
};

/**
 * @param {{ data: Uint8Array, isKey: boolean }[]} frames that many a second, the first one a key frame
 * @param {{ codec: 'V_VP8' | 'V_VP9', width: number, height: number, rate: number }} film
 */
export function webm(frames, { codec, width, height, rate }) {
  const timeOf = (index) => Math.round(1000 * index / rate);
  const clusters = [];  // each begins with a key frame
  frames.forEach(({ data, isKey }, i) => {
    if (isKey) clusters.push({ time: timeOf(i), blocks: [] });
    const cluster = clusters.at(-1);
    cluster.blocks.push(element('a3', [0x81], bigEndian(timeOf(i) - cluster.time, 2), [isKey ? 0x80 : 0], data));
  });
  const header = element('1a45dfa3', element('4286', number(1)), element('42f7', number(1)), element('42f2', number(4)), element('42f3', number(8)),
    element('4282', text('webm')), element('4287', number(4)), element('4285', number(2)));
  const info = element('1549a966', element('2ad7b1', number(1e6)), element('4489', float(1000 * frames.length / rate)),
    element('4d80', text('wet-fur')), element('5741', text('wet-fur')));
  const track = element('ae', element('d7', number(1)), element('73c5', number(1)), element('9c', number(0)), element('83', number(1)),
    element('86', text(codec)), element('23e383', number(Math.round(1e9 / rate))), element('e0', element('b0', number(width)), element('ba', number(height))));
  return bytesOf(header, element('18538067', info, element('1654ae6b', track),
    ...clusters.map(({ time, blocks }) => element('1f43b675', element('e7', number(time)), ...blocks))));
}
