// Random links, setup files and CSVs: the page shows a message, or a state in which only the values
// named by the input differ. LONGDRIVE_RANDOM=all runs 10,000 links, 1000 setup files and 1000
// CSVs, and 1000 links in the browser.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { readFileSync } from 'node:fs';
import { WASI } from 'node:wasi';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';
import { Core } from '../../core/core.mjs';
import { launch, open, settle } from './browser.mjs';
import { pageModules } from './modules.mjs';
import { Chance } from './random.mjs';

const isAll = process.env.LONGDRIVE_RANDOM === 'all';
const COUNT = isAll ? { links: 10_000, files: 1000, shots: 1000, inBrowser: 1000 } : { links: 400, files: 40, shots: 60, inBrowser: 60 };
/** Number of setup files, and of CSVs, that are opened in the browser. */
const OPENED = isAll ? 100 : 4;

const at = path => fileURLToPath(new URL(path, import.meta.url));
const text = words => new TextEncoder().encode(words);

let page;
let core;
let catalog;
let browser;
before(async () => {
  page = await pageModules();
  const module = new WebAssembly.Module(gunzipSync(readFileSync(at('../../dist/site/longdrive_core.bin'))));
  core = await Core.start(module, new WASI({ version: 'preview1' }));
  catalog = new page.Catalog(answered('parameters').parameters, answered('presets').presets, answered('parameters').choices);
  browser = await launch();
});
after(() => browser.close());

/** The JSON of a command. */
const answered = (...words) => JSON.parse(ask([...words, '--json']).answer);
const ask = (words, files = {}) => core.ask({ words }, files).head;

const LINKS = [
  '1&tour-average',
  '1&tour-average&swing.speed=100mph&club.loft=10.5deg&b:club.loft=12deg&map=club.loft,swing.speed&units=metric',
  '1&amateur-average&wind.speed=10mph&wind.from=90deg&air.altitude=5000ft&goal=total&vary=club.loft,swing.attack_angle',
  '1&modern-driver&launch.ball_speed=160mph&launch.launch_angle=12deg&launch.backspin=2500rpm&active=b&b:launch.backspin=none',
  '1&mae494&aero.law=lyu&c:preset=tour-average&d:ground.slope=-2deg&b:swing.speed=',
];

/** Links with numbers too large for a coordinate in pixels. */
const EXTREME = [
  '1&tour-average&strike.high=1e308m&strike.toe=-1e308m',
  '1&tour-average&club.loft=1e308deg&swing.attack_angle=-1e308deg',
  '1&tour-average&map=strike.high,club.loft&strike.high=1e308m',
];

/** A random fragment of an address. */
function link(chance) {
  if (chance.is(0.05)) return chance.text(chance.below(200));
  const names = [...catalog.parameters.map(({ parameter }) => parameter), 'map', 'vary', 'goal', 'units', 'active', 'golfer', 'preset', 'moon'];
  const value = () => chance.pick(['10deg', '95 mph', 'none', 'metric', 'total', 'b', '1e300m', '-5', 'lyu', 'club.loft,swing.speed', '', '12 parsecs']);
  const known = Array.from({ length: 12 }, () => `${chance.pick(['', '', 'b:', 'c:', 'd:', 'e:'])}${chance.pick(names)}=${value()}`);
  const mutated = chance.mutated(chance.pick(LINKS), { separator: '&', known });
  return chance.is(0.2) ? escape(mutated) : mutated;
}

const decoded = part => {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
};

