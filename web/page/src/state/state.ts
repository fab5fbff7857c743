// The content of a link: designs, and how they are shown.
import type { Design } from '../setup/design';
import { hasLaunch, isIdle, spinOf } from '../setup/design';
import type { Catalog } from '../setup/parameters';
import type { System } from '../setup/units';

export type Goal = 'carry' | 'total';
export const GOALS: readonly Goal[] = ['carry', 'total'];

export interface State {
  /** One to four designs. The sliders change the active one. */
  readonly designs: readonly Design[];
  readonly active: number;
  readonly goal: Goal;
  readonly units: System;
  /** Parameters that the best drive may change; null for the default of `varyOf`. */
  readonly vary: readonly string[] | null;
  /** Horizontal and vertical parameter of the map; null for the default. */
  readonly map: readonly [string, string] | null;
}

export const MOST_DESIGNS = 4;
export const DESIGN_NAMES = ['A', 'B', 'C', 'D'] as const;

export const START: State = {
  designs: [{ preset: 'tour-average', set: {} }],
  active: 0,
  goal: 'carry',
  units: 'us',
  vary: null,
  map: null,
};

export const activeOf = (state: State): Design => state.designs[state.active] ?? START.designs[0]!;

/**
 * The parameters that the best drive may change. The default is the loft, which a golfer chooses
 * with the club, or the launch angle if a launch is given.
 */
export function varyOf(state: State, catalog: Catalog): readonly string[] {
  const design = activeOf(state);
  const usual = hasLaunch(design) ? ['launch.launch_angle'] : ['club.loft'];
  const chosen = (state.vary ?? usual).filter((name) => !isIdle(name, design, catalog));
  return chosen.length ? chosen : usual;
}

/**
 * Adds a parameter to those that the best drive may change, or removes it. Chosen parameters that
 * have no effect in this design stay chosen.
 */
export function withVaried(state: State, catalog: Catalog, name: string, isVaried: boolean): State {
  const design = activeOf(state);
  const idle = (state.vary ?? []).filter((each) => isIdle(each, design, catalog));
  const others = varyOf(state, catalog).filter((each) => each !== name);
  return { ...state, vary: [...idle, ...others, ...(isVaried ? [name] : [])] };
}

/** The horizontal and the vertical parameter of the map. */
export function mapOf(state: State, catalog: Catalog): readonly [string, string] {
  const design = activeOf(state);
  const usual: [string, string] = hasLaunch(design)
    ? ['launch.launch_angle', spinOf(design)] : ['club.loft', 'swing.attack_angle'];
  const chosen = state.map ?? usual;
  return chosen.some((name) => isIdle(name, design, catalog)) ? usual : chosen;
}

export function withDesign(state: State, design: Design): State {
  const designs = state.designs.map((old, at) => (at === state.active ? design : old));
  return { ...state, designs };
}
