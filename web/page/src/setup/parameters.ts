// Parameters and presets, as the program lists them.
import { signal } from '@preact/signals';
import type { Integration } from './integration';
import type { System } from './units';
import { unitIn } from './units';

export interface Parameter {
  parameter: string;
  symbol: string;
  unit: string;
  shown_in: string;
  kind: 'required' | 'optional' | 'setting';
  /** The value without a preset, SI. */
  default: Value;
  /** The source of `default`. */
  source: string;
  /** The law that has this parameter as a coefficient; null for other parameters. */
  law: string | null;
  doc: string;
  range: { low: number | string; high: number | string } | null;
}

/** A choice that is no number, such as the hand of the golfer. */
export interface Choice {
  choice: string;
  value: string | null;
  default: string | null;
  names: string[];
  doc: string;
}

export type Value = number | string | null;

export interface Preset {
  name: string;
  about: string;
  setup: Record<string, Value>;
  /** True if the preset states method and step; otherwise the page chooses both. */
  states_step: boolean;
  /** Method and step that the page chooses; null if the preset states them or no step is found. */
  integration: Integration | null;
  sources: Record<string, string>;
}

export class Catalog {
  readonly parameters: readonly Parameter[];
  readonly presets: readonly Preset[];
  /**
   * The choices that presets state, in the order of the presets. The kind of turf is not among
   * them, because presets state the parameters of the turf instead.
   */
  readonly choices: readonly Choice[];
  readonly #byName = new Map<string, Parameter[]>();
  /** Values, SI, of texts that only the core can read, by unit (SI) and text. */
  readonly #values = signal<ReadonlyMap<string, number>>(new Map());

  constructor(
    parameters: readonly Parameter[], presets: readonly Preset[], choices: readonly Choice[],
  ) {
    this.parameters = parameters;
    this.presets = presets;
    const names = Object.keys(presets[0]?.setup ?? {});
    this.choices = names.flatMap((name) => choices.filter(({ choice }) => choice === name));
    for (const row of parameters) {
      this.#byName.set(row.parameter, [...(this.#byName.get(row.parameter) ?? []), row]);
    }
  }

  preset(name: string): Preset | undefined {
    return this.presets.find((preset) => preset.name === name);
  }

  choice(name: string): Choice | undefined {
    return this.choices.find(({ choice }) => choice === name);
  }

  /**
   * The parameter of this name. `law` chooses among laws that have the same name, such as aero.cd0.
   */
  parameter(name: string, law?: Value): Parameter | undefined {
    const all = this.#byName.get(name);
    return all?.find((parameter) => parameter.law === law) ?? all?.[0];
  }

  /** The value of a text that the core has read. */
  readValue(text: string, unit: string): number | undefined {
    return this.#values.value.get(`${unit} ${text}`);
  }

  keepValue(text: string, unit: string, value: number) {
    this.#values.value = new Map([...this.#values.peek(), [`${unit} ${text}`, value]]);
  }

  /** The parameters of a design's law, without settings of the integration. */
  of(law: Value): Parameter[] {
    return this.parameters.filter((row) =>
      row.kind !== 'setting' && (row.law === null || row.law === law));
  }
}

/** The unit of a field. */
export const unitOf = ({ shown_in }: Parameter, system: System) => unitIn(system, shown_in);

/** Words for names that are unclear without further words, or clear without their group. */
const NAMED: Readonly<Record<string, string>> = {
  'swing.speed': 'club speed',
  'swing.attack_angle': 'attack angle',
  'swing.path': 'club path',
  'swing.face_angle': 'face angle',
  'club.loft': 'loft',
  'strike.toe': 'strike to toe',
  'strike.high': 'strike high',
  'wind.from': 'wind from',
  'air.altitude': 'altitude',
  'air.temperature': 'temperature',
  gravity: 'gravity',
  golfer: 'golfer',
  'swing.speed_of': 'point of the club speed',
  'flight.method': 'method of integration',
};

const spaced = (text: string) => text.replace(/[._]/g, ' ');

/** The words for a parameter: "loft", "ball mass". */
export function labelOf(name: string): string {
  const named = NAMED[name];
  if (named) return named;
  return name.startsWith('launch.') ? spaced(name.slice('launch.'.length)) : spaced(name);
}

/** The words for a parameter below the heading of its group. */
export function labelInGroup(name: string): string {
  const dot = name.indexOf('.');
  return spaced(dot < 0 ? name : name.slice(dot + 1));
}

/** The group of a parameter, as in a setup file. */
export const groupOf = (name: string) => name.split('.')[0] ?? name;

/** The sliders of the first screen. */
export const CLUB_FIRST = [
  'club.loft', 'swing.speed', 'swing.attack_angle', 'swing.face_angle', 'swing.path',
  'strike.toe', 'strike.high',
];
export const LAUNCH_FIRST = [
  'launch.ball_speed', 'launch.launch_angle', 'launch.backspin', 'launch.launch_direction',
  'launch.sidespin',
];
export const AIR_FIRST = ['wind.speed', 'wind.from', 'air.altitude', 'air.temperature'];
