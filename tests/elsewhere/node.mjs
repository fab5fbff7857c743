// The runner that .cargo/config.toml names for wasm32-wasip1: runs a program with WASI under Node. The program may read the folder of the project, for the data of the tests.
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { WASI } from 'node:wasi';

const [program, ...words] = process.argv.slice(2);
const project = fileURLToPath(new URL('../..', import.meta.url));
const wasi = new WASI({ version: 'preview1', args: [program, ...words], env: { RUST_BACKTRACE: '1' }, preopens: { [project]: project } });
const module = await WebAssembly.compile(await readFile(program));
process.exitCode = wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject()));
