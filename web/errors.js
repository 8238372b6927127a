/**
 * What the world did wrong, with a code that programs can test and a text that names the thing.
 * Codes: webgl-unavailable wasm-blocked wasm-load out-of-memory bad-file too-large
 * unsupported-version network program-failed.
 */
export class FurError extends Error {
  constructor(code, message) {
    super(message);
    this.name = 'FurError';
    this.code = code;
  }
}

/** Anything thrown, as a FurError; `code` is for what has none of its own. */
export function asFurError(error, code) {
  if (error instanceof FurError) return error;
  return new FurError(code, error instanceof Error ? error.message : String(error));
}
