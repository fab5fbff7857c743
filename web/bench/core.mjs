// Times of the core under Node, and its size: node --no-warnings web/bench/core.mjs [FILE]
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { WASI } from 'node:wasi';
import { brotliCompressSync, constants } from 'node:zlib';
import { Core } from '../core/core.mjs';

const DEG = Math.PI / 180;
const MOVES = 300;
const file = process.argv[2] ?? fileURLToPath(new URL('../../target/wasm32-wasip1/web/longdrive_core.wasm', import.meta.url));
const bytes = await readFile(file);
const params = { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24, [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length };
console.log(`size: ${(bytes.length / 1e6).toFixed(2)} MB, brotli ${(brotliCompressSync(bytes, { params }).length / 1e6).toFixed(2)} MB`);

let begun = performance.now();
const core = await Core.start(await WebAssembly.compile(bytes), new WASI({ version: 'preview1' }));
const range = (name, low, high) => ({ name, low, high });
const across = range('club.loft', 4 * DEG, 20 * DEG);
const up = range('swing.attack_angle', -5 * DEG, 5 * DEG);
const face = range('swing.face_angle', -6 * DEG, 6 * DEG);
const preset = 'tour-average';
const step = core.step({ setup: { preset }, ranges: [across, up, face, range('swing.speed', 35, 60)], tolerance: 1e-6 });
const integration = { 'flight.method': step.method, 'flight.step': step.step };
const setup = set => ({ preset, set: { ...integration, ...set } });
core.drive({ setup: setup({}), path: true });
console.log(`from the file to the first drive, with its step of ${step.step.toFixed(3)} s: ${(performance.now() - begun).toFixed(0)} ms`);

/** Prints the fastest, median and 95 % time of moves of a slider, ms. */
function time(name, call, moves = MOVES) {
  const times = [];
  for (let move = 0; move < moves; move += 1) {
    const loft = (7 + 6 * ((move * 0.618) % 1)) * DEG;
    begun = performance.now();
    call(loft);
    times.push(performance.now() - begun);
  }
  const first = times[0];
  times.sort((a, b) => a - b);
  const shown = [times[0], times[moves >> 1], times[Math.floor(0.95 * moves)], first].map(ms => ms.toFixed(2).padStart(9));
  console.log(`${name.padEnd(44)}${shown.join('')}`);
}

console.log(`${'ms'.padEnd(44)}  fastest   median     95 %    first`);
const wrt = ['club.loft', 'swing.speed', 'swing.attack_angle', 'swing.face_angle', 'swing.path', 'strike.toe', 'strike.high', 'wind.right'];
const of = ['carry', 'total'];
const at = loft => setup({ 'club.loft': loft });
time('drive with path', loft => core.drive({ setup: at(loft), path: true }));
time('and 2 x 8 derivatives of 2 outcomes', loft => core.drive({ setup: at(loft), of, wrt, path: true }));
time('drive with path in steps of 10 ms', loft => core.drive({ setup: { preset, set: { 'club.loft': loft } }, path: true }));
const map = (loft, nodes) => core.map({ setup: at(loft), of: ['carry'], across: range('swing.speed', 35, 60), up, nodes: [nodes, nodes] });
time('map of 20 x 20 values', loft => map(loft, 20), 50);
time('map of 60 x 60 values', loft => map(loft, 60), 20);
const aim = (loft, carry, lateral) => core.aim({ setup: at(loft), vary: [across, face], carry, lateral });
time('aim at a reachable point', loft => aim(loft, 180 + 500 * loft, 10));
time('aim at an unreachable point', loft => aim(loft, 400, 200 * loft));
time('step of a session', () => core.step({ setup: { preset }, ranges: [across, up], tolerance: 1e-6 }), 30);
time('loop at 200 nodes', () => core.loop({ setup: { preset: 'mae494' }, along: across, nodes: 200, step: 0.01, difference: 1e-4 }), 20);
const loftText = loft => `club.loft=${(loft / DEG).toFixed(3)}deg`;
time('ask simulate', loft => core.ask({ words: ['simulate', preset, '--set', loftText(loft), '--json'] }), 50);
time('ask optimize', () => core.ask({ words: ['optimize', preset, '--json'] }), 30);
