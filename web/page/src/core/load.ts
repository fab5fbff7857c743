// The core, packed in the page itself or in the file beside it.
import { unpack } from './pack.mjs';

/** The compressed core, or its address. */
export type Packed = Blob | string;

export function packedCore(): Packed {
  if (typeof WebAssembly !== 'object') throw new Error('this browser has no WebAssembly');
  const inside = document.getElementById('core');
  return inside
    ? new Blob([unpack(inside.textContent ?? '')])
    : new URL('longdrive_core.bin', location.href).href;
}
