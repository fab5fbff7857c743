// The compiled core: from the page itself, or from the file beside it.
import { unpack } from './pack.mjs';

type Bytes = ReadableStream<Uint8Array<ArrayBuffer>>;

/** The compressed core within a page that is a single file; null for other pages. */
function inside(): Bytes | null {
  const packed = document.getElementById('core');
  return packed ? new Blob([unpack(packed.textContent ?? '')]).stream() : null;
}

async function beside(): Promise<Bytes> {
  const { ok, status, body } = await fetch('longdrive_core.bin');
  if (!ok || !body) throw new Error(`longdrive_core.bin: ${status}`);
  return body;
}

/** Compiles the core while it is read and decompressed. */
export async function load(): Promise<WebAssembly.Module> {
  if (typeof WebAssembly !== 'object') throw new Error('this browser has no WebAssembly');
  const compressed = inside() ?? (await beside());
  const bytes = compressed.pipeThrough(new DecompressionStream('gzip'));
  const headers = { 'content-type': 'application/wasm' };
  return WebAssembly.compileStreaming(new Response(bytes, { headers }));
}
