// Shared by the tests: the core, the program, and random setups.
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { WASI } from 'node:wasi';
import { Core } from '../core.mjs';

const project = fileURLToPath(new URL('../../..', import.meta.url));
const file = process.env.LONGDRIVE_CORE ?? join(project, 'target/wasm32-wasip1/debug/longdrive_core.wasm');
export const program = process.env.LONGDRIVE_PROGRAM ?? join(project, 'target/debug/longdrive');
for (const needed of [file, program]) {
  if (!existsSync(needed)) throw new Error(`${needed} is missing; web/core/README.md says how to build it`);
}
const module = new WebAssembly.Module(readFileSync(file));

/** An empty folder: the core must not find the files that the program would find on disk. */
const empty = mkdtempSync(join(tmpdir(), 'longdrive-core-'));

/** A new instance of the core. */
export const start = progress => Core.start(module, new WASI({ version: 'preview1' }), progress);

/** The program's exit status, standard output and standard error. */
export function run(words, input = '') {
  const { status, stdout, stderr } = spawnSync(program, words, { input, cwd: empty, encoding: 'utf8', env: { COLUMNS: '80', NO_COLOR: '1' }, maxBuffer: 1 << 28 });
  return { status, stdout, stderr };
}

/** Degrees in radians. */
export const DEG = Math.PI / 180;

/** Parameters of random setups, with ranges of good drives. */
const RANGES = {
  'swing.speed': [35, 55, 'm/s'],
  'swing.attack_angle': [-5, 5, 'deg'],
  'swing.path': [-5, 5, 'deg'],
  'swing.face_angle': [-4, 4, 'deg'],
  'club.loft': [7, 15, 'deg'],
  'strike.toe': [-15, 15, 'mm'],
  'strike.high': [-10, 12, 'mm'],
  'wind.right': [-6, 6, 'm/s'],
  'wind.downrange': [-8, 8, 'm/s'],
  'air.density': [1, 1.3, 'kg/m^3'],
  'ground.slope': [-3, 3, 'deg'],
  'ground.height': [-5, 5, 'm'],
};

const PRESETS = ['tour-average', 'modern-driver', 'lpga-average', 'amateur-average', 'winfield-tan', 'mae494'];

/** Laws that a setup may name without a table. */
const LAWS = execFileSync(program, ['parameters', '--json'], { encoding: 'utf8' });

/** Random settings of a club's strike on a preset. Some have another law or another integration. */
export function randomStrike(next) {
  const set = {};
  for (const [name, [low, high, unit]] of Object.entries(RANGES)) {
    if (next() < 0.5) set[name] = `${(low + next() * (high - low)).toFixed(4)} ${unit}`;
  }
  const laws = JSON.parse(LAWS).laws;
  if (next() < 0.3) set['aero.law'] = laws[Math.floor(next() * laws.length)];
  if (next() < 0.3) Object.assign(set, { 'flight.method': 'dp8', 'flight.step': `${(0.1 + next()).toFixed(3)} s` });
  return { preset: PRESETS[Math.floor(next() * PRESETS.length)], set };
}

/** The setup; with probability 0.1, a random launch replaces its strike. */
export function maybeLaunched({ preset, set }, next) {
  if (next() >= 0.1) return { preset, set };
  const between = (low, high) => low + next() * (high - low);
  const kept = Object.entries(set).filter(([name]) => !/^(swing|club|strike|impact)\.|^golfer$/.test(name));
  const launch = {
    'launch.ball_speed': `${between(120, 180)} mph`,
    'launch.launch_angle': `${between(8, 16)} deg`,
    'launch.spin': `${between(1500, 4000)} rpm`,
    'launch.spin_axis': `${between(-20, 20)} deg`,
  };
  return { preset, set: { ...Object.fromEntries(kept), ...launch } };
}

/** A random setup: a preset and settings. Some have another law, a given launch, or another integration. */
export const randomSetup = next => maybeLaunched(randomStrike(next), next);

/** The arguments that give a setup on the command line. */
export const wordsOf = ({ preset, set }) => [preset, ...Object.entries(set).flatMap(([name, value]) => ['--set', `${name}=${value}`])];
