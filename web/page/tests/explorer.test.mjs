// The state of the page, with workers whose answers the tests give.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './modules.mjs';

let page;

before(async () => {
  // the page's clock
  globalThis.window = globalThis;
  page = await pageModules();
});

/** A worker that gives no answers of its own; `answers` has a function for each command. */
function lane() {
  const answers = [];
  const pending = new Promise(() => {});
  return {
    answers,
    isIdle: true,
    call: () => pending,
    calls: () => pending,
    command: (topic, words) => new Promise(answer => { answers.push({ topic, words, answer }); }),
  };
}

function explorer(numbers = lane(), commands = lane()) {
  const loft = { parameter: 'club.loft', unit: 'rad', shown_in: 'deg', law: null, range: { low: 0, high: 1 } };
  const others = ['swing.attack_angle', 'swing.speed'].map(parameter => ({ ...loft, parameter }));
  const units = { ball_speed: 'm/s', launch_angle: 'deg', backspin: 'rad/s', launch_direction: 'deg', sidespin: 'rad/s' };
  const launch = Object.entries(units).map(([name, unit]) => ({ ...loft, parameter: `launch.${name}`, shown_in: unit }));
  const presets = [{ name: 'tour-average', setup: { 'club.loft': 0.2, 'swing.attack_angle': 0, 'swing.speed': 0.5 }, sources: {} }];
  const catalog = new page.Catalog([loft, ...others, ...launch], presets, []);
  return new page.Explorer(catalog, numbers, commands, page.START);
}

const settled = () => new Promise(resolve => { setTimeout(resolve, 0); });

test('a long command that waits is shown once the running one has ended', async () => {
  const commands = lane();
  const state = explorer(lane(), commands);
  const ended = [state.run('the first', []), state.run('the second', [])];
  assert.equal(state.working.value, 'the first');
  commands.answers[0].answer({ exit: 0 });
  await ended[0];
  assert.equal(state.working.value, 'the second');
  commands.answers[1].answer({ exit: 0 });
  await ended[1];
  assert.equal(state.working.value, null);
});

/** A worker that has the core, and that answers when the test says so. */
class Thread {
  static all = [];
  work = [];
  isEnded = false;
  constructor() {
    Thread.all.push(this);
  }
  addEventListener(kind, receive) {
    if (kind === 'message') this.receive = receive;
  }
  postMessage(message) {
    if (message.kind === 'start') queueMicrotask(() => this.say({ kind: 'started', module: {} }));
    else this.work.push(message);
  }
  say(data) {
    this.receive({ data });
  }
  answer() {
    const { number, command } = this.work.at(-1);
    this.say({ kind: 'reply', number, reply: { exit: 0, answer: command.words[0] } });
  }
  terminate() {
    this.isEnded = true;
  }
}

async function background() {
  globalThis.Worker = Thread;
  Thread.all = [];
  const commands = new page.Lane();
  await commands.start({});
  return commands;
}

test('the end of a long command that waits leaves the running search alone', async () => {
  const commands = await background();
  const state = explorer(lane(), commands);
  const best = commands.command('best', ['optimize']);
  const report = state.run('the report', ['report']);
  state.end();
  assert.equal(await report, null);
  const [thread] = Thread.all;
  assert.equal(thread.isEnded, false);
  thread.answer();
  assert.equal((await best).answer, 'optimize');
});

test('a long command that runs is ended with its thread, and no command replaces another', async () => {
  const commands = await background();
  const state = explorer(lane(), commands);
  const ended = ['report', 'simulate', 'optimize'].map(word => state.run(word, [word]));
  state.end();
  assert.equal(await ended[0], null);
  assert.deepEqual(Thread.all.map(({ isEnded }) => isEnded), [true, false]);
  for (const word of ['simulate', 'optimize']) {
    await settled();
    assert.equal(state.working.value, word);
    Thread.all[1].answer();
  }
  assert.deepEqual((await Promise.all(ended)).map(reply => reply?.answer), [undefined, 'simulate', 'optimize']);
});

test('the best point of a map that is out of date is not shown', async () => {
  for (const [name, isShown] of [['swing.speed', false], ['club.loft', true]]) {
    const commands = lane();
    const map = { head: { status: 'done', columns: 60, rows: 60 }, block: new Float64Array(3600) };
    const numbers = { ...lane(), call: async topic => (topic === 'map' ? map : null), calls: async () => null };
    const state = explorer(numbers, commands);
    state.refresh();
    while (!commands.answers.some(({ topic }) => topic === 'map best')) {
      await settled();
    }
    const { answer } = commands.answers.find(({ topic }) => topic === 'map best');
    state.set(name, '0.3 rad', false);
    const found = { optimum: {}, flight: {}, multipliers: {}, warnings: [] };
    answer({ exit: 0, answer: JSON.stringify(found) });
    await settled();
    assert.equal(state.mapBest.current !== null, isShown, name);
  }
});

/** The answer about a drive whose launch has these values. */
function landed(launch) {
  const outcomes = Object.keys(launch);
  const head = { status: 'landed', outcomes, of: [], wrt: [], missing: [] };
  return [{ head, block: Float64Array.from(Object.values(launch)) }];
}

test('a measured launch waits for the drive, although units and goal change meanwhile', async () => {
  const waiting = [];
  const calls = topic => new Promise(answer => { if (topic === 'drive') waiting.push(answer); });
  const state = explorer({ ...lane(), calls });
  state.refresh();
  const started = state.startWithLaunch();
  state.change({ ...state.state.value, units: 'metric' });
  state.change({ ...state.state.value, goal: 'total' });
  // the first request is answered, the second one is replaced by the third
  waiting[0](landed({ ball_speed: 70, backspin: 250 }));
  waiting[1](null);
  await settled();
  waiting[2](landed({ ball_speed: 71, backspin: 260 }));
  await started;
  const { set } = state.design.value;
  assert.deepEqual([set['launch.ball_speed'], set['launch.backspin']], ['71 m/s', '260 rad/s']);
});

test('different numbers have different texts, equal numbers to rounding the same', () => {
  assert.deepEqual(page.distinct([10.46, 10.54], 1), ['10.46', '10.54']);
  assert.deepEqual(page.distinct([8.8, 8.8 + 1e-15, 12], 1), ['8.8', '8.8', '12.0']);
  assert.deepEqual(page.distinct([0.000018, NaN, 0.000027], 1), ['0.00002', '–', '0.00003']);
});

test('the best point of a map is searched again until it is found', async () => {
  const commands = lane();
  const map = { head: { status: 'done', columns: 60, rows: 60 }, block: new Float64Array(3600) };
  const numbers = { ...lane(), call: async topic => (topic === 'map' ? map : null), calls: async () => null };
  const state = explorer(numbers, commands);
  const searches = () => commands.answers.filter(({ topic }) => topic === 'map best');
  for (const reply of [null, { exit: 2, answer: '', said: [] }, { exit: 0, answer: '{"optimum":{},"flight":{},"multipliers":{},"warnings":[]}' }]) {
    const before = searches().length;
    state.refresh();
    while (searches().length === before) await settled();
    searches().at(-1).answer(reply);
    await settled();
  }
  assert.notEqual(state.mapBest.current, null);
});

test('ticks of a small range have different texts', () => {
  for (const [low, high] of [[-0.02, 0.03], [0, 1e-7], [10, 11], [-20, 20]]) {
    const texts = page.ticks(low, high, 4).map(page.tickText);
    assert.ok(texts.length > 2, texts);
    assert.equal(new Set(texts).size, texts.length, texts);
  }
});
