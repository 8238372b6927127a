// Files over the network with a count of the bytes as they arrive.
import { FurError } from './errors.js';

/** As scene/Model.h: more is refused before it fills the memory. */
export const maxFileBytes = 256 * 1024 * 1024;

/** A file's own name, for messages. */
export function fileNameOf(url) {
  const path = new URL(url, 'file:///').pathname;
  return decodeURIComponent(path.slice(path.lastIndexOf('/') + 1)) || path;
}

/** Fetches, or throws a FurError that names the file and the reason. */
export async function fetchOrThrow(url, code, signal) {
  let response;
  try {
    response = await fetch(url, { signal });
  } catch (error) {
    if (signal?.aborted) throw error;
    throw new FurError(code, `${fileNameOf(url)}: could not be fetched (${error.message})`);
  }
  if (response.status === 404) throw new FurError(code, `${fileNameOf(url)}: the server has no such file (404)`);
  if (!response.ok) throw new FurError(code, `${fileNameOf(url)}: the server answered ${response.status}`);
  return response;
}

/**
 * The length that the body will have, 0 when unknown: of a compressed answer the header counts
 * compressed bytes, the stream counts unpacked ones.
 */
function bodyLength(response) {
  if (response.headers.get('content-encoding')) return 0;
  return Number(response.headers.get('content-length')) || 0;
}

/** The response with the same body, telling `onBytes(loaded, total)` of every chunk. */
export function counted(response, onBytes, type) {
  const total = bodyLength(response);
  let loaded = 0;
  const count = new TransformStream({
    transform(chunk, controller) {
      loaded += chunk.byteLength;
      onBytes?.(loaded, total);
      controller.enqueue(chunk);
    },
  });
  const headers = type ? { 'content-type': type } : {};
  return new Response(response.body.pipeThrough(count), { headers });
}

/** All bytes of a file of at most maxFileBytes. */
export async function fetchBytes(url, onBytes, signal) {
  const name = fileNameOf(url);
  const tooLarge = () => new FurError('too-large', `${name}: files of at most ${maxFileBytes >> 20} MiB are read`);
  const response = await fetchOrThrow(url, 'network', signal);
  if (bodyLength(response) > maxFileBytes) throw tooLarge();
  const chunks = [];
  let size = 0;
  try {
    for (const reader = counted(response, onBytes).body.getReader(); ;) {
      const { done, value } = await reader.read();
      if (done) break;
      size += value.byteLength;
      if (size > maxFileBytes) {
        reader.cancel().catch(() => {});
        throw tooLarge();
      }
      chunks.push(value);
    }
  } catch (error) {
    if (error instanceof FurError || signal?.aborted) throw error;
    throw new FurError('network', `${name}: broke off after ${size} bytes (${error.message})`);
  }
  const bytes = new Uint8Array(size);
  let at = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, at);
    at += chunk.byteLength;
  }
  return bytes;
}
