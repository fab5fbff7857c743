// The integration method and step for a preset's drives. web/build computes them with the core:
// they depend only on the preset, and computing them in the page would take longer than the first
// drive.
import type { Parameter } from './parameters';
import { sliderRangeOf } from './slider';

/** Method and time step, s, that are accurate for all drives within the ranges of the sliders. */
export interface Integration {
  method: string;
  step: number;
}

/** The largest error of the integration, m. */
const TOLERANCE = 1e-6;
/** The sliders on which the accuracy of a step depends most. */
const RANGES = ['swing.speed', 'club.loft', 'swing.attack_angle'];

/** A request for the longest step that is accurate within `RANGES`. */
export function stepRequest(parameters: readonly Parameter[], preset: string) {
  const ranges = parameters.filter(({ parameter }) => RANGES.includes(parameter)).map((row) => {
    const { low, high } = sliderRangeOf(row, null, null);
    return { name: row.parameter, low, high };
  });
  return { setup: { preset, set: {} }, of: ['carry'], ranges, tolerance: TOLERANCE };
}
