// Compares the numbers of the core's functions with the program's and with each other, and checks
// their messages.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { DEG, randomSetup, randomStrike, run, start, wordsOf } from './common.mjs';
import { random } from './random.mjs';

const core = await start();
const YARD = 0.9144;
const text = words => new TextEncoder().encode(words);
const range = (name, low, high) => ({ name, low, high });

/** Asserts that two numbers differ by at most `most`. */
function close(ours, theirs, most, about) {
  assert.ok(Math.abs(ours - theirs) <= most, `${about}: ${ours} and ${theirs}`);
}

/** The answer of `drive` as an object. */
function drive(request) {
  const { head, block } = core.drive(request);
  const outcomes = Object.fromEntries(head.outcomes?.map((name, k) => [name, block[k]]) ?? []);
  let at = head.outcomes?.length ?? 0;
  const take = count => block.subarray(at, at += count);
  const n = head.wrt?.length ?? 0;
  const derivatives = (n > 0 ? head.of : []).map(of => ({ of, first: take(n), second: take(n) }));
  const path = Array.from({ length: head.path ?? 0 }, () => take(4));
  const run = Array.from({ length: head.run ?? 0 }, () => take(3));
  const stated = Object.fromEntries(head.stated?.map(name => [name, take(1)[0]]) ?? []);
  assert.equal(at, block.length);
  return { head, outcomes, derivatives, path, run, stated };
}

test('same outcomes and derivatives of a drive as the program', () => {
  const next = random(1);
  const wrt = ['club.loft', 'swing.speed', 'swing.attack_angle', 'strike.toe', 'wind.right'];
  for (let k = 0; k < 30; k += 1) {
    const setup = randomStrike(next);
    const { head, outcomes, derivatives } = drive({ setup, of: ['carry', 'total', 'spin'], wrt });
    const simulated = JSON.parse(run(['simulate', ...wordsOf(setup), '--json']).stdout);
    assert.equal(head.status, simulated.status);
    const { said } = core.ask({ words: ['simulate', ...wordsOf(setup)] }).head;
    assert.deepEqual(head.warnings, said.map(({ text: words }) => words));
    for (const [name, value] of Object.entries({ ...simulated.launch, ...simulated.flight })) {
      if (name in outcomes && value !== null) close(outcomes[name], value, 1e-12 * Math.abs(value), name);
    }
    const words = ['gradient', ...wordsOf(setup), '--hessian', '--of', 'carry,total,spin', '--wrt', wrt.join(','), '--json'];
    const told = JSON.parse(run(words).stdout).outcomes;
    // SI sizes of the units of prices: degree, mph, degree, inch, mph
    const units = [DEG, 0.44704, DEG, 0.0254, 0.44704];
    derivatives.forEach(({ of, first, second }, k) => {
      const size = of === 'spin' ? 1 : YARD;
      wrt.forEach((name, i) => {
        close(first[i] * units[i] / size, told[k].gradient[name] * units[i] / size, 1e-6, `${of} per ${name}`);
        const part = units[i] ** 2 / size;
        close(second[i] * part, told[k].hessian.values[i][i] * part, 1e-6, `${of} by ${name}`);
      });
    });
  }
});

test('same derivatives without outcomes as with outcomes', () => {
  const next = random(11);
  const wrt = ['club.loft', 'swing.speed', 'air.density', 'swing.attack_angle', 'swing.path', 'strike.toe', 'strike.high', 'wind.right'];
  for (let k = 0; k < 20; k += 1) {
    const request = { setup: randomSetup(next), of: ['carry', 'total', 'spin'], wrt };
    const { head, derivatives } = drive(request);
    const alone = drive({ ...request, outcomes: false });
    assert.deepEqual(alone.derivatives, derivatives);
    assert.deepEqual(alone.head.missing, head.missing);
    assert.deepEqual([alone.head.status, alone.head.outcomes], ['done', []]);
  }
});

test('a setup file is the same setup as its preset and its settings', () => {
  const file = drive({ setup: { toml: 'preset = "mae494"\n[club]\nloft = "11 deg"\n' }, path: true });
  const preset = drive({ setup: { preset: 'mae494', set: { 'club.loft': '11 deg' } }, path: true });
  assert.deepEqual([file.outcomes, file.path], [preset.outcomes, preset.path]);
});