/** The parts of a link, without the prefixes of its designs. */
const namedIn = fragment => new Set(fragment.replace(/^#/, '').split('&').map(decoded).map(part => part.replace(/^[bcd]:/, '')));

test(`${COUNT.links} random links give a state of which all was named, and the core answers it`, () => {
  const chance = new Chance(56);
  let flown = 0;
  for (let k = 0; k < COUNT.links; k += 1) {
    const fragment = link(chance);
    const about = JSON.stringify(fragment);
    const { state, unknown } = page.read(fragment, catalog);
    const named = namedIn(fragment);
    assert.ok(state.designs.length >= 1 && state.designs.length <= page.MOST_DESIGNS, about);
    assert.ok(state.active >= 0 && state.active < state.designs.length, about);
    for (const { preset, set } of state.designs) {
      assert.ok(catalog.preset(preset), about);
      for (const [name, value] of Object.entries(set)) assert.ok(named.has(`${name}=${value}`), `${about} has no ${name}=${value}`);
    }
    for (const name of [...page.varyOf(state, catalog), ...page.mapOf(state, catalog)]) assert.ok(catalog.parameter(name), `${about} ${name}`);
    assert.ok(unknown.every(part => typeof part === 'string'), about);
    // the link that the page writes for the state gives the same state
    const written = page.write(state);
    assert.equal(page.write(page.read(written, catalog).state), written, about);
    const design = page.activeOf(state);
    for (const name of Object.keys(design.set)) {
      const parameter = catalog.parameter(name, page.lawOf(design, catalog));
      if (!parameter) continue;
      const { low, high, step } = page.sliderRangeOf(parameter, page.numberOf(name, { ...design, set: {} }, catalog), page.numberOf(name, design, catalog));
      assert.ok(low <= high && step > 0, `${about} ${name} ${low} ${high} ${step}`);
    }
    const { head } = core.drive({ setup: page.setupOf(design), of: [state.goal], wrt: ['club.loft', 'swing.speed'], path: true });
    assert.ok(head.status !== 'error' || head.message.length > 0, about);
    if (head.status === 'landed') flown += 1;
  }
  assert.ok(flown > COUNT.links / 4, `only ${flown} fly`);
});

const FILES = [
  'preset = "tour-average"\nclub.loft = "10.5 deg"\nswing.speed = "100 mph"\n',
  'preset = "amateur-average"\n\n[wind]\nspeed = "10 mph"\nfrom = "45 deg"\n\n[air]\naltitude = "5000 ft"\n',
  'preset = "modern-driver"\n[launch]\nball_speed = "160 mph"\nlaunch_angle = "12 deg"\nbackspin = "2500 rpm"\n# a comment\n',
  'preset = "mae494"\nstrike.toe = "5 mm"\nground.slope = "-2 deg"\ngravity = 9.8\n',
];

/** A random setup file. */
function setupFile(chance) {
  if (chance.is(0.05)) return chance.bytes(chance.below(300));
  const names = catalog.parameters.map(({ parameter }) => parameter);
  const value = () => chance.pick(['"10 deg"', '"95 mph"', '"none"', '1e300', '-5', '"lyu"', 'true', '[]', '""', '"12 parsecs"', '{}', '1979-05-27']);
  const known = Array.from({ length: 8 }, () => `${chance.pick([...names, 'golfer', 'moon', 'preset'])} = ${value()}`);
  return text(chance.mutated(chance.pick(FILES), { separator: '\n', known }));
}

/** True if two values are equal to rounding: the page writes twelve significant digits. */
const isSame = (one, other) => (typeof one === 'number' && typeof other === 'number'
  ? Math.abs(one - other) <= Math.max(1e-10, 1e-9 * Math.max(Math.abs(one), Math.abs(other))) : one === other);

/** The values of a setup by name, with its law. */
function valuesOf({ law, parameters }) {
  const own = parameters.filter(row => row.law === null || row.law === law);
  return new Map([['aero.law', law], ...own.map(({ parameter, value }) => [parameter, value])]);
}

test(`${COUNT.files} random setup files give a message, or a design with all values of the file`, () => {
  const chance = new Chance(57);
  let read = 0;
  for (let k = 0; k < COUNT.files; k += 1) {
    const content = setupFile(chance);
    const about = JSON.stringify(new TextDecoder().decode(content));
    const { exit, answer, said } = ask(['parameters', 'setup.toml', '--json'], { 'setup.toml': content });
    assert.ok([0, 1, 2].includes(exit), about);
    if (exit !== 0) {
      assert.ok(said.at(-1).text.length > 10, about);
      continue;
    }
    const values = JSON.parse(answer);
    const design = page.designOf(values, catalog, 'us');
    const opened = valuesOf(answered('parameters', ...page.setupWords(design)));
    for (const [name, value] of valuesOf(values)) assert.ok(isSame(value, opened.get(name)), `${about}: ${name} is ${value}, and ${opened.get(name)} in ${JSON.stringify(design)}`);
    // the program reads the downloaded design
    const again = ask(['parameters', 'setup.toml', '--json'], { 'setup.toml': text(page.writeSetup(design)) });
    if (!Object.values(design.set).includes(page.NONE)) assert.equal(again.exit, 0, `${about} ${again.said.at(-1)?.text}`);
    read += 1;
  }
  assert.ok(read > COUNT.files / 8, `only ${read} are setup files`);
});

const SHOTS = readFileSync(at('../../../examples/shots.csv'), 'utf8').replace(/^#.*\n/gm, '').trim();

/** A random file of shots. */
function shotsFile(chance) {
  if (chance.is(0.05)) return chance.bytes(chance.below(400));
  const rows = SHOTS.split('\n');
  const short = [rows[0], ...Array.from({ length: 1 + chance.below(3) }, () => chance.pick(rows.slice(1)))].join('\n');
  const known = ['Club Speed (mph),Ball Speed (mph)', '1,2,3', 'Club Speed,Club Speed', ';;;', '"', 'a;b'];
  const mutated = chance.mutated(chance.is(0.2) ? short.replace(/,/g, chance.pick([';', '\t', '|'])) : short, { separator: chance.is(0.5) ? '\n' : ',', known });
  if (chance.is(0.1)) return Uint8Array.from([0xff, 0xfe, ...[...mutated].flatMap(c => [c.charCodeAt(0) & 255, c.charCodeAt(0) >> 8])]);
  return text(mutated);
}

test(`${COUNT.shots} random CSVs give a message, or as many rows as they have shots`, () => {
  const chance = new Chance(58);
  let flown = 0;
  for (let k = 0; k < COUNT.shots; k += 1) {
    const content = shotsFile(chance);
    const about = JSON.stringify(new TextDecoder().decode(content));
    const { head, files } = core.ask({ words: ['fly', 'shots.csv', 'tour-average', '--json', '-o', 'flown.csv'] }, { 'shots.csv': content });
    assert.ok([0, 1, 2].includes(head.exit), about);
    if (!files['flown.csv']) {
      assert.ok(head.said.at(-1).text.length > 10, about);
      continue;
    }
    assert.deepEqual(Object.keys(files), ['flown.csv']);
    const { rows } = JSON.parse(head.answer);
    assert.ok(rows >= 0 && rows <= about.length, about);
    flown += 1;
  }
  assert.ok(flown > COUNT.shots / 8, `only ${flown} are flown`);
});

test(`${COUNT.inBrowser} random links and ${2 * OPENED} files leave the page whole and silent`, async () => {
  const chance = new Chance(59);
  const { page: tab, context, said, requests } = await open(browser);
  const { errors } = await trapsOf(tab);
  await settle(tab);
  const loaded = requests.filter(url => !url.startsWith('blob:')).length;
  const links = [...EXTREME, ...Array.from({ length: COUNT.inBrowser }, () => link(chance))];
  for (const [k, fragment] of links.entries()) {
    await tab.evaluate(text => { location.hash = text; }, fragment);
    if (k < EXTREME.length || k % 100 === 0) await settle(tab);
  }
  await tab.evaluate(() => { location.hash = '1&tour-average&swing.speed=95mph'; });
  await settle(tab);
  assert.equal(await tab.locator('#slide-club-loft').inputValue(), '8.8');
  assert.equal(await tab.locator('.changed').count(), 1);
  for (let k = 0; k < OPENED; k += 1) {
    const before = await tab.evaluate(() => location.hash);
    await give(tab, '.shots', { name: 'random.csv', mimeType: 'text/csv', buffer: Buffer.from(shotsFile(chance)) });
    assert.equal(await tab.evaluate(() => location.hash), before);
    await give(tab, '.files', { name: 'random.toml', mimeType: 'text/plain', buffer: Buffer.from(setupFile(chance)) });
  }
  await tab.evaluate(() => { location.hash = '1&tour-average'; });
  await settle(tab);
  assert.match(await tab.locator('.answer .goal td').first().textContent(), /^286\.0 yd$/);
  assert.equal(await tab.locator('.notices [role=alert]').count(), 0, await errors());
  assert.equal(requests.filter(url => !url.startsWith('blob:')).length, loaded);
  assert.deepEqual(said, []);
  await context.close();
});

/** Collects the messages that the page shows about internal errors from now on. */
async function trapsOf(tab) {
  await tab.evaluate(() => {
    window.internal = [];
    new MutationObserver(() => {
      const text = document.querySelector('.notices [role=alert]')?.textContent;
      if (text && !window.internal.includes(text)) window.internal.push(text);
    }).observe(document.body, { childList: true, subtree: true, characterData: true });
  });
  return { errors: () => tab.evaluate(() => window.internal.join('\n')) };
}

/** Gives a file to a part of the page, and waits until it is read. */
async function give(tab, part, file) {
  await tab.evaluate(() => {
    window.worked = new Promise(done => {
      let began = false;
      new MutationObserver((_, observer) => {
        const isWorking = document.querySelector('.working') !== null;
        began ||= isWorking;
        if (!began || isWorking) return;
        observer.disconnect();
        done();
      }).observe(document.body, { childList: true, subtree: true });
    });
  });
  await tab.locator(`${part} input[type=file]`).setInputFiles(file);
  await tab.evaluate(() => window.worked);
  await settle(tab);
}
