// Runs a program compiled for WebAssembly with WASI under Node, with the folder of the project to read.
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { WASI } from 'node:wasi';

const [program, ...words] = process.argv.slice(2);
const project = fileURLToPath(new URL('../..', import.meta.url));
const wasi = new WASI({ version: 'preview1', args: [program, ...words], env: { RUST_BACKTRACE: '1' }, preopens: { [project]: project } });
const module = await WebAssembly.compile(await readFile(program));
process.exitCode = wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject()));