test('the values of all texts of a setup, in SI', () => {
  const set = { 'air.temperature': '20 °C', 'swing.speed': '160 KMH', 'club.bulge_radius': 'inf', 'air.humidity': '50 %',
    'air.altitude': 'none', golfer: 'left', 'club.loft': 0.2 };
  const { stated } = drive({ setup: { set }, path: true });
  close(stated['swing.speed'], 160 / 3.6, 1e-12, 'speed');
  assert.deepEqual({ ...stated, 'swing.speed': 0 }, { 'air.temperature': 293.15, 'swing.speed': 0, 'club.bulge_radius': Infinity, 'air.humidity': 0.5 });
});

test('a refused setup has the values of the texts that can be read', () => {
  const set = { 'club.loft': '10 parsecs', 'air.altitude': '1 km', 'swing.speed': '160 KMH', 'aero.law': 'robinson',
    'aero.cd1': '0.02 s/rev', 'aero.cd_re': '1', 'strike.toe': '2', golfer: 'left' };
  const { head, block } = core.drive({ setup: { set } });
  assert.equal(head.status, 'error');
  const stated = Object.fromEntries(head.stated.map((name, k) => [name, block[k]]));
  close(stated['swing.speed'], 160 / 3.6, 1e-12, 'speed');
  close(stated['aero.cd1'], 0.02 / (2 * Math.PI), 1e-15, 'coefficient of the stated law');
  assert.deepEqual(Object.keys(stated).sort(), ['aero.cd1', 'air.altitude', 'swing.speed']);
  assert.equal(stated['air.altitude'], 1000);
});

test('exact ends of a path', () => {
  const { outcomes, path, run: bounces } = drive({ setup: { set: { 'wind.right': '4 m/s', 'ground.height': '-2 m' } }, path: true });
  const [time, height, right, downrange] = path.at(-1);
  assert.deepEqual([...path[0]], [0, 0, 0, 0]);
  for (const [ours, name] of [[time, 'flight_time'], [right, 'lateral'], [downrange, 'carry']]) close(ours, outcomes[name], 1e-9, name);
  close(height, -2, 1e-9, 'ground');
  close(Math.max(...path.map(point => point[1])), outcomes.apex_height, 0.01, 'apex');
  assert.deepEqual([...bounces[0]], [height, right, downrange]);
  close(bounces.at(-1)[2], outcomes.total, 1e-9, 'total');
});

test('a ball that does not land has a status and the outcomes of its launch', () => {
  const { head, outcomes } = drive({ setup: { set: { 'club.loft': '-20 deg', 'swing.attack_angle': 0 } }, of: ['carry', 'ball_speed'], wrt: ['club.loft'] });
  assert.equal(head.status, 'no-flight');
  assert.match(head.message, /\w/);
  assert.ok(outcomes.ball_speed > 50 && Number.isNaN(outcomes.carry));
  assert.deepEqual(head.missing.map(({ of }) => of), ['carry']);
});

test('a parameter without derivatives has a reason, and does not prevent the others', () => {
  const setup = { set: { 'air.altitude': '1000 ft' } };
  const wrt = ['club.loft', 'air.density', 'swing.speed'];
  const all = drive({ setup, of: ['carry', 'total'], wrt });
  const some = drive({ setup, of: ['carry', 'total'], wrt: [wrt[0], wrt[2]] });
  assert.deepEqual(all.head.missing.map(({ of, wrt: by }) => [of, by]), [[null, 'air.density']]);
  assert.match(all.head.missing[0].message, /^air\.density cannot be varied, and has no derivatives: air\.altitude is given/);
  all.derivatives.forEach(({ first, second }, k) => {
    const { first: firsts, second: seconds } = some.derivatives[k];
    assert.deepEqual([...first], [firsts[0], NaN, firsts[1]]);
    assert.deepEqual([...second], [seconds[0], NaN, seconds[1]]);
  });
  const none = drive({ setup, of: ['carry'], wrt: ['air.density'] });
  assert.deepEqual([...none.derivatives[0].first], [NaN]);
  assert.equal(drive({ setup, of: ['carry'], wrt: ['air.densty'] }).head.status, 'error');
});

