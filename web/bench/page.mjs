// Times the page in Chromium from a local server, after web/build: node web/bench/page.mjs
// Frames are drawn without waiting for a display: a display of 60 Hz would add 0 to 16.7 ms to a
// move of a user, and always 16.7 ms here, because each move begins just after a frame.
import { launch, open, serve, settle } from '../page/tests/browser.mjs';

const MOVES = 300;
/** Number of new browser contexts, each with a first drive that is timed from the page request. */
const FIRST = 10;

/** Collects the time of the first drive, and of each call: in the worker, and with its messages. */
function collect() {
  window.firstDrive = new Promise(done => {
    const look = () => {
      const carry = document.querySelector('.answer .goal td')?.textContent ?? '';
      if (/\d/.test(carry)) done(performance.now());
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  window.calls = [];
  const post = Worker.prototype.postMessage;
  const sent = new Map();
  Worker.prototype.postMessage = function timed(message, ...rest) {
    if (message.kind === 'calls') {
      const endpoints = message.calls.map(({ endpoint, request }) => `${endpoint}${request.nodes?.[0] ?? ''}`);
      sent.set(`${this.id ??= Math.random()}/${message.number}`, [endpoints[0], performance.now()]);
    }
    if (message.kind === 'command') sent.set(`${this.id ??= Math.random()}/${message.number}`, [message.command.words[0], performance.now()]);
    return post.call(this, message, ...rest);
  };
  const listen = Worker.prototype.addEventListener;
  Worker.prototype.addEventListener = function timed(kind, listener, ...rest) {
    return listen.call(this, kind, event => {
      const [name, begin] = sent.get(`${this.id}/${event.data?.number}`) ?? [];
      if (name) window.calls.push({ name, worker: event.data.milliseconds ?? performance.now() - begin, way: performance.now() - begin });
      listener(event);
    }, ...rest);
  };
}

/** Moves a slider; milliseconds from each move until the page has its drive, and until a frame shows it. */
async function move({ id, moves }) {
  const slider = document.querySelector(id);
  const [low, high] = [Number(slider.min), Number(slider.max)];
  const path = document.querySelector('.side polyline.yours');
  const times = [];
  for (let k = 0; k < moves; k += 1) {
    slider.value = String(low + (high - low) * (0.35 + 0.3 * ((k * 0.618) % 1)));
    const begin = performance.now();
    const drawn = new Promise(done => {
      const observer = new MutationObserver(() => {
        observer.disconnect();
        const changed = performance.now() - begin;
        requestAnimationFrame(() => setTimeout(() => done({ changed, drawn: performance.now() - begin }), 0));
      });
      observer.observe(path, { attributes: true });
    });
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    times.push(await drawn);
  }
  slider.dispatchEvent(new Event('change', { bubbles: true }));
  return times;
}

const at = (sorted, part) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
function say(name, times) {
  const sorted = [...times].sort((a, b) => a - b);
  console.log(`${name.padEnd(44)} median ${at(sorted, 0.5).toFixed(1)} ms, 95 % ${at(sorted, 0.95).toFixed(1)} ms (${times.length})`);
}

const browser = await launch(['--disable-frame-rate-limit', '--disable-gpu-vsync']);
const server = await serve();
const firstDrives = [];
let page;
for (let k = 0; k < FIRST; k += 1) {
  await page?.context().close();
  ({ page } = await open(browser, server.address, {}, collect));
  firstDrives.push(await page.evaluate(() => window.firstDrive));
  await settle(page);
}
say('first drive after the request of the page', firstDrives);
const calls = () => page.evaluate(() => window.calls.splice(0));
const times = (all, name) => all.filter(call => call.name === name);
const first = await calls();
say('map 20 × 20, first', times(first, 'map20').map(({ worker }) => worker));
say('map 60 × 60, first', times(first, 'map60').map(({ worker }) => worker));
for (const id of ['#slide-club-loft', '#slide-swing-speed']) {
  const moved = await page.evaluate(move, { id, moves: MOVES });
  const drives = times(await calls(), 'drive');
  say(`${id.slice(7)}: drive and prices in the worker`, drives.map(({ worker }) => worker));
  say(`${id.slice(7)}: from the move to the page`, moved.map(({ changed }) => changed));
  say(`${id.slice(7)}: from the move to the frame`, moved.map(({ drawn }) => drawn));
  await settle(page);
}
for (let k = 0; k < 10; k += 1) {
  await page.locator('#slide-swing-speed').press('ArrowRight');
  await settle(page);
}
const rest = await calls();
say('map 20 × 20', times(rest, 'map20').map(({ worker }) => worker));
say('map 60 × 60', times(rest, 'map60').map(({ worker }) => worker));
say('best drive, with the choice of its step', times(rest, 'optimize').map(({ way }) => way));
await page.locator('.aim summary').click();
for (let k = 0; k < 40; k += 1) await page.locator('.aim').getByLabel('lateral').press('ArrowRight');
await settle(page);
say('landing moved by 0.5 yd (aim)', times(await calls(), 'aim').map(({ worker }) => worker));
await browser.close();
server.end();
