// The best drive: the answer of `optimize`.
import type { Reply } from '../core/messages';
import type { Design } from '../setup/design';
import { withValues } from '../setup/design';
import type { Parameter } from '../setup/parameters';
import type { SliderRange } from '../setup/slider';
import { decimalsOf } from '../setup/slider';
import { textOf } from '../setup/units';
import { rangeWords, setupWords } from '../setup/words';
import type { Goal, State } from './state';

export interface Best {
  goal: Goal;
  names: readonly string[];
  values: Readonly<Record<string, number>>;
  /** The values as texts of a design. */
  texts: Readonly<Record<string, string>>;
  flight: Readonly<Record<string, number | null>>;
  /**
   * Gain of the goal per unit (SI) by which the bound of a parameter is moved outwards; 0 for a
   * parameter within its bounds.
   */
  beyond: Readonly<Record<string, number>>;
}

/** Finds a parameter, and the range of its slider, by name. */
interface Fields {
  parameter(name: string): Parameter;
  sliderRange(name: string): SliderRange;
}

interface OptimizeAnswer {
  optimum: Record<string, number>;
  flight: Record<string, number | null>;
  multipliers: Record<string, { lower: number; upper: number }>;
}

/** The options of a search for the best drive: its goal, and the ranges of the parameters. */
export function searchOptions(
  fields: Fields, { goal, units }: State, names: readonly string[],
): string[] {
  const vary = names.flatMap((name) =>
    ['--vary', rangeWords(fields.parameter(name), fields.sliderRange(name))]);
  return ['--maximize', goal, ...vary, '--units', units];
}

/** The arguments of the command that finds the best drive of a design. */
export function bestWords(
  fields: Fields, state: State, design: Design, names: readonly string[],
): string[] {
  return ['optimize', ...setupWords(design), ...searchOptions(fields, state, names), '--json'];
}

/**
 * A key that changes whenever another best drive is needed. It does not depend on the values that
 * the design has for the parameters of the search.
 */
export function bestKey(fields: Fields, state: State, design: Design, names: readonly string[]): string {
  const others = withValues(design, Object.fromEntries(names.map((name) => [name, undefined])));
  return JSON.stringify(bestWords(fields, state, others, names));
}

export function readBest({ exit, answer }: Reply, goal: Goal, fields: Fields): Best | null {
  if (exit !== 0) return null;
  const { optimum, flight, multipliers } = JSON.parse(answer) as OptimizeAnswer;
  const names = Object.keys(optimum);
  const texts = names.map((name) => {
    const { shown_in: unit } = fields.parameter(name);
    const decimals = Math.max(3, decimalsOf(fields.sliderRange(name), unit) + 2);
    return [name, textOf(optimum[name] ?? NaN, unit, decimals)] as const;
  });
  const beyond = names.map((name) => {
    const { lower = 0, upper = 0 } = multipliers[name] ?? {};
    return [name, lower + upper] as const;
  });
  return {
    goal,
    names,
    values: optimum,
    texts: Object.fromEntries(texts),
    flight,
    beyond: Object.fromEntries(beyond),
  };
}
