// The page in Chromium, as a file and from a server.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import axe from 'axe-core';
import { answer, file, launch, open, serve, settle } from './browser.mjs';

const shots = fileURLToPath(new URL('../../../examples/shots.csv', import.meta.url));
let browser;
let server;
let shared;
before(async () => {
  browser = await launch();
  server = await serve();
});
after(async () => {
  await shared?.context.close();
  await browser.close();
  server.end();
});

/** Runs steps in a page of its own that must stay silent. */
async function visit(address, options, steps, script) {
  const opened = await open(browser, address, options, script);
  try {
    await settle(opened.page);
    await steps(opened);
    assert.deepEqual(opened.said, [], 'the console is silent');
  } finally {
    await opened.context.close();
  }
}

/** Runs steps in a page that several tests share, since to load the core takes most of a test. */
async function stay(steps) {
  shared ??= await open(browser, file, {}, trapWhenTold);
  await shared.page.setViewportSize({ width: 1280, height: 1400 });
  await shared.page.evaluate(() => { location.hash = '1&tour-average'; });
  await settle(shared.page);
  await steps(shared);
  assert.deepEqual(shared.said, [], 'the console is silent');
}

const slider = (page, name) => page.locator(`#slide-${name.replace('.', '-')}`);
const field = (page, name) => page.locator('.slider', { has: slider(page, name) }).locator('.number');
const fragment = page => page.evaluate(() => location.hash);

async function type(page, name, text) {
  await field(page, name).fill(text);
  await field(page, name).press('Enter');
}

for (const where of ['a file', 'a server']) {
  test(`no message and no request after loading from ${where}`, async () => {
    await visit(where === 'a file' ? file : server.address, {}, async ({ page, requests }) => {
      const loaded = requests.filter(url => !url.startsWith('blob:')).length;
      assert.equal(loaded, where === 'a file' ? 1 : 4, requests.join(' '));
      await slider(page, 'club.loft').press('ArrowRight');
      await page.locator('.map select').first().selectOption('swing.speed');
      await settle(page);
      assert.equal(requests.filter(url => !url.startsWith('blob:')).length, loaded);
    });
  });
}

test('same carry of the first drive and of the best one as the README', async () => {
  await stay(async ({ page }) => {
    assert.equal(await answer(page, 'carry', 1), 286.0);
    assert.equal(await answer(page, 'total', 1), 308.8);
    await page.getByRole('button', { name: 'about attack angle' }).click();
    await page.getByLabel('the best drive may change the attack angle').check();
    await settle(page);
    // the README's best has an attack angle of at most 5 degrees, a slider goes to 10
    assert.ok(await answer(page, 'carry', 2) > 300.4);
  });
});

test('the keyboard moves a slider, goes to the best drive, undoes and redoes', async () => {
  await stay(async ({ page }) => {
    const start = await fragment(page);
    await slider(page, 'club.loft').focus();
    await page.keyboard.press('ArrowRight');
    await settle(page);
    assert.match(await fragment(page), /club\.loft=8\.9deg/);
    await page.keyboard.press('b');
    await settle(page);
    assert.equal(await answer(page, 'carry', 3), 0);
    const best = await fragment(page);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal(await answer(page, 'carry', 1), 286.0);
    assert.equal(await fragment(page), start);
    await page.keyboard.press('Control+Shift+Z');
    await page.keyboard.press('Control+y');
    await settle(page);
    assert.equal(await fragment(page), best);
  });
});

test('the pointer drags the landing point, and its sliders do the same by keyboard', async () => {
  await stay(async ({ page }) => {
    const handle = await page.locator('.handle .reach').boundingBox();
    const [x, y] = [handle.x + handle.width / 2, handle.y + handle.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 30, y + 8, { steps: 4 });
    await page.mouse.up();
    await settle(page);
    const dragged = await page.locator('.top figcaption').textContent();
    assert.match(dragged, /right/);
    assert.match(await fragment(page), /swing\.face_angle=/);
    assert.ok(await answer(page, 'carry', 1) < 275);
    await page.locator('.aim summary').click();
    await page.locator('.aim').getByLabel('lateral').focus();
    for (let k = 0; k < 3; k += 1) await page.keyboard.press('ArrowLeft');
    await settle(page);
    assert.notEqual(await page.locator('.top figcaption').textContent(), dragged);
  });
});

