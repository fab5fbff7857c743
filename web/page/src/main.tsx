// Starts the page.
import { render } from 'preact';
import listed from 'virtual:catalog';
import { Lane } from './core/lane';
import { packedCore } from './core/load';
import { App } from './parts/App';
import { PageContext } from './parts/context';
import { Explorer } from './state/explorer';
import { Address } from './state/address';
import { read } from './state/fragment';
import { Catalog } from './setup/parameters';
import './style.css';

/** Draws the page while the worker `interactive` compiles the core. */
async function start(place: HTMLElement) {
  const [interactive, background] = [new Lane(), new Lane()];
  const started = interactive.start(packedCore());
  const catalog = new Catalog(listed.parameters, listed.presets, listed.choices);
  const { state, unknown } = read(location.hash, catalog);
  const explorer = new Explorer(catalog, interactive, background, state);
  const address = new Address(explorer, unknown);
  explorer.refresh();
  place.textContent = '';
  render(<PageContext.Provider value={{ explorer, address }}><App /></PageContext.Provider>, place);
  try {
    await background.start(await started);
  } catch (error) {
    render(null, place);
    throw error;
  }
}

const place = document.getElementById('page');
if (place) {
  start(place).catch((error: unknown) => {
    place.textContent = `This page cannot compute here: ${error instanceof Error ? error.message : String(error)}. `
      + "It needs a browser with WebAssembly (SIMD) and DecompressionStream; 'longdrive report' writes a page that needs neither.";
  });
}