test('same values of a map as of drives', () => {
  const setup = { preset: 'tour-average', set: { 'wind.right': '3 m/s' } };
  const [across, up] = [range('club.loft', '6 deg', '16 deg'), range('swing.attack_angle', -0.05, 0.05)];
  const [columns, rows] = [5, 3];
  const { head, block } = core.map({ setup, of: ['carry', 'lateral'], across, up, nodes: [columns, rows] });
  assert.equal(block.length, 2 * columns * rows);
  for (let node = 0; node < columns * rows; node += 1) {
    const [i, j] = [node % columns, Math.floor(node / columns)];
    const set = { ...setup.set, 'club.loft': (6 + 10 * i / (columns - 1)) * DEG, 'swing.attack_angle': -0.05 + 0.1 * j / (rows - 1) };
    const { outcomes } = drive({ setup: { ...setup, set } });
    head.of.forEach((of, k) => close(block[k * columns * rows + node], outcomes[of], 1e-10, of));
  }
});

test('1000 reachable landing points are reached within 1 mm in at most 8 drives', () => {
  const next = random(2);
  const ranges = [range('club.loft', 4 * DEG, 20 * DEG), range('swing.face_angle', -6 * DEG, 6 * DEG)];
  const presets = ['tour-average', 'modern-driver', 'lpga-average', 'amateur-average', 'winfield-tan'];
  const integration = { 'flight.method': 'dp8', 'flight.step': '0.4 s' };
  for (let met = 0; met < 1000;) {
    const preset = presets[met % presets.length];
    const set = { ...integration, 'wind.right': 8 * next() - 4, 'swing.attack_angle': (8 * next() - 4) * DEG };
    const there = Object.fromEntries(ranges.map(({ name, low, high }) => [name, low + next() * (high - low)]));
    const { outcomes: { carry, lateral } } = drive({ setup: { preset, set: { ...set, ...there } } });
    if (Number.isNaN(carry)) continue;
    met += 1;
    const { head, block } = core.aim({ setup: { preset, set }, vary: ranges, carry, lateral });
    const about = JSON.stringify([preset, set, there, head, ...block]);
    assert.equal(head.status, 'reached', about);
    assert.ok(head.drives <= 8, about);
    // compute the drive again, with the found values
    const found = { ...set, [ranges[0].name]: block[0], [ranges[1].name]: block[1] };
    const { outcomes } = drive({ setup: { preset, set: found } });
    assert.ok(Math.hypot(outcomes.carry - carry, outcomes.lateral - lateral) <= 1e-3, about);
    ranges.forEach(({ low, high }, axis) => assert.ok(low <= block[axis] && block[axis] <= high, about));
  }
});

test('an unreachable landing point is told, with the nearest one', () => {
  const next = random(3);
  const ranges = [range('club.loft', 4 * DEG, 20 * DEG), range('swing.face_angle', -3 * DEG, 3 * DEG)];
  const set = { 'flight.method': 'dp8', 'flight.step': '0.4 s' };
  let unreachable = 0;
  for (let k = 0; k < 50; k += 1) {
    const [carry, lateral] = [340 * next() + 20, 200 * next() - 100];
    const { head, block } = core.aim({ setup: { set }, vary: ranges, carry, lateral });
    if (head.status === 'reached') continue;
    unreachable += 1;
    assert.equal(head.status, 'nearest');
    assert.match(head.message, /^no ball lands there with club\.loft .* and swing\.face_angle .*: the nearest landing is [\d.]+ yd away$/);
    // no drive of a grid lands nearer
    const { block: grid } = core.map({ setup: { set }, of: ['carry', 'lateral'], across: ranges[0], up: ranges[1], nodes: [17, 17] });
    const nearest = Math.min(...Array.from({ length: 289 }, (_, node) => Math.hypot(grid[node] - carry, grid[289 + node] - lateral)));
    assert.ok(block[4] <= nearest + 1e-3, `${carry} ${lateral}: ${block[4]} and ${nearest}`);
  }
  assert.ok(unreachable > 10, `only ${unreachable} are unreachable`);
});

