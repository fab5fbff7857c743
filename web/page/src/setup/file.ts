// Setup files of the program: download and upload.
import type { Design } from './design';
import { NONE, defaultOf } from './design';
import type { Catalog, Choice, Parameter } from './parameters';
import type { System } from './units';
import { preciseText, siOf, unitIn } from './units';

/** The text of a setup file. Dotted names are keys of TOML. */
export function writeSetup(design: Design): string {
  const rows = Object.entries(design.set).map(([name, text]) => `${name} = ${JSON.stringify(text)}`);
  return [`preset = ${JSON.stringify(design.preset)}`, ...rows, ''].join('\n');
}

/**
 * Parameters of the weather. If one of them is stated, the program computes density and viscosity
 * of the air; if the wind speed is stated, it computes the components of the wind.
 */
const WEATHER = ['air.temperature', 'air.pressure', 'air.altitude', 'air.humidity'];
const FROM_WEATHER = ['air.density', 'air.viscosity'];
const FROM_WIND = ['wind.right', 'wind.downrange'];

/** The answer of `parameters --json` about a setup file. */
export interface FileValues {
  law: string;
  parameters: (Parameter & { value: number | string | null })[];
  choices: Choice[];
  /** True if the file or its preset states method and step; otherwise the page chooses both. */
  states_step: boolean;
}

/** Method and step, which are stated together or not at all. */
const OF_STEP = ['flight.method', 'flight.step'];

/**
 * The design of a file. Its preset is the one with the fewest differences; all values that differ
 * are in its `set`.
 */
export function designOf(values: FileValues, catalog: Catalog, system: System): Design {
  const stated = new Set(values.parameters
    .filter(({ value }) => value !== null).map(({ parameter }) => parameter));
  const follows = (name: string) =>
    (FROM_WEATHER.includes(name) && WEATHER.some((each) => stated.has(each)))
    || (FROM_WIND.includes(name) && stated.has('wind.speed'));
  const isUsed = (name: string) =>
    !follows(name) && (values.states_step || !OF_STEP.includes(name));
  const rows = values.parameters.filter(({ law, parameter }) =>
    (law === null || law === values.law) && isUsed(parameter));
  const choices = values.choices.filter(({ choice }) => catalog.choice(choice) && isUsed(choice));
  // leave out presets that state a step, unless the file states one: their step would replace the
  // step that the page or the program chooses
  const presets = catalog.presets.filter((preset) => values.states_step || !preset.states_step);
  const candidates = presets.map((preset): Design => {
    const set: Record<string, string> = {};
    if (preset.setup['aero.law'] !== values.law) set['aero.law'] = values.law;
    const law = { preset: preset.name, set: { ...set } };
    const isOfPreset = (name: string) => preset.states_step || !OF_STEP.includes(name);
    for (const { choice, value } of choices) {
      const isKept = isOfPreset(choice) && preset.setup[choice] === value;
      if (value !== null && !isKept) set[choice] = value;
    }
    for (const { parameter, value, shown_in } of rows) {
      const { value: byDefault } = defaultOf(parameter, law, catalog);
      if (isOfPreset(parameter) && same(byDefault, siOf(value))) continue;
      set[parameter] = typeof value === 'number' ? preciseText(value, unitIn(system, shown_in)) : value ?? NONE;
    }
    return { preset: preset.name, set };
  });
  const count = ({ set }: Design) => Object.keys(set).length;
  return candidates.reduce((best, next) => (count(next) < count(best) ? next : best));
}

function same(one: number | null, other: number | null): boolean {
  if (one === null || other === null || one === other) return one === other;
  return Math.abs(one - other) <= 1e-12 * Math.max(Math.abs(one), Math.abs(other));
}
