// The state of the page and the answers of the core about it. Components read its signals.
import { batch, computed, signal } from '@preact/signals';
import type { Lane, Progress } from '../core/lane';
import type { Call, Reply, RequestBase } from '../core/messages';
import type { Drive, Refusal, Slope } from '../drive/drive';
import { isRefused, readDrive, readMissing, readSlopes, readStated, refusalOf } from '../drive/drive';
import type { Design } from '../setup/design';
import { WHEN_UNSET, firstOf, hasLaunch, keepValues, lawOf, numberOf, resetOf, setupOf, together, defaultOf, withValues } from '../setup/design';
import type { Catalog, Parameter } from '../setup/parameters';
import { AIR_FIRST, LAUNCH_FIRST, groupOf } from '../setup/parameters';
import type { SliderRange } from '../setup/slider';
import { decimalsOf, sliderRangeOf } from '../setup/slider';
import { digits, distinct, fromSI, textOf, unitIn } from '../setup/units';
import { setupWords } from '../setup/words';
import type { Best } from './best';
import { bestKey, bestWords, readBest, searchOptions } from './best';
import { Debounce } from './debounce';
import { Latest } from './latest';
import type { MapAxes, MapData } from './map';
import { mapCall, mapKey, readMap } from './map';
import type { State } from './state';
import { activeOf, mapOf, varyOf, withDesign } from './state';

const COARSE = 20;
const FINE = 60;
/** Milliseconds after the last change until the slower answers are computed. */
const REST = 150;

/** A design with its drive; without a drive if the core refused the design. */
export interface FlownDesign {
  design: Design;
  drive: Drive | null;
}

export class Explorer {
  readonly catalog: Catalog;
  /** The worker for answers that follow a slider. */
  readonly interactive: Lane;
  /** The worker for searches and other long work. */
  readonly background: Lane;