test('the loop ends at its first step below the ground, the exact drive on it', () => {
  const nodes = 101;
  const step = 0.01;
  const request = { setup: { preset: 'mae494' }, along: range('club.loft', '8 deg', '12 deg'), nodes, step, difference: 1e-5 };
  const column = (block, k) => block.subarray(k * nodes, (k + 1) * nodes);
  const { head, block } = core.loop(request);
  const [loft, carry, interpolated, difference, exact, slope] = [0, 1, 2, 3, 4, 5].map(k => column(block, k));
  assert.equal(head.parameter, 'club.loft');
  const fine = core.loop({ ...request, step: step / 100 }).block;
  for (let k = 0; k < nodes; k += 1) {
    assert.ok(carry[k] >= interpolated[k] && carry[k] - interpolated[k] < 60 * step, `${k}`);
    // Euler's error is proportional to the step
    close(column(fine, 2)[k], exact[k], 0.02, `carry at ${loft[k]}`);
    const { outcomes, derivatives } = drive({ setup: { preset: 'mae494', set: { 'club.loft': loft[k] } }, of: ['carry'], wrt: ['club.loft'] });
    close(exact[k], outcomes.carry, 1e-10, 'exact');
    close(slope[k], derivatives[0].first[0], 1e-8, 'slope');
  }
  // the loop's carry jumps where its number of steps changes; a difference quotient over a jump is off
  // by orders of magnitude
  const worst = Math.max(...difference.map((found, k) => Math.abs(found - slope[k])));
  assert.ok(worst > 1e3, `${worst}`);
  const { head: windy } = core.loop({ ...request, setup: { set: { 'wind.right': '2 m/s' } } });
  assert.equal(windy.status, 'undefined');
  assert.match(windy.message, /^the while-loop is not defined for this drive: /);
});

test('the step of a session keeps to its tolerance, as that of the program', () => {
  const ranges = [range('club.loft', 4 * DEG, 20 * DEG), range('swing.attack_angle', -5 * DEG, 5 * DEG)];
  const preset = 'tour-average';
  const found = core.step({ setup: { preset }, ranges, tolerance: 1e-6 });
  const { setup } = JSON.parse(run(['optimize', preset, '--json']).stdout);
  assert.deepEqual([found.status, found.method, found.step], ['done', setup['flight.method'], setup['flight.step']]);
  const next = random(5);
  for (let k = 0; k < 20; k += 1) {
    const at = Object.fromEntries(ranges.map(({ name, low, high }) => [name, low + next() * (high - low)]));
    const [long, short] = [{ 'flight.method': found.method, 'flight.step': found.step }, { 'flight.step': 0.001 }]
      .map(integration => drive({ setup: { preset, set: { ...at, ...integration } } }).outcomes.carry);
    close(long, short, 1e-6, JSON.stringify(at));
  }
  assert.equal(core.step({ setup: { preset }, tolerance: 0 }).status, 'error');
});

/** The answer of `iterations` as objects. */
function iterations(request) {
  const { head, block } = core.iterations(request);
  const n = head.parameters.length;
  let at = 0;
  const take = count => block.subarray(at, at += count);
  const list = Array.from({ length: head.iterations }, () => {
    const [search, iteration, value, residual, accepted, predicted, actual, reflected] = take(8);
    const [x, bounds, gradient, hessian, low, high, trial] = [n, n, n, n * n, n, n, n].map(take);
    return { search, iteration, value, residual, accepted, predicted, actual, reflected, x, bounds, gradient, hessian, low, high, trial };
  });
  assert.equal(at, block.length);
  return { head, list };
}

