// Builds the page: node build.mjs CORE.wasm [--quick] [--sizes], into ../dist/explorer.html and ../dist/site.
// --quick compresses less; --sizes prints the brotli-compressed size of the core (half a minute).
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { WASI } from '@bjorn3/browser_wasi_shim';
import { build } from 'vite';
import { Core } from '../core/core.mjs';
import { pack } from './src/core/pack.mjs';

const here = fileURLToPath(new URL('.', import.meta.url));
const dist = join(here, '../dist');
const [core] = process.argv.slice(2);

/** Bundles an entry, a source file, to one classic script and its style. */
async function bundle(entry, plugins = []) {
  const { output } = [await build({
    root: here,
    configFile: false,
    logLevel: 'warn',
    plugins,
    esbuild: { jsx: 'automatic', jsxImportSource: 'preact', charset: 'ascii' },
    build: {
      write: false,
      target: 'es2022',
      cssCodeSplit: false,
      modulePreload: false,
      lib: { entry: join(here, entry), formats: ['iife'], name: 'longdrive', cssFileName: 'page' },
    },
    define: { 'process.env.NODE_ENV': '"production"' },
  })].flat()[0];
  const script = output.find(({ type }) => type === 'chunk').code;
  const style = output.find(({ fileName }) => fileName.endsWith('.css'))?.source ?? '';
  return { script, style: String(style) };
}

/** Parameters, choices and presets, as the core lists them; with the integration of each preset. */
async function listed(wasm, stepRequest) {
  const core = await Core.start(await WebAssembly.compile(wasm), new WASI([], [], [], { debug: false }));
  const answer = command => JSON.parse(core.ask({ words: [command, '--json'] }).head.answer);
  const { parameters, choices } = answer('parameters');
  const integrationOf = preset => {
    if (preset.states_step) return null;
    const { status, method, step } = core.step(stepRequest(parameters, preset.name));
    return status === 'done' ? { method, step } : null;
  };
  const presets = answer('presets').presets.map(preset => ({ ...preset, integration: integrationOf(preset) }));
  return { parameters, choices, presets };
}

const hash = text => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** The content security policy of the page: its own script only, requests only to `connect`. */
const policy = ({ script, style, connect }) => [
  "default-src 'none'",
  `script-src ${script} 'wasm-unsafe-eval'`,
  `style-src ${style}`,
  // the icon: without an icon in the page, a browser requests one from the server
  'img-src data:',
  // a worker made of a text in the page
  'worker-src blob:',
  `connect-src ${connect}`,
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

const ascii = text => text.replace(/[\u0080-\uffff]/g, unit => `&#${unit.charCodeAt(0)};`);

const page = ({ charset, rules, head, foot }) => ascii(`<!doctype html>
<html lang="en">
<head>
<meta charset="${charset}">
<meta http-equiv="Content-Security-Policy" content="${rules}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>longdrive: the explorer</title>
<link rel="icon" href="data:,">
`) + head + ascii(`
</head>
<body>
<div id="page"><p class="start">The page starts.</p></div>
<noscript><p>This page computes in the browser and needs JavaScript; 'longdrive report' writes a page that does not.</p></noscript>
`) + foot + '</body>\n</html>\n';

/** A plugin for the bundler with modules that this file makes. */
const made = modules => ({
  name: 'made',
  resolveId: id => (id in modules ? `\0${id}` : null),
  load: id => (id.startsWith('\0virtual:') ? `export default ${modules[id.slice(1)]}` : null),
});

const wasm = readFileSync(core);
const worker = await bundle('src/core/worker.ts');
const integration = await bundle('src/setup/integration.ts');
const { stepRequest } = new Function(`${integration.script}; return longdrive;`)();
const { script, style } = await bundle('src/main.tsx', [made({
  'virtual:worker': JSON.stringify(worker.script),
  'virtual:catalog': JSON.stringify(await listed(wasm, stepRequest)),
})]);
if (/[^\0-\x7f]/.test(script + style)) throw new Error('the script or the style is not ASCII');
// escape the end tag of a script, which would end this script too early
const code = script.replace(/<\/script/gi, '<\\/script');

const compressed = gzipSync(wasm, { level: process.argv.includes('--quick') ? 1 : 9 });

rmSync(dist, { recursive: true, force: true });
const site = join(dist, 'site');
mkdirSync(site, { recursive: true });
writeFileSync(join(site, 'index.html'), page({
  charset: 'utf-8',
  rules: policy({ script: "'self'", style: "'self'", connect: "'self'" }),
  head: '<link rel="stylesheet" href="page.css">',
  foot: '<script src="page.js"></script>\n',
}));
writeFileSync(join(site, 'page.js'), code);
writeFileSync(join(site, 'page.css'), style);
writeFileSync(join(site, 'longdrive_core.bin'), compressed);

const [before, after] = page({
  charset: 'windows-1252',
  rules: policy({ script: hash(code), style: hash(style), connect: "'none'" }),
  head: `<style>${style}</style>`,
  foot: `<script type="application/gzip" id="core">CORE</script>\n<script>${code.replace(/CORE/g, 'C\\u004fRE')}</script>\n`,
}).split('CORE');
const file = join(dist, 'explorer.html');
writeFileSync(file, Buffer.concat([Buffer.from(before), pack(compressed), Buffer.from(after)]));

const kilobytes = bytes => `${Math.round(bytes / 1000)} kB`;
const brotli = bytes => brotliCompressSync(bytes).length;
const sizes = {
  'one file': kilobytes(readFileSync(file).length),
  core: kilobytes(wasm.length),
  'script (brotli)': kilobytes(brotli(Buffer.from(code))),
};
if (process.argv.includes('--sizes')) sizes['core (brotli)'] = kilobytes(brotli(wasm));
console.log(Object.entries(sizes).map(([name, size]) => `${name} ${size}`).join(', '));
