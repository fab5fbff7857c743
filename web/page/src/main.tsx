// Starts the page.
import { render } from 'preact';
import { Lane } from './core/lane';
import { load } from './core/load';
import { App } from './parts/App';
import { PageContext } from './parts/context';
import type { Integration } from './state/explorer';
import { Explorer } from './state/explorer';
import { Address } from './state/address';
import { read } from './state/fragment';
import type { Choice, Parameter, Preset } from './setup/parameters';
import { Catalog } from './setup/parameters';
import { travelOf } from './setup/travel';
import './style.css';

/** The integration is accurate within this length, m. */
const TOLERANCE = 1e-6;
/** The sliders on which the accuracy of a step depends most. */
const STEP_RANGES = ['swing.speed', 'club.loft', 'swing.attack_angle'];

async function catalogOf(desk: Lane): Promise<Catalog> {
  const parameters = await desk.command('parameters', ['parameters', '--json']);
  const presets = await desk.command('presets', ['presets', '--json']);
  if (!parameters || !presets) throw new Error('the core does not answer');
  const listed = JSON.parse(parameters.answer) as { parameters: Parameter[]; choices: Choice[] };
  const { presets: all } = JSON.parse(presets.answer) as { presets: Preset[] };
  return new Catalog(listed.parameters, all, listed.choices);
}

/** The longest accurate step for the ranges of the sliders. */
async function integrationOf(hand: Lane, catalog: Catalog, preset: string): Promise<Integration | null> {
  const ranges = STEP_RANGES.map((name) => {
    const { low, high } = travelOf(catalog.parameter(name)!, null, null);
    return { name, low, high };
  });
  const request = { setup: { preset, set: {} }, of: ['carry'], ranges, tolerance: TOLERANCE };
  const answer = await hand.calls('step', [{ door: 'step', request }]);
  const head = answer?.numbers[0]?.head;
  return head?.status === 'done' ? { method: String(head.method), step: Number(head.step) } : null;
}

async function start(place: HTMLElement) {
  const module = await load();
  const hand = new Lane(module);
  const desk = new Lane(module);
  let trap: string | null = null;
  desk.onTrap = (message) => { trap = message; };
  const catalog = await catalogOf(desk).catch((error) => { throw new Error(trap ?? String(error)); });
  const { state, unknown } = read(location.hash, catalog);
  const integration = await integrationOf(hand, catalog, state.designs[0]!.preset);
  const explorer = new Explorer(catalog, hand, desk, integration, state);
  const address = new Address(explorer, unknown);
  explorer.refresh();
  place.textContent = '';
  render(<PageContext.Provider value={{ explorer, address }}><App /></PageContext.Provider>, place);
}

const place = document.getElementById('page');
if (place) {
  start(place).catch((error: unknown) => {
    place.textContent = `This page cannot compute here: ${error instanceof Error ? error.message : String(error)}. `
      + "It needs a browser with WebAssembly (SIMD) and DecompressionStream; 'longdrive report' writes a page that needs neither.";
  });
}