  readonly state;
  /** The last drive that the core did not refuse. */
  readonly drive = new Latest<Drive>(() => this.#driveKey.value);
  readonly refusal = signal<Refusal | null>(null);
  readonly slopes = signal<ReadonlyMap<string, Slope>>(new Map());
  /**
   * The reason for each parameter without a derivative in this setup, for example that another
   * parameter replaces it.
   */
  readonly noSlope = signal<ReadonlyMap<string, string>>(new Map());
  /** The CSS class of an element that shows `drive`: stale if the present drive is refused. */
  readonly driveMark = computed(() =>
    (this.refusal.value !== null && !this.drive.isCurrent ? 'stale' : ''));
  /** The best drive; null if the search found none, for the reason `bestMessage`. */
  readonly best = new Latest<Best | null>(() => this.#bestKey.value);
  /**
   * The reason why there is no best drive. Unlike `best`, it depends on the start of the search.
   */
  readonly bestMessage = new Latest<string | null>(() => this.#driveKey.value);
  /** The drive with the best values. */
  readonly ghost = new Latest<Drive | null>(() => this.#bestKey.value);
  readonly map = new Latest<MapData>(() => this.#mapKey.value);
  /** The reason for a missing map. */
  readonly mapMessage = new Latest<string>(() => this.#mapKey.value);
  readonly mapBest = new Latest<Best | null>(() => this.#mapKey.value);
  /** All designs with their drives. They are not computed for a single design. */
  readonly flownDesigns = new Latest<readonly FlownDesign[]>(
    () => JSON.stringify(this.state.value.designs));
  /** True while an answer about the state is missing. */
  readonly busy = signal(true);
  readonly trap = signal<string | null>(null);
  readonly progress = signal<(Progress & { what: string }) | null>(null);
  /** The long command that runs, then those that wait for it. */
  readonly #long = signal<readonly { what: string; topic: string }[]>([]);
  /** The description of the long command that runs; null without one. */
  readonly working = computed(() => this.#long.value[0]?.what ?? null);
  readonly aimMessage = new Latest<string | null>(() => this.#driveKey.value);
  /**
   * The time step of the loop that is drawn over the map and a slider, s; null if none is drawn.
   */
  readonly loopStep = signal<number | null>(null);
  /** The question of the last search for the best point of a map; null if it found none. */
  #mapBestAsked: string | null = null;
  /** The parameters that are shown below the sliders of the first screen. */
  #listed: readonly string[] = [];
  readonly design = computed(() => activeOf(this.state.value));
  // Parts of the state that seldom change. A component that reads only these is not rendered at
  // each move of a slider.
  readonly units = computed(() => this.state.value.units);
  readonly goal = computed(() => this.state.value.goal);
  readonly law = computed(() => lawOf(this.design.value, this.catalog));
  readonly isLaunch = computed(() => hasLaunch(this.design.value));
  /** The parameters that the best drive may change. */
  readonly varied = computed(() => varyOf(this.state.value, this.catalog));
  /** The horizontal and the vertical parameter of the map. */
  readonly mapNames = computed(() => mapOf(this.state.value, this.catalog));

  readonly #driveKey = computed(() => {
    const { goal, units } = this.state.value;
    return JSON.stringify([this.design.value, goal, units]);
  });
  readonly #bestKey = computed(() =>
    bestKey(this, this.state.value, this.design.value, this.varied.value));
  readonly #mapKey = computed(() => mapKey(this.design.value, this.#mapAxes()));
  /** Ends when the last request for a drive has its answer, or when a newer one replaces it. */
  #flown = Promise.resolve();
  /** The design of the last aim. */
  #aimed: Design | null = null;
  #traps = 0;
  #commands = 0;
  readonly #rest = new Debounce(REST);
  /** Called after each change; `isFinal` is false during a drag. */
  onChange: (state: State, isFinal: boolean) => void = () => {};

  constructor(catalog: Catalog, interactive: Lane, background: Lane, state: State) {
    this.catalog = catalog;
    this.interactive = interactive;
    this.background = background;
    this.state = signal(state);
    for (const lane of [interactive, background]) {
      lane.onTrap = (message) => this.#trapped(message);
      // look only after the receivers of the last answer have sent their requests
      lane.onIdle = () => setTimeout(() => this.#look(), 0);
    }
    background.onProgress = (progress) => {
      const what = this.working.value;
      this.progress.value = progress && what ? { ...progress, what } : null;
    };
  }

  // actions of the components

  /** Changes the state. `isFinal` is false during a drag. */
  change(state: State, isFinal = true) {
    const isOther = state !== this.state.value;
    this.state.value = state;
    this.onChange(state, isFinal);
    if (isOther) this.refresh();
  }

  changeDesign(design: Design, isFinal = true) {
    this.change(withDesign(this.state.value, design), isFinal);
  }

  /** Sets one parameter to a typed text. */
  set(name: string, text: string, isFinal = true) {
    const { design } = this;
    this.changeDesign(
      withValues(design.value, { ...together(name, design.value), [name]: text }), isFinal);
  }

  /** Sets one parameter from a slider. */
  slide(name: string, value: number, isFinal: boolean) {
    const { unit, decimals } = this.field(name);
    this.set(name, textOf(value, unit, decimals), isFinal);
  }

  reset(name: string) {
    const design = this.design.value;
    this.changeDesign(withValues(design, resetOf(name, design)));
  }

  /**
   * Records which parameters are shown below the sliders of the first screen, and requests their
   * prices.
   */
  setListed(names: readonly string[]) {
    const isMore = names.some((name) => !this.#listed.includes(name));
    this.#listed = names;
    if (isMore) this.refresh();
  }

  /** Sets the parameters of the search to their best values, if the best drive is known. */
  goToBest() {
    const best = this.best.current;
    if (best) this.changeDesign(withValues(this.design.value, best.texts));
  }

  /**
   * Replaces swing and club by the launch of their drive. If the drive is still computed, waits for
   * it; a change meanwhile cancels the switch to the launch.
   */
  async startWithLaunch() {
    const design = this.design.value;
    await this.#settled();
    const outcomes = this.drive.current?.outcomes;
    if (!outcomes || design !== this.design.value) return;
    const values = LAUNCH_FIRST.map((name) => {
      const { parameter, decimals } = this.field(name);
      return [name, textOf(outcomes[name.slice('launch.'.length)] ?? 0, parameter.shown_in, decimals)] as const;
    });
    this.changeDesign(withValues(design, Object.fromEntries(values)));
  }

  /**
   * Resolves when the core has answered about the present drive. Waits again if a newer request has
   * replaced the awaited one.
   */
  async #settled() {
    let awaited;
    do {
      awaited = this.#flown;
      await awaited;
    } while (awaited !== this.#flown);
  }

  /** Ends a drag: its last state can be undone. */
  release() {
    this.onChange(this.state.value, true);
  }

  // contents of the fields

  parameter(name: string): Parameter {
    const found = this.catalog.parameter(name, this.law.value);
    if (!found) throw new Error(`no parameter ${name}`);
    return found;
  }

  value(name: string): number | null {
    return numberOf(name, this.design.value, this.catalog);
  }

  /** The value that a parameter has if the design does not state it. */
  defaultValue(name: string): number | null {
    return defaultOf(name, this.design.value, this.catalog).value;
  }

  sliderRange(name: string): SliderRange {
    return sliderRangeOf(this.parameter(name), this.defaultValue(name), this.value(name));
  }

  unit(name: string): string {
    return unitIn(this.units.value, this.parameter(name).shown_in);
  }

  field(name: string) {
    const unit = this.unit(name);
    return { parameter: this.parameter(name), unit, decimals: decimalsOf(this.sliderRange(name), unit) };
  }

  /**
   * The number of a value in the unit of its field: "8.80". It has `more` digits than the field.
   */
  shown(name: string, value: number, more = 1): string {
    const { unit, decimals } = this.field(name);
    return digits(fromSI(value, unit), decimals + more);
  }

  /** The numbers of values in the unit of their field. Values that differ have different texts. */
  distinct(name: string, values: readonly number[]): string[] {
    const { unit, decimals } = this.field(name);
    return distinct(values.map((value) => fromSI(value, unit)), decimals);
  }

  // requests to the core

  /** The setup of a request to the core, and the units of its messages. */
  requestBase(design: Design = this.design.value): RequestBase {
    const isStated = 'flight.step' in design.set || 'flight.method' in design.set;
    const integration = this.catalog.preset(design.preset)?.integration;
    const chosen = integration && !isStated
      ? { 'flight.method': integration.method, 'flight.step': integration.step } : {};
    const { preset, set } = setupOf(design);
    return { setup: { preset, set: { ...chosen, ...set } }, units: this.units.value };
  }

  #look() {
    this.busy.value = this.#rest.isWaiting || !this.interactive.isIdle || !this.background.isIdle;
  }

  /** Requests all answers about the state. A worker that has no core yet keeps the requests. */
  refresh() {
    this.busy.value = true;
    const flown = this.#fly();
    this.#flown = flown;
    this.#rest.call(async () => {
      // wait for the drive, which may request a coarse map: if that came later, it would replace
      // the waiting request for the fine map
      await flown;
      void this.#findBest();
      void this.#flyDesigns();
      await this.#flyMap(FINE);
      void this.#findMapBest();
    });
  }

  /** The parameters whose prices are computed. */
  #priced(): string[] {
    const shown = [...firstOf(this.design.value), ...AIR_FIRST, ...this.#listed];
    // the law may have changed since the parameters were shown
    return this.catalog.of(this.law.value).map(({ parameter }) => parameter)
      .filter((name) => shown.includes(name) && this.value(name) !== null);
  }

  async #fly() {
    const goal = this.goal.value;
    const design = this.design.value;
    const question = this.drive.question();
    const base = this.requestBase();
    const wrt = this.#priced();
    const calls: Call[] = [
      { endpoint: 'drive', request: { ...base, path: true, of: [goal], wrt } }];
    const unset = this.#unsetCall();
    if (unset) calls.push(unset);
    const answers = await this.interactive.calls('drive', calls);
    const first = answers?.[0];
    if (!first) return;
    this.#traps = 0;
    batch(() => {
      keepValues(readStated(first), design, this.catalog);
      if (isRefused(first)) {
        this.refusal.value = refusalOf(first);
        return;
      }
      const drive = readDrive(first);
      this.drive.give(question, drive);
      this.refusal.value = drive.status === 'landed' ? null
        : { message: drive.message ?? drive.status, parameters: [] };
      const known = answers.filter((numbers) => !isRefused(numbers));
      this.slopes.value = new Map(known.flatMap((numbers) => [...readSlopes(numbers)]));
      this.noSlope.value = new Map(known.flatMap((numbers) => [...readMissing(numbers)]));
    });
    // a coarse map at once: it does not depend on the values on its axes, so it seldom changes
    if (!this.map.isCurrent) void this.#flyMap(COARSE);
  }

  /**
   * The call for prices of unset parameters of wind and air. They are taken at the values that an
   * unset parameter stands for. Null if no such parameter is unset.
   */
  #unsetCall(): Call | null {
    const { set } = this.design.value;
    const isCalm = ['wind.right', 'wind.downrange'].every((name) => this.value(name) === 0);
    const hasWind = 'wind.speed' in set || 'wind.from' in set;
    const hasAir = ['air.density', 'air.pressure'].some((name) => name in set);
    const names = AIR_FIRST.filter((name) => this.value(name) === null
      && (groupOf(name) === 'wind' ? isCalm && !hasWind : !hasAir));
    if (names.length === 0) return null;
    const { setup, units } = this.requestBase();
    const stated = Object.fromEntries(names.map((name) => [name, WHEN_UNSET[name] ?? 0]));
    const request = {
      setup: { ...setup, set: { ...setup.set, ...stated } },
      units,
      of: [this.state.value.goal],
      wrt: names,
      outcomes: false,
    };
    return { endpoint: 'drive', request };
  }

  async #findBest() {
    const state = this.state.value;
    const design = this.design.value;
    const question = this.best.question();
    const messageQuestion = this.bestMessage.question();
    const words = bestWords(this, state, design, this.varied.value);
    const reply = await this.background.command('best', words);
    if (!reply) return;
    const best = readBest(reply, state.goal, this);
    batch(() => {
      this.bestMessage.give(messageQuestion, best ? null : messageOf(reply));
      this.best.give(question, best);
      if (!best) this.ghost.give(question, null);
    });
    if (!best) return;
    const base = this.requestBase(withValues(design, best.texts));
    const request = { ...base, path: true };
    const numbers = await this.interactive.call('ghost', { endpoint: 'drive', request });
    if (numbers && !isRefused(numbers)) this.ghost.give(question, readDrive(numbers));
  }

  async #flyDesigns() {
    const { designs } = this.state.value;
    if (designs.length < 2) return;
    const question = this.flownDesigns.question();
    const calls = designs.map((design): Call =>
      ({ endpoint: 'drive', request: { ...this.requestBase(design), path: true } }));
    const answers = await this.interactive.calls('designs', calls);
    if (!answers) return;
    this.flownDesigns.give(question, designs.map((design, at) => {
      const numbers = answers[at];
      if (!numbers) return { design, drive: null };
      keepValues(readStated(numbers), design, this.catalog);
      return { design, drive: isRefused(numbers) ? null : readDrive(numbers) };
    }));
  }

  /** The axes of the map. A drag does not change their ranges, so the map stays. */
  #mapAxes(): MapAxes {
    const [across, up] = this.mapNames.value;
    const range = (name: string) => sliderRangeOf(this.parameter(name), this.defaultValue(name), null);
    return { across, up, ranges: [range(across), range(up)], goal: this.state.value.goal };
  }