test('a link gives the state that wrote it', async () => {
  await stay(async ({ page }) => {
    await type(page, 'club.loft', '10.5');
    await type(page, 'swing.speed', '44 m/s');
    await page.getByLabel('units').selectOption('metric');
    await page.locator('.map select').first().selectOption('swing.speed');
    await page.getByRole('button', { name: /keep this design/ }).click();
    await type(page, 'club.loft', '12');
    await settle(page);
    const link = await fragment(page);
    assert.ok(link.length <= 400, link);
    const seen = await page.locator('.answer').textContent();
    await visit(file + link, {}, async ({ page: other }) => {
      assert.equal(await other.locator('.answer').textContent(), seen);
      assert.equal(await field(other, 'swing.speed').inputValue(), '44');
      await slider(other, 'club.loft').press('ArrowRight');
      await slider(other, 'club.loft').press('ArrowLeft');
      assert.equal(await fragment(other), link);
    });
  });
});

test('unknown parts of a link of a newer version are listed, the others applied', async () => {
  await visit(`${file}#2&tour-average&club.loft=10deg&moon=full`, {}, async ({ page }) => {
    const notice = await page.locator('.notices').textContent();
    assert.match(notice, /version 2/);
    assert.match(notice, /moon=full/);
    assert.equal(await field(page, 'club.loft').inputValue(), '10');
  });
});

test('bad input gets a message beside its field; the last drive stays, greyed', async () => {
  await stay(async ({ page }) => {
    await type(page, 'club.loft', '10 parsecs');
    const message = page.locator('#message-club-loft');
    await message.waitFor();
    assert.match(await message.textContent(), /unknown unit 'parsecs'/);
    assert.equal(await field(page, 'club.loft').inputValue(), '10 parsecs');
    assert.equal(await page.locator('.answer.stale').count(), 1);
    assert.equal(await answer(page, 'carry', 1), 286.0);
    await type(page, 'club.loft', '10');
    await settle(page);
    assert.equal(await page.locator('.answer.stale').count(), 0);
  });
});

test('a drive that does not fly says why', async () => {
  await stay(async ({ page }) => {
    await type(page, 'swing.attack_angle', '-30');
    await page.locator('.answer .message').first().waitFor();
    assert.match(await page.locator('.answer .message').first().textContent(), /\w+ \w+/);
  });
});

/** Lets a test ask a worker for a function that the core does not have. */
function trapWhenTold() {
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function sent(message, ...rest) {
    window.sent = (window.sent ?? 0) + 1;
    if (window.trapNext && message.kind === 'calls') {
      window.trapNext = false;
      return post.call(this, { ...message, calls: [{ door: 'trap', request: {} }] }, ...rest);
    }
    return post.call(this, message, ...rest);
  };
}

test('after an internal error the worker begins anew, and nothing typed is lost', async () => {
  await stay(async ({ page }) => {
    await type(page, 'club.loft', '11');
    await settle(page);
    await page.evaluate(() => { window.trapNext = true; });
    await slider(page, 'swing.speed').press('ArrowRight');
    await page.locator('.notices .message').waitFor();
    assert.match(await page.locator('.notices').textContent(), /Internal error/);
    await settle(page);
    assert.equal(await field(page, 'club.loft').inputValue(), '11');
    const before = await answer(page, 'carry', 1);
    await slider(page, 'swing.speed').press('PageUp');
    await settle(page);
    assert.ok(await answer(page, 'carry', 1) > before);
  });
});