test('same models and gains of the iterations as of drives, and the same end as the program', () => {
  const vary = [range('club.loft', 4 * DEG, 20 * DEG), range('swing.attack_angle', -10 * DEG, 10 * DEG)];
  const wrt = vary.map(({ name }) => name);
  const set = { 'flight.method': 'dp8', 'flight.step': '0.4 s', 'wind.right': '2 m/s' };
  const preset = 'tour-average';
  const { head, list } = iterations({ setup: { preset, set }, of: 'carry', vary });
  assert.match(head.message, /^KKT residual/);
  list.forEach((step, k) => {
    const at = x => ({ preset, set: { ...set, ...Object.fromEntries(wrt.map((name, i) => [name, x[i]])) } });
    const { outcomes } = drive({ setup: at(step.x) });
    const words = ['gradient', ...wordsOf(at(Array.from(step.x, x => `${x}rad`))), '--hessian', '--of', 'carry', '--wrt', wrt.join(','), '--json'];
    const [{ gradient, hessian }] = JSON.parse(run(words).stdout).outcomes;
    close(step.value, outcomes.carry, 1e-9, 'carry');
    step.gradient.forEach((slope, i) => close(slope, gradient[wrt[i]], 1e-6, `slope ${i}`));
    step.hessian.forEach((second, i) => close(second, hessian.values.flat()[i], 1e-4, `second derivative ${i}`));
    step.x.forEach((x, i) => {
      const { low, high } = vary[i];
      assert.ok(low <= step.low[i] && step.low[i] <= x && x <= step.high[i] && step.high[i] <= high);
      assert.equal(step.bounds[i], x === high ? 1 : x === low ? -1 : 0);
    });
    if (k === list.length - 1) return;
    const d = step.trial.map((to, i) => to - step.x[i]);
    const model = d.reduce((sum, by, i) => sum + by * (step.gradient[i] + 0.5 * d.reduce((row, other, j) => row + other * step.hessian[2 * i + j], 0)), 0);
    close(step.predicted, model, 1e-9, 'predicted');
    close(step.actual, drive({ setup: at(step.trial) }).outcomes.carry - step.value, 1e-9, 'actual');
    if (step.accepted) assert.deepEqual(list[k + 1].x, step.trial);
  });
  const last = list.at(-1);
  assert.ok(last.residual <= 1e-10 && Number.isNaN(last.accepted));
  const words = ['optimize', ...wordsOf({ preset, set }), '--vary', 'club.loft=4deg..20deg', '--vary', 'swing.attack_angle=-10deg..10deg', '--json'];
  const { optimum, value } = JSON.parse(run(words).stdout);
  wrt.forEach((name, i) => close(last.x[i], optimum[name], 1e-8, name));
  close(last.value, value, 1e-9, 'best carry');
});

test('a better drive of the sample begins a second search, which ends as that of the program', () => {
  const vary = [range('club.loft', 0, 0.45), range('swing.shaft_lean', -0.1, 0.1)];
  const set = { 'aero.law': 'lyu', 'wind.downrange': '8 m/s', 'flight.method': 'dp8', 'flight.step': '0.4 s', 'club.loft': '0.77 deg', 'swing.shaft_lean': '-2.1 deg' };
  const setup = { preset: 'lpga-average', set };
  const { list } = iterations({ setup, of: 'total', vary });
  const second = list.findIndex(({ search }) => search === 1);
  const [end, start, last] = [list[second - 1], list[second], list.at(-1)];
  assert.ok(second > 1 && Number.isNaN(end.accepted) && start.iteration === 0);
  assert.ok(start.value > end.value && last.value > start.value);
  const words = ['optimize', ...wordsOf(setup), '--maximize', 'total', '--vary', 'club.loft=0rad..0.45rad', '--vary', 'swing.shaft_lean=-0.1rad..0.1rad', '--json'];
  const found = JSON.parse(run(words).stdout);
  assert.equal(found.sample.improved, true);
  close(last.value, found.value, 1e-9, 'best total');
});

test('the iterations of a search without a parameter have the message of the program', () => {
  const loft = range('club.loft', 4 * DEG, 20 * DEG);
  const nothing = core.iterations({ setup: {}, of: 'carry', vary: [] }).head;
  assert.deepEqual([nothing.status, nothing.message], ['error', 'nothing to vary: name at least one parameter with a range wider than a single value, as in vary club.loft=4deg..20deg']);
  const twice = core.iterations({ setup: {}, of: 'carry', vary: [loft, loft] }).head;
  assert.equal(twice.status, 'error');
  assert.match(twice.message, /club\.loft/);
});