  async #flyMap(nodes: number) {
    if ((this.map.current?.columns ?? 0) >= nodes) return;
    const axes = this.#mapAxes();
    const question = this.map.question();
    const numbers = await this.interactive.call('map', mapCall(axes, this.requestBase(), [nodes, nodes]));
    if (!numbers) return;
    if (isRefused(numbers)) {
      this.mapMessage.give(question, refusalOf(numbers).message);
      return;
    }
    this.map.give(question, readMap(numbers, axes));
  }

  /** Finds the best point of the map, unless it is known or being searched. */
  async #findMapBest() {
    const question = this.mapBest.question();
    if (this.#mapBestAsked === question || !this.map.isCurrent) return;
    this.#mapBestAsked = question;
    const state = this.state.value;
    const words = bestWords(this, state, this.design.value, this.mapNames.value);
    const reply = await this.background.command('map best', words);
    const best = reply && readBest(reply, state.goal, this);
    if (!best && this.#mapBestAsked === question) this.#mapBestAsked = null;
    if (reply) this.mapBest.give(question, best);
  }

  /**
   * Sets two parameters so that the ball lands at this point (m), or as near to it as the ranges of
   * the sliders allow.
   */
  async aim(names: readonly [string, string], carry: number, lateral: number) {
    const vary = names.map((name) => ({ name, ...ends(this.sliderRange(name)) }));
    const request = { ...this.requestBase(), vary, carry, lateral };
    const design = this.design.value;
    this.busy.value = true;
    const numbers = await this.interactive.call('aim', { endpoint: 'aim', request });
    if (!numbers) return;
    // drop the answer if the design was changed since, except by an earlier aim of this drag
    const isCurrent = [design, this.#aimed].includes(this.design.value);
    if (!isCurrent) return;
    const { head, block } = numbers;
    if (head.status === 'reached' || head.status === 'nearest') {
      const values = Object.fromEntries(names.map((name, k) =>
        [name, textOf(block[k] ?? NaN, this.field(name).unit, 4)]));
      this.#aimed = withValues(this.design.value, values);
      this.changeDesign(this.#aimed, false);
    }
    this.aimMessage.give(this.aimMessage.question(), head.message ?? null);
  }

  /** Runs a long command, and shows its progress. The answer is null if the command was ended. */
  async run(what: string, words: string[], files: Record<string, Uint8Array> = {}): Promise<Reply | null> {
    // a topic of its own: the next command waits for this one, and does not replace it
    this.#commands += 1;
    const command = { what, topic: `long ${this.#commands}` };
    this.#long.value = [...this.#long.value, command];
    const reply = await this.background.command(command.topic, words, files);
    this.#long.value = this.#long.value.filter((other) => other !== command);
    return reply;
  }

  /** Ends the long command that runs. */
  end() {
    const [command] = this.#long.value;
    if (command) this.background.end(command.topic);
  }

  #trapped(message: string) {
    this.trap.value = message;
    this.#traps += 1;
    // compute the drive again only after the first of consecutive traps
    if (this.#traps === 1) this.#rest.call(() => this.refresh());
  }

  /** The design as arguments of the command line. */
  words(): string[] {
    return setupWords(this.design.value);
  }

  /** The options of the search for the best drive. */
  searchOptions(): string[] {
    return searchOptions(this, this.state.value, this.varied.value);
  }
}

const ends = ({ low, high }: SliderRange) => ({ low, high });

/** The message of a command without an answer. */
export function messageOf({ answer, said }: Reply): string {
  try {
    const { message } = JSON.parse(answer) as { message?: string };
    if (message) return message;
  } catch {
    // the answer is not JSON: the messages of the command are in `said`
  }
  return said.map(({ text }) => text).join(' ') || 'no answer';
}