test('a setup file goes down and up', async () => {
  await stay(async ({ page }) => {
    await type(page, 'swing.speed', '100');
    await type(page, 'air.altitude', '5000');
    await type(page, 'wind.speed', '10');
    await settle(page);
    const seen = await answer(page, 'carry', 1);
    const waiting = page.waitForEvent('download');
    await page.getByRole('button', { name: 'save the setup file' }).click();
    const path = await (await waiting).path();
    assert.match(readFileSync(path, 'utf8'), /swing\.speed = "100 mph"/);
    await page.getByLabel('preset').selectOption('modern-driver');
    await settle(page);
    await page.locator('.files input[type=file]').setInputFiles({ name: 'mine.toml', mimeType: 'text/plain', buffer: readFileSync(path) });
    await page.waitForFunction(() => /swing\.speed=100mph/.test(location.hash));
    await settle(page);
    assert.equal(await answer(page, 'carry', 1), seen);
    await page.locator('.files input[type=file]').setInputFiles({ name: 'not.toml', mimeType: 'text/plain', buffer: Buffer.from('hello') });
    await page.locator('.files .message').waitFor();
    assert.match(await page.locator('.files .message').textContent(), /not\.toml: line 1/);
  });
});

test('a setup file keeps the golfer, the point of the speed, the step and what is unset', async () => {
  const text = `preset = "modern-driver"
golfer = "left"
[swing]
speed_of = "face-centre"
path = "2 deg"
[wind]
speed = "4.4704 m/s"
from = "90 deg"
[flight]
method = "dp8"
step = "20 ms"
[ground]
restitution = "none"
`;
  await stay(async ({ page }) => {
    await page.locator('.files input[type=file]').setInputFiles({ name: 'mine.toml', mimeType: 'text/plain', buffer: Buffer.from(text) });
    await page.waitForFunction(() => /golfer=left/.test(location.hash));
    await settle(page);
    assert.equal(await page.getByLabel('golfer').inputValue(), 'left');
    assert.equal(await page.getByLabel('point of the club speed').inputValue(), 'face-centre');
    assert.equal(await page.getByLabel('method of integration').inputValue(), 'dp8');
    const waiting = page.waitForEvent('download');
    await page.getByRole('button', { name: 'save the setup file' }).click();
    const saved = readFileSync(await (await waiting).path(), 'utf8');
    for (const line of ['preset = "modern-driver"', 'golfer = "left"', 'swing.speed_of = "face-centre"',
      'flight.method = "dp8"', 'flight.step = "0.02 s"', 'wind.speed = "10 mph"', 'ground.restitution = "none"']) {
      assert.ok(saved.includes(`${line}\n`), `${line} in ${saved}`);
    }
    // the other hand lands on the other side
    const side = await page.locator('.panel').textContent();
    await page.getByLabel('golfer').selectOption('right');
    await page.getByLabel('method of integration').selectOption('');
    await settle(page);
    assert.doesNotMatch(await fragment(page), /golfer|flight/);
    assert.notEqual(await page.locator('.panel').textContent(), side);
  });
});

test('shots of a launch monitor are flown', async () => {
  await stay(async ({ page }) => {
    await type(page, 'club.loft', '12');
    await page.locator('.shots input[type=file]').setInputFiles(shots);
    await page.locator('.shots [role=status]').waitFor();
    assert.match(await page.locator('.shots [role=status]').textContent(), /12 of 12 shots of shots\.csv/);
    await page.locator('.shots input[type=file]').setInputFiles({ name: 'bad.csv', mimeType: 'text/csv', buffer: Buffer.from('a,b\n1,2\n') });
    await page.locator('.shots .message').waitFor();
    assert.match(await page.locator('.shots .message').textContent(), /bad\.csv/);
  });
});

