// The content of a link: designs, and how they are shown.
import type { Design } from '../setup/design';
import { hasLaunch, isReplaced, spinOf } from '../setup/design';
import type { System } from '../setup/units';

export type Goal = 'carry' | 'total';
export const GOALS: readonly Goal[] = ['carry', 'total'];

export interface State {
  /** One to four designs. The sliders change the active one. */
  readonly designs: readonly Design[];
  readonly active: number;
  readonly goal: Goal;
  readonly units: System;
  /** Parameters that the best drive may change; null for those of `varyOf`. */
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
export function varyOf(state: State): readonly string[] {
  const isLaunch = hasLaunch(activeOf(state));
  const usual = isLaunch ? ['launch.launch_angle'] : ['club.loft'];
  const chosen = (state.vary ?? usual).filter((name) => !isReplaced(name, isLaunch));
  return chosen.length ? chosen : usual;
}

/**
 * Adds a parameter to those that the best drive may change, or removes it. Chosen parameters that
 * have no effect now, because a launch is given or not, stay chosen.
 */
export function withVaried(state: State, name: string, isVaried: boolean): State {
  const isLaunch = hasLaunch(activeOf(state));
  const idle = (state.vary ?? []).filter((each) => isReplaced(each, isLaunch));
  const others = varyOf(state).filter((each) => each !== name);
  return { ...state, vary: [...idle, ...others, ...(isVaried ? [name] : [])] };
}

export function mapOf(state: State): readonly [string, string] {
  const isLaunch = hasLaunch(activeOf(state));
  const usual: [string, string] = isLaunch
    ? ['launch.launch_angle', spinOf(activeOf(state))] : ['club.loft', 'swing.attack_angle'];
  const chosen = state.map ?? usual;
  return chosen.some((name) => isReplaced(name, isLaunch)) ? usual : chosen;
}

export function withDesign(state: State, design: Design): State {
  const designs = state.designs.map((old, at) => (at === state.active ? design : old));
  return { ...state, designs };
}
