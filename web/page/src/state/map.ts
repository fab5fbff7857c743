// The map: an outcome over two parameters.
import type { Call, Numbers, RequestBase } from '../core/messages';
import type { Design } from '../setup/design';
import type { SliderRange } from '../setup/slider';
import type { Goal } from './state';

/** The parameters of a map with their ranges, SI, and the outcome. */
export interface MapAxes {
  across: string;
  up: string;
  ranges: readonly [SliderRange, SliderRange];
  goal: Goal;
}

export interface MapData extends MapAxes {
  columns: number;
  rows: number;
  /** Values of the outcome, m, row by row from the lowest row; NaN without a landing. */
  values: Float64Array;
}

/** A key that changes whenever another map is needed. */
export function mapKey({ preset, set }: Design, { across, up, goal }: MapAxes): string {
  const rest = Object.entries(set).filter(([name]) => name !== across && name !== up);
  return JSON.stringify([preset, across, up, goal, rest]);
}

/** The request for a map with these numbers of columns and rows. */
export function mapCall(
  { across, up, ranges, goal }: MapAxes, base: RequestBase, nodes: readonly [number, number],
): Call {
  const [first, second] = [across, up].map((name, axis) => {
    const { low, high } = ranges[axis]!;
    return { name, low, high };
  });
  const request = { ...base, of: [goal], across: first, up: second, nodes };
  return { endpoint: 'map', request };
}

export const readMap = ({ head, block }: Numbers, axes: MapAxes): MapData =>
  ({ ...axes, columns: Number(head.columns), rows: Number(head.rows), values: block });