test('designs stand beside each other, with the causes of their difference', async () => {
  await stay(async ({ page }) => {
    await page.getByRole('button', { name: /keep this design/ }).click();
    await type(page, 'club.loft', '12');
    await page.locator('.compare [role=status]').waitFor();
    await settle(page);
    // docs/json.md: the difference of a loft of 12 degrees
    assert.match(await page.locator('.compare [role=status]').textContent(), /carry −12\.6 yd.*loft −12\.6 yd/);
  });
});

test('a measured launch replaces swing and club', async () => {
  await stay(async ({ page }) => {
    await page.getByLabel('a measured launch').check();
    await settle(page);
    assert.ok(Math.abs(await answer(page, 'carry', 1) - 286.0) <= 0.3);
    assert.equal(await slider(page, 'launch.backspin').count(), 1);
    assert.equal(await slider(page, 'club.loft').count(), 0);
    // a changed club has no effect, and the best launch is still found
    await page.evaluate(() => { location.hash += '&club.loft=12deg'; });
    await settle(page);
    assert.equal(await page.locator('.answer .message').count(), 0);
    await page.evaluate(() => { location.hash = location.hash.replace('&club.loft=12deg', ''); });
    await page.getByLabel('swing and club').check();
    await settle(page);
    assert.equal(await answer(page, 'carry', 1), 286.0);
  });
});

test('all parameters are found by a search, with their meaning', async () => {
  await stay(async ({ page }) => {
    await page.locator('.search input').fill('restitution');
    await slider(page, 'impact.restitution').waitFor();
    await page.locator('.search input').fill('');
    await page.getByRole('button', { name: /aero/ }).click();
    await page.locator('#price-aero-cd0 b').waitFor();
    await page.getByRole('button', { name: 'about cd0' }).click();
    assert.match(await page.locator('.about').textContent(), /Drag coefficient/);
  });
});