test('files are read from memory and written into it', () => {
  const shots = 'Club Speed (mph),Ball Speed (mph),Launch Angle (deg),Spin Rate (rpm),Carry (yd)\n105,155,12,2600,255\n95,140,14,3000,225\n';
  const utf16 = Uint8Array.from([0xff, 0xfe, ...[...shots].flatMap(c => [c.charCodeAt(0), 0])]);
  const flown = [text(shots), utf16].map(content => core.ask({ words: ['fly', 'shots.csv', '-o', 'flown.csv'] }, { 'shots.csv': content }));
  for (const { head, files } of flown) {
    assert.equal(head.exit, 0, JSON.stringify(head));
    assert.deepEqual(Object.keys(files), ['flown.csv']);
    assert.equal(new TextDecoder().decode(files['flown.csv']).trim().split('\n').length, 3);
  }
  assert.deepEqual(flown[0].files, flown[1].files);
  // rows that the program writes to standard output are the answer
  assert.equal(core.ask({ words: ['fly', 'shots.csv'] }, { 'shots.csv': text(shots) }).head.answer, new TextDecoder().decode(flown[0].files['flown.csv']));
  const swept = ['sweep', '--over', 'club.loft=8deg..12deg:3', '--of', 'carry'];
  assert.equal(core.ask({ words: swept }).head.answer, run(swept).stdout);
  const made = core.ask({ words: ['optimize', 'mine.toml', '-o', 'best.toml', '--json'] }, { 'mine.toml': text('preset = "mae494"') });
  assert.equal(made.head.exit, 0);
  const again = core.ask({ words: ['simulate', 'best.toml', '--json'] }, made.files).head;
  close(JSON.parse(again.answer).flight.carry, JSON.parse(made.head.answer).value, 1e-9, 'carry');
  const page = core.ask({ words: ['report', '-o', 'page'] });
  assert.equal(page.head.exit, 0);
  assert.match(new TextDecoder().decode(page.files['page/index.html']), /^<!DOCTYPE html>/);
  assert.ok(Object.keys(page.files).length > 10 && Object.keys(page.files).every(name => name.startsWith('page/')));
});

test('threads, the network, parts and the disk are refused with a message', () => {
  const csv = { 'shots.csv': text('Ball Speed (mph),Launch Angle (deg),Spin Rate (rpm)\n150,12,2600\n') };
  const over = ['sweep', '--over', 'club.loft=8deg..12deg:3'];
  const refused = [
    [['fly', 'shots.csv', '--threads', '4'], /^threads 4: only one thread is available here; leave the option out/],
    [[...over, '--threads', '2'], /^threads 2: only one thread is available here; leave the option out/],
    [['fly', '--listen'], /^listen .*: there is no network here; give a file of shots instead/],
    [[...over, '--part', '1/2', '-o', 'parts'], /built without the feature parquet/],
    [[...over, '-o', 'rows.csv'], /there is no disk here; write the rows to standard output/],
    [['plot', 'trajectory', '-o', 'a.png'], /built without the feature png/],
    [['optimize', '--checkpoint', 'kept.json', '--starts', '2'], /kept\.json/],
    [['completions', 'bash'], /unrecognized subcommand 'completions'/],
  ];
  for (const [words, message] of refused) {
    const { exit, said } = core.ask({ words }, csv).head;
    assert.equal(exit, 2, words.join(' '));
    assert.match(said.at(-1).text, message);
  }
});

test('exact words of the page in messages', () => {
  const { said } = core.ask({ words: ['optimize', '--maximize', 'carry', '--minimize', 'spin'] }).head;
  assert.match(said[0].text, /^minimize: a search has one goal; leave one of maximize carry and minimize spin out/);
  const { head } = core.drive({ setup: { set: { 'club.lofft': 0.2 } } });
  assert.deepEqual(head.parameters, ['club.lofft', 'club.loft']);
  assert.match(head.message, /^unknown parameter 'club\.lofft'; did you mean 'club\.loft'\? "parameters" lists them all$/);
  const far = core.drive({ setup: { set: { 'swing.speed': '3 deg', 'club.loft': '10 deg' } } }).head;
  assert.deepEqual(far.parameters, ['swing.speed']);
});

