// Compiles the core, in a worker: the page is drawn at the same time.
import type { Packed } from './load';

async function bytesAt(address: string) {
  const { ok, status, body } = await fetch(address);
  if (!ok || !body) throw new Error(`${address}: ${status}`);
  return body;
}

/** Compiles the core while it is read and decompressed. */
export async function compile(packed: Packed): Promise<WebAssembly.Module> {
  const compressed = typeof packed === 'string' ? await bytesAt(packed) : packed.stream();
  const bytes = compressed.pipeThrough(new DecompressionStream('gzip'));
  const headers = { 'content-type': 'application/wasm' };
  return WebAssembly.compileStreaming(new Response(bytes, { headers }));
}