for (const [width, height] of [[390, 844], [768, 1024], [1280, 800]]) {
  for (const colorScheme of width === 390 ? ['light', 'dark'] : ['light']) {
    test(`${width} pixels, ${colorScheme}: nothing beside the screen, and no serious finding of axe`, async () => {
      await visit(file, { width, height, colorScheme }, async ({ page, context }) => {
        const { scrollWidth, clientWidth } = await page.evaluate(() => document.documentElement);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth), `${scrollWidth} ${clientWidth}`);
        assert.ok(await page.evaluate(() => document.querySelector('.answer').getBoundingClientRect().bottom <= innerHeight));
        await context.newPage().then(other => other.close());
        await page.evaluate(axe.source);
        const { violations } = await page.evaluate(() => axe.run({ resultTypes: ['violations'] }));
        const grave = violations.filter(({ impact }) => ['serious', 'critical'].includes(impact));
        assert.deepEqual(grave.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 120)}`), []);
      });
    });
  }
}

test('at 200 % zoom and in print nothing is cut', async () => {
  // 1280 pixels at 200 % are 640 of the page
  await visit(file, { width: 640, height: 400 }, async ({ page }) => {
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.emulateMedia({ media: 'print' });
    await page.setViewportSize({ width: 688, height: 1016 });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    const hidden = await page.evaluate(() => ['.answer', '.side', '.top', '.map', '.panel']
      .filter(name => document.querySelector(name).getBoundingClientRect().height === 0));
    assert.deepEqual(hidden, []);
    await page.pdf({ format: 'A4', printBackground: true });
  });
});

test('a phone shows one view at a time, and the answer stays beside the sliders', async () => {
  await visit(file, { width: 390, height: 844 }, async ({ page }) => {
    const visible = async () => page.evaluate(() => ['side', 'top', 'map', 'panel']
      .filter(name => document.querySelector(`.${name}`).checkVisibility()));
    assert.deepEqual(await visible(), ['side']);
    await page.getByRole('button', { name: 'map', exact: true }).click();
    assert.deepEqual(await visible(), ['map']);
    const [answerBox, sliderBox] = await Promise.all([page.locator('.answer').boundingBox(), slider(page, 'club.loft').boundingBox()]);
    assert.ok(answerBox.y + answerBox.height < sliderBox.y);
  });
});

test('the loop of time steps is beside the exact drive', async () => {
  await stay(async ({ page }) => {
    await page.locator('.lecture summary').click();
    await page.locator('.teeth figcaption').waitFor();
    const at10 = Number(/up to ([\d.]+) yd/.exec(await page.locator('.teeth figcaption').textContent())[1]);
    // a step of 10 ms at the landing is 0.2 m of the way
    assert.ok(at10 > 0.1 && at10 < 2, String(at10));
    for (let k = 0; k < 10; k += 1) await page.locator('.lecture').getByLabel('time step').press('ArrowRight');
    await page.waitForFunction(least => Number(/up to ([\d.]+) yd/.exec(document.querySelector('.teeth figcaption').textContent)[1]) > least, at10);
  });
});

test('pictures and tables can be saved', async () => {
  await stay(async ({ page }) => {
    await page.locator('.map .data summary').click();
    for (const [button, start] of [['picture (SVG)', /^<svg[^>]*xmlns/], ['table (CSV)', /^carry \[yd\],/]]) {
      const waiting = page.waitForEvent('download');
      await page.locator('.map').getByRole('button', { name: button }).click();
      assert.match(readFileSync(await (await waiting).path(), 'utf8'), start);
    }
  });
});

test('a page at rest computes nothing', async () => {
  await stay(async ({ page }) => {
    await page.evaluate(() => { window.sent = 0; });
    await page.waitForTimeout(700);
    assert.equal(await page.evaluate(() => window.sent), 0);
  });
});

test('a long command shows that it runs, and can be ended', async () => {
  await stay(async ({ page }) => {
    await page.getByRole('button', { name: /^report/ }).click();
    await page.locator('.working').waitFor();
    await page.locator('.working').getByRole('button', { name: 'end' }).click();
    await page.locator('.working').waitFor({ state: 'detached' });
    await slider(page, 'club.loft').press('ArrowRight');
    await settle(page);
    assert.ok(await answer(page, 'carry', 2) > 286);
  });
});

test('without WebAssembly the page says so', async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.addInitScript(() => { delete window.WebAssembly; });
  await page.goto(file);
  await page.getByText(/cannot compute here.*longdrive report/).waitFor();
  await context.close();
});

/** Random numbers in [0, 1), the same in each run (Mulberry32). */
function random(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

test('300 random links give a message or a state, and change no parameter that they do not name', async () => {
  const next = random(56);
  const pick = list => list[Math.floor(next() * list.length)];
  const NAMES = ['club.loft', 'swing.speed', 'b:club.loft', 'wind.speed', 'map', 'vary', 'units', 'goal', 'active', 'aero.law', 'launch.spin', 'x', ''];
  const TEXTS = ['10deg', '95mph', '', 'none', '1e999', '-', '%', '%E0%A4%A', '<b>', 'club.loft,swing.speed', 'metric', 'total', 'b', 'nathan', '9', '\u0000'];
  const fragments = Array.from({ length: 300 }, () => {
    const parts = Array.from({ length: Math.floor(next() * 5) }, () => `${pick(NAMES)}=${pick(TEXTS)}`);
    return [pick(['1', '2', '', 'x']), pick(['tour-average', 'modern-driver', 'moon', '']), ...parts].join('&');
  });
  await stay(async ({ page, requests }) => {
    const before = requests.filter(url => !url.startsWith('blob:')).length;
    for (const fragmentOfLink of fragments) {
      await page.evaluate(text => { location.hash = text; }, fragmentOfLink);
    }
    await page.waitForTimeout(1000);
    assert.equal(requests.filter(url => !url.startsWith('blob:')).length, before);
    await page.evaluate(() => { location.hash = '1&tour-average&swing.speed=95mph'; });
    await settle(page);
    assert.equal(await field(page, 'club.loft').inputValue(), '8.8');
    assert.equal(await page.locator('.changed').count(), 1);
  });
});