test('progress of a long command is told while it runs', async () => {
  const told = [];
  const watched = await start((done, of) => told.push([done, of]));
  watched.ask({ words: ['sensitivity', '--json'] });
  const [done, of] = told.at(-1);
  assert.ok(told.length > 2 && done === of, JSON.stringify(told.at(-1)));
});

test('an outcome that is given twice gets a message', () => {
  const of = Array(3000).fill('carry');
  const loft = range('club.loft', 0.1, 0.2);
  for (const answer of [core.drive({ of }), core.map({ of, across: loft, up: range('swing.speed', 40, 50), nodes: [500, 500] })]) {
    assert.deepEqual([answer.head.status, answer.head.message], ['error', 'the request: carry is given twice in of; name it once']);
  }
});

test('malformed input gets a message and never a trap', async () => {
  const next = random(4);
  const endpoints = ['ask', 'drive', 'map', 'aim', 'loop', 'step', 'iterations'];
  const loft = range('club.loft', 0.1, 0.2);
  const good = {
    ask: { words: ['simulate', 'tour-average', '--set', 'club.loft=10deg'] },
    drive: { setup: { preset: 'tour-average', set: { 'club.loft': 0.2 } }, of: ['carry'], wrt: ['club.loft'], path: true },
    map: { setup: {}, of: ['carry'], across: loft, up: range('swing.speed', 40, 50), nodes: [2, 2] },
    aim: { setup: {}, vary: [loft, range('swing.face_angle', -0.1, 0.1)], carry: 200, lateral: 1 },
    loop: { setup: {}, along: loft, nodes: 3, step: 0.01, difference: 1e-3 },
    step: { setup: {}, of: ['carry'], ranges: [loft], tolerance: 1e-3 },
    iterations: { setup: {}, of: 'carry', vary: [loft] },
  };
  const values = [null, -1, 0, 1e308, -1e308, 1e-320, '', 'deg', '10 deg', 'none', [], {}, [1, 2], true, '\u0000', 'inf', '-inf', 'nan', '..'];
  const pick = from => from[Math.floor(next() * from.length)];
  /** A copy of a request in which one value, at a random place, is replaced or removed. */
  const changed = value => {
    if (value === null || typeof value !== 'object' || next() < 0.3) return pick(values);
    const copy = Array.isArray(value) ? [...value] : { ...value };
    const keys = Object.keys(copy);
    if (keys.length === 0) return pick(values);
    const key = pick(keys);
    if (next() < 0.1) delete copy[key];
    else copy[key] = changed(copy[key]);
    return copy;
  };
  const isAnswered = head => assert.ok(typeof head.status === 'string' && (head.status !== 'error' || 'exit' in head || head.message.length > 0));
  for (let k = 0; k < 2000; k += 1) {
    const endpoint = pick(endpoints);
    const answer = core[endpoint](changed(good[endpoint]));
    isAnswered(answer.head ?? answer);
  }
  // bytes that are no message
  const { instance, call } = await raw();
  for (let k = 0; k < 500; k += 1) {
    const bytes = Uint8Array.from({ length: Math.floor(40 * next()) }, () => Math.floor(256 * next()));
    isAnswered(call(bytes));
  }
  // heads that name no function, or more than one
  for (const head of [{}, { nonsense: {} }, { step: good.step, drive: good.drive }, 'step', []]) {
    const text = new TextEncoder().encode(JSON.stringify(head));
    assert.equal(call(text).status, 'error');
  }
  assert.ok(instance.exports.memory.buffer.byteLength < 1 << 28);
});

/** An instance without its JavaScript side. */
async function raw() {
  let instance;
  const Instance = WebAssembly.instantiate;
  WebAssembly.instantiate = async (...given) => (instance = await Instance(...given));
  await start();
  WebAssembly.instantiate = Instance;
  const { memory, input, output } = instance.exports;
  const call = bytes => {
    const address = input(bytes.length);
    new Uint8Array(memory.buffer, address, bytes.length).set(bytes);
    instance.exports.answer();
    const at = output();
    const length = new DataView(memory.buffer, at, 8).getUint32(0, true);
    return JSON.parse(new TextDecoder().decode(new Uint8Array(memory.buffer, at + 8, length)));
  };
  return { instance, call };
}
