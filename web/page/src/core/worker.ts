// One instance of the core in a worker.
import { ConsoleStdout, File, OpenFile, WASI } from '@bjorn3/browser_wasi_shim';
import { Core } from '../../../core/core.mjs';
import { compile } from './compile';
import type { Packed } from './load';
import type { Command, FromWorker, Reply, ToWorker } from './messages';

const say = (message: FromWorker) => postMessage(message);

let core: Core | null = null;
/** The last lines of the core's standard error, to which a trap writes its message. */
let lastLines: string[] = [];

async function start(given: Packed | WebAssembly.Module) {
  const module = given instanceof WebAssembly.Module ? given : await compile(given);
  const keep = (line: string) => {
    lastLines = [...lastLines.slice(-4), line];
  };
  const streams = [
    new OpenFile(new File([])),
    ConsoleStdout.lineBuffered(keep),
    ConsoleStdout.lineBuffered(keep),
  ];
  const wasi = new WASI([], [], streams, { debug: false });
  core = await Core.start(module, wasi as never, (done, of) => say({ kind: 'progress', done, of }));
  say({ kind: 'started', module });
}

function run(core: Core, { words, files }: Command): Reply {
  const { head, files: written } = core.ask({ words }, files);
  if (!('answer' in head)) {
    return { exit: 2, answer: '', said: [{ kind: 'error', text: head.message }], files: {} };
  }
  return { exit: head.exit, answer: head.answer, said: head.said, files: written };
}

function work(message: Exclude<ToWorker, { kind: 'start' }>) {
  if (!core) throw new Error('the core has not started');
  const { number } = message;
  if (message.kind === 'command') {
    say({ kind: 'reply', number, reply: run(core, message.command) });
    return;
  }
  const begin = performance.now();
  const current = core;
  const numbers = message.calls.map(({ endpoint, request }) => current[endpoint](request));
  say({ kind: 'numbers', number, numbers, milliseconds: performance.now() - begin });
}

addEventListener('message', ({ data }: MessageEvent<ToWorker>) => {
  if (data.kind === 'start') {
    start(data.core).catch((error) => say({ kind: 'trap', number: 0, message: String(error) }));
    return;
  }
  lastLines = [];
  try {
    work(data);
  } catch (error) {
    say({ kind: 'trap', number: data.number, message: [String(error), ...lastLines].join('\n') });
  }
});
