// The while-loop of the MAE 494 report beside the exact drive, along one parameter or over two
// parameters.
import type { Call, Numbers, RequestBase } from '../core/messages';
import type { MapAxes } from './map';

/** Values at the nodes, SI; NaN without a landing. */
export interface Loop {
  name: string;
  at: Float64Array;
  /** Carry of the loop. */
  loop: Float64Array;
  /** Difference quotient of the loop's carry, which stands in for a derivative. */
  difference: Float64Array;
  /** Carry of the exact drive. */
  carry: Float64Array;
  /** Derivative of the exact carry. */
  slope: Float64Array;
}

interface Along {
  name: string;
  low: number;
  high: number;
}

/** Columns in the answer. The third one, the interpolated landing of the loop, is not used. */
const COLUMNS = 6;

export const loopCall = (
  base: RequestBase, along: Along, nodes: number, step: number, difference: number,
): Call => ({ endpoint: 'loop', request: { ...base, along, nodes, step, difference } });

export function readLoop({ head, block }: Numbers): Loop {
  const nodes = Number(head.nodes);
  const [at, loop, , difference, carry, slope] = Array.from({ length: COLUMNS }, (_, k) =>
    block.subarray(k * nodes, (k + 1) * nodes));
  return { name: String(head.parameter), at: at!, loop: loop!, difference: difference!, carry: carry!, slope: slope! };
}

/** The largest distance between the carry of the loop and the exact carry, m. */
export function worstOf({ loop, carry }: Pick<Loop, 'loop' | 'carry'>): number {
  return loop.reduce((most, value, k) => {
    const distance = Math.abs(value - carry[k]!);
    return Number.isFinite(distance) ? Math.max(most, distance) : most;
  }, 0);
}

/** The calls for the loop over a map: one for each row, from the lowest. */
export function loopMapCalls(
  { across, up, ranges }: MapAxes, base: RequestBase, nodes: number, step: number,
): Call[] {
  const [along, { low, high }] = ranges;
  return Array.from({ length: nodes }, (_, row) => {
    const value = low + ((high - low) * row) / (nodes - 1);
    const setup = { ...base.setup, set: { ...base.setup.set, [up]: value } };
    return loopCall({ ...base, setup }, { name: across, low: along.low, high: along.high }, nodes, step, along.step);
  });
}
