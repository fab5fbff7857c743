// Setup files of the program, down and up.
import type { Design } from './design';
import { NONE } from './design';
import type { Catalog, Parameter } from './parameters';
import { textOf } from './units';

/** A setup file. Dotted names are keys of TOML. */
export function writeSetup(design: Design): string {
  const rows = Object.entries(design.set).map(([name, text]) => `${name} = ${JSON.stringify(text)}`);
  return [`preset = ${JSON.stringify(design.preset)}`, ...rows, ''].join('\n');
}

/** Values that follow from others, where these are stated. */
const WEATHER = ['air.temperature', 'air.pressure', 'air.altitude', 'air.humidity'];
const FROM_WEATHER = ['air.density', 'air.viscosity'];
const FROM_WIND = ['wind.right', 'wind.downrange'];

/** What `parameters --json` says about a file. */
export interface FileValues {
  law: string;
  parameters: (Parameter & { value: number | string | null })[];
}

/** The first key of a file that the page cannot show, so that it would be lost; null if there is none. */
export function lostKey(toml: string): string | null {
  return /^\s*(?:\w+\.)?(golfer|speed_of|method)\s*=/m.exec(toml)?.[1] ?? null;
}

/** The design of a file: the preset nearest to it, and all values that differ. */
export function designOf(values: FileValues, catalog: Catalog): Design {
  const stated = new Set(values.parameters
    .filter(({ value }) => value !== null).map(({ parameter }) => parameter));
  const follows = (name: string) =>
    (FROM_WEATHER.includes(name) && WEATHER.some((each) => stated.has(each)))
    || (FROM_WIND.includes(name) && stated.has('wind.speed'));
  const rows = values.parameters.filter(({ law, parameter }) =>
    (law === null || law === values.law) && !follows(parameter));
  const candidates = catalog.presets.map((preset): Design => {
    const set: Record<string, string> = {};
    if (preset.setup['aero.law'] !== values.law) set['aero.law'] = values.law;
    for (const { parameter, value, shown_in } of rows) {
      if (same(preset.setup[parameter] ?? null, value)) continue;
      set[parameter] = typeof value === 'number' ? textOf(value, shown_in, 10) : value ?? NONE;
    }
    return { preset: preset.name, set };
  });
  const count = ({ set }: Design) => Object.keys(set).length;
  return candidates.reduce((best, next) => (count(next) < count(best) ? next : best));
}

function same(one: number | string | null, other: number | string | null): boolean {
  if (typeof one !== 'number' || typeof other !== 'number') return one === other;
  return Math.abs(one - other) <= 1e-12 * Math.max(Math.abs(one), Math.abs(other));
}
