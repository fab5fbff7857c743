// A state as the part of an address after '#':
// 1&tour-average&swing.speed=100mph&club.loft=10.5deg&b:club.loft=12deg&map=club.loft,swing.speed
import type { Design } from '../setup/design';
import type { Catalog } from '../setup/parameters';
import { compact } from '../setup/units';
import type { State } from './state';
import { GOALS, MOST_DESIGNS, START } from './state';

const VERSION = '1';
const PREFIXES = ['', 'b:', 'c:', 'd:'];
const SYSTEMS = ['us', 'metric'] as const;

/** A lone surrogate (half of a character), which `encodeURIComponent` refuses. */
const LONE = /\p{Surrogate}/gu;

/** Encodes a text for an address, but keeps characters that are readable in it. */
const escape = (text: string) =>
  encodeURIComponent(text.replace(LONE, '\ufffd')).replace(/%2C/g, ',').replace(/%3A/g, ':').replace(/%2F/g, '/');

function differences(design: Design, first: Design): [string, string][] {
  const rows: [string, string][] = [];
  if (design !== first && design.preset !== first.preset) rows.push(['preset', design.preset]);
  for (const [name, text] of Object.entries(design.set)) {
    if (design === first || first.set[name] !== text) rows.push([name, compact(text)]);
  }
  if (design === first) return rows;
  // write an empty text for each value of the first design that this design does not have
  for (const name of Object.keys(first.set)) {
    if (!(name in design.set)) rows.push([name, '']);
  }
  return rows;
}

export function write(state: State): string {
  const [first = START.designs[0]!] = state.designs;
  const parts = [VERSION, escape(first.preset)];
  const add = (name: string, text: string) => parts.push(`${escape(name)}=${escape(text)}`);
  state.designs.forEach((design, at) => {
    const prefix = PREFIXES[at] ?? '';
    const rows = differences(design, first);
    rows.forEach(([name, text]) => add(prefix + name, text));
    // write the preset of a design without differences, so that the design exists in the address
    if (at > 0 && rows.length === 0) add(`${prefix}preset`, design.preset);
  });
  if (state.active > 0) add('active', PREFIXES[state.active]?.[0] ?? 'a');
  if (state.goal !== START.goal) add('goal', state.goal);
  if (state.units !== START.units) add('units', state.units);
  if (state.vary) add('vary', state.vary.join(','));
  if (state.map) add('map', state.map.join(','));
  return parts.join('&');
}

export interface Read {
  state: State;
  /** Parts that this page does not know. */
  unknown: string[];
}

function decoded(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
}

/**
 * Reads a fragment. Parts that this page does not know, for example of a newer version, are listed.
 */
export function read(fragment: string, catalog: Catalog): Read {
  const unknown: string[] = [];
  const [version = '', preset = '', ...parts] = fragment.replace(/^#/, '').split('&').map(decoded);
  if (version === '' && preset === '') return { state: START, unknown };
  if (version !== VERSION) unknown.push(`version ${version}`);
  const reader = new Reader(catalog, preset, unknown);
  parts.filter((part) => part !== '').forEach((part) => reader.part(part));
  return { state: reader.state(), unknown };
}

class Reader {
  readonly #catalog: Catalog;
  readonly #unknown: string[];
  readonly #designs: { preset: string; set: Record<string, string>; gone: Set<string> }[];
  #rest: Partial<State> = {};

  constructor(catalog: Catalog, preset: string, unknown: string[]) {
    this.#catalog = catalog;
    this.#unknown = unknown;
    this.#designs = [{ preset: this.#preset(preset), set: {}, gone: new Set() }];
  }

  #preset(name: string): string {
    if (this.#catalog.preset(name)) return name;
    this.#unknown.push(`preset ${name}`);
    return START.designs[0]!.preset;
  }

  part(part: string) {
    const equals = part.indexOf('=');
    const name = equals < 0 ? part : part.slice(0, equals);
    const text = equals < 0 ? '' : part.slice(equals + 1);
    if (equals < 0 || !(this.#view(name, text) || this.#setting(name, text))) {
      this.#unknown.push(part);
    }
  }

  #view(name: string, text: string): boolean {
    const all = [...new Set(text.split(','))];
    const names = all.filter((each) => this.#catalog.parameter(each));
    const rest = this.#rest as { -readonly [key in keyof State]?: State[key] };
    const active = PREFIXES.findIndex((prefix) => prefix !== '' && prefix[0] === text);
    if (name === 'active' && active > 0) rest.active = active;
    else if (name === 'goal' && GOALS.some((goal) => goal === text)) rest.goal = text as State['goal'];
    else if (name === 'units' && SYSTEMS.some((units) => units === text)) rest.units = text as State['units'];
    else if (name === 'vary' && names.length > 0) rest.vary = names;
    else if (name === 'map' && names.length === 2) rest.map = [names[0]!, names[1]!];
    else return false;
    if (name === 'vary' || name === 'map') {
      const others = all.filter((each) => !names.includes(each));
      this.#unknown.push(...others.map((each) => `${name}=${each}`));
    }
    return true;
  }

  #setting(name: string, text: string): boolean {
    const at = Math.max(0, PREFIXES.findIndex((prefix) => prefix !== '' && name.startsWith(prefix)));
    const bare = name.slice(PREFIXES[at]?.length ?? 0);
    if (at >= MOST_DESIGNS) return false;
    const isPreset = at > 0 && bare === 'preset';
    if (!isPreset && !isParameter(bare, this.#catalog)) return false;
    while (this.#designs.length <= at) {
      this.#designs.push({ preset: this.#designs[0]!.preset, set: {}, gone: new Set() });
    }
    const design = this.#designs[at]!;
    if (isPreset) design.preset = this.#preset(text);
    else if (at > 0 && text === '') design.gone.add(bare);
    else design.set[bare] = text;
    return true;
  }

  state(): State {
    const first = this.#designs[0]!;
    const designs: Design[] = this.#designs.map(({ preset, set, gone }, at) => {
      const inherited = Object.entries(at > 0 ? first.set : {}).filter(([name]) => !gone.has(name));
      return { preset, set: { ...Object.fromEntries(inherited), ...set } };
    });
    const { active: wanted = 0 } = this.#rest;
    const active = Math.min(wanted, designs.length - 1);
    if (active < wanted) this.#unknown.push(`active=${PREFIXES[wanted]?.[0]}`);
    return { ...START, ...this.#rest, designs, active };
  }
}

const isParameter = (name: string, catalog: Catalog) =>
  name === 'aero.law' || (catalog.choice(name) ?? catalog.parameter(name)) !== undefined;
