// Starts the page.
import { render } from 'preact';
import listed from 'virtual:catalog';
import { Lane } from './core/lane';
import { load } from './core/load';
import { App } from './parts/App';
import { PageContext } from './parts/context';
import type { Integration } from './state/explorer';
import { Explorer } from './state/explorer';
import { Address } from './state/address';
import { read } from './state/fragment';
import { Catalog } from './setup/parameters';
import { travelOf } from './setup/travel';
import './style.css';

/** Tolerance of the integration, m. */
const TOLERANCE = 1e-6;
/** The sliders on which the accurate step depends most. */
const STEP_RANGES = ['swing.speed', 'club.loft', 'swing.attack_angle'];

/** The longest accurate step for the ranges of the sliders; null if there is none. */
async function integrationOf(hand: Lane, catalog: Catalog, preset: string): Promise<Integration | null> {
  const ranges = STEP_RANGES.map((name) => {
    const { low, high } = travelOf(catalog.parameter(name)!, null, null);
    return { name, low, high };
  });
  const request = { setup: { preset, set: {} }, of: ['carry'], ranges, tolerance: TOLERANCE };
  const answer = await hand.calls('step', [{ door: 'step', request }]);
  const head = answer?.numbers[0]?.head;
  if (!head) throw new Error('the core does not answer');
  return head.status === 'done' ? { method: String(head.method), step: Number(head.step) } : null;
}

/** Draws the page while the core chooses the step. */
async function start(place: HTMLElement) {
  const module = load();
  const [hand, desk] = [new Lane(), new Lane()];
  const catalog = new Catalog(listed.parameters, listed.presets, listed.choices);
  const { state, unknown } = read(location.hash, catalog);
  const explorer = new Explorer(catalog, hand, desk, state);
  const address = new Address(explorer, unknown);
  const core = await module;
  hand.start(core);
  desk.start(core);
  const integration = integrationOf(hand, catalog, state.designs[0]!.preset);
  place.textContent = '';
  render(<PageContext.Provider value={{ explorer, address }}><App /></PageContext.Provider>, place);
  try {
    explorer.begin(await integration);
  } catch (error) {
    render(null, place);
    throw new Error(explorer.trap.value ?? String(error));
  }
}

const place = document.getElementById('page');
if (place) {
  start(place).catch((error: unknown) => {
    place.textContent = `This page cannot compute here: ${error instanceof Error ? error.message : String(error)}. `
      + "It needs a browser with WebAssembly (SIMD) and DecompressionStream; 'longdrive report' writes a page that needs neither.";
  });
}
