// The camera as text: "yaw pitch distance [targetX targetY targetZ]", angles in radians or with
// a unit ("20deg"), lengths in model units, with or without "m", separated by spaces or commas.

const number = String.raw`[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?`;
const anglePattern = new RegExp(`^(${number})(rad|deg)?$`, 'i');
const lengthPattern = new RegExp(`^(${number})m?$`, 'i');

const readAngle = (text) => {
  const match = anglePattern.exec(text);
  return match ? Number(match[1]) * (match[2]?.toLowerCase() === 'deg' ? Math.PI / 180 : 1) : NaN;
};
const readLength = (text) => Number(lengthPattern.exec(text)?.[1] ?? NaN);

/** @returns {{yaw: number, pitch: number, distance: number, target: number[]} | null} null when it cannot be read */
export function parseOrbit(text) {
  const parts = String(text).trim().split(/[\s,]+/);
  if (parts.length !== 3 && parts.length !== 6) return null;
  const [yaw, pitch] = parts.slice(0, 2).map(readAngle);
  const [distance, ...target] = parts.slice(2).map(readLength);
  const all = [yaw, pitch, distance, ...target];
  if (!all.every(Number.isFinite) || distance <= 0) return null;
  return { yaw, pitch, distance, target: target.length ? target : [0, 0, 0] };
}

/** "x y z" as [x, y, z]; null when it cannot be read. */
export function parseTarget(text) {
  const target = String(text).trim().split(/[\s,]+/).map(readLength);
  return target.length === 3 && target.every(Number.isFinite) ? target : null;
}

const defaultFov = 0.6;  // OrbitCamera::kFovY

/** Radians of "auto", or of a number of degrees, with or without "deg"; NaN when it cannot be read. */
export function parseFov(text) {
  return text === 'auto' ? defaultFov : readAngle(/[a-z]$/i.test(text) ? text : `${text}deg`);
}

/** The inverse of parseOrbit, to four decimals. */
export function orbitText({ yaw, pitch, distance, target }) {
  const short = (value) => String(Number(value.toFixed(4)));
  const parts = [yaw, pitch, distance, ...(target.some((t) => Math.abs(t) > 5e-5) ? target : [])];
  return parts.map(short).join(',');
}
