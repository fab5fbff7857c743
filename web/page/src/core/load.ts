// The compiled core: from the page itself, or from the file beside it.
import { unpack } from './pack.mjs';

/** The compressed core of a page that is one file. */
function inside(): Uint8Array<ArrayBuffer> | null {
  const packed = document.getElementById('core');
  return packed ? unpack(packed.textContent ?? '') : null;
}

async function beside(): Promise<Uint8Array<ArrayBuffer>> {
  const response = await fetch('longdrive_core.bin');
  if (!response.ok) throw new Error(`longdrive_core.bin: ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

/** Compiles the core. */
export async function load(): Promise<WebAssembly.Module> {
  if (typeof WebAssembly !== 'object') throw new Error('this browser has no WebAssembly');
  const compressed = inside() ?? (await beside());
  const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}
