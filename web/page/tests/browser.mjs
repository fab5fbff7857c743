// Shared by the tests: Chromium of the system, the page as a file and from a server, and its
// messages.
import { createServer } from 'node:http';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const dist = fileURLToPath(new URL('../../dist', import.meta.url));
const BROWSERS = ['/usr/bin/chromium', '/usr/bin/google-chrome', '/usr/bin/chromium-browser'];
const TYPES = { html: 'text/html', js: 'text/javascript', css: 'text/css' };

export const file = pathToFileURL(join(dist, 'explorer.html')).href;

export function launch(more = []) {
  const executablePath = BROWSERS.find(existsSync);
  const args = ['--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking', '--disable-component-update', ...more];
  return chromium.launch({ executablePath, args });
}

/** Serves the files of the site. Returns the address, and a function that ends the server. */
export async function serve() {
  const server = createServer((request, response) => {
    const name = request.url === '/' ? 'index.html' : request.url.slice(1);
    try {
      const content = readFileSync(join(dist, 'site', name));
      response.writeHead(200, { 'content-type': TYPES[name.split('.').at(-1)] ?? 'application/octet-stream' });
      response.end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise(done => { server.listen(0, '127.0.0.1', done); });
  return { address: `http://127.0.0.1:${server.address().port}/`, end: () => server.close() };
}

/** Opens a page. Also returns its console messages and errors (`said`), and its requests. */
export async function open(browser, address = file, { width = 1280, height = 800, ...options } = {}, script = undefined) {
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  const said = [];
  const requests = [];
  page.on('console', message => said.push(message.text()));
  page.on('pageerror', error => said.push(String(error)));
  page.on('request', request => requests.push(request.url()));
  if (script) await page.addInitScript(script);
  await page.goto(address);
  await page.waitForSelector('.answer');
  return { page, context, said, requests };
}

/** Waits until all answers belong to the current state, and a frame has drawn them. */
export async function settle(page) {
  const frame = () => page.evaluate(() => new Promise(done => { requestAnimationFrame(() => setTimeout(done, 0)); }));
  await frame();
  await page.waitForSelector('main[data-busy=false]', { state: 'attached' });
  await frame();
}

/** A number of the answer: row 'carry', column 1 is yours, 2 the best. */
export async function answer(page, row, column) {
  const text = await page.locator('.answer tr', { has: page.getByRole('rowheader', { name: row, exact: true }) })
    .locator('td').nth(column - 1).textContent();
  return Number(text.replace('−', '-').replace(/[^\d.-]/g, ''));
}
