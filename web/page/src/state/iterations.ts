// The iterations of the search for the best drive, each with its quadratic model.
import type { Call, Numbers, RequestBase } from '../core/messages';
import type { SliderRange } from '../setup/slider';
import type { Goal } from './state';

/** One iteration, SI. Arrays have a number for each parameter that the search varies. */
export interface Iteration {
  /** Number of the search: 0 begins at your drive, 1 at a better drive of a sample. */
  search: number;
  /** Number of earlier iterations of this search. */
  number: number;
  value: number;
  /** Relative KKT residual. */
  residual: number;
  /** The step from `x`; null at the end of a search. */
  trial: Trial | null;
  x: Float64Array;
  /** The bound at which each parameter is: −1 the lower, 1 the upper, 0 none. */
  bounds: Float64Array;
  gradient: Float64Array;
  /** The second derivatives of the model, row by row. */
  hessian: Float64Array;
  /** The trust region, cut off at the ranges: both ends for each parameter. */
  low: Float64Array;
  high: Float64Array;
}

export interface Trial {
  x: Float64Array;
  isAccepted: boolean;
  /** Gain of the outcome that the model predicts. */
  predicted: number;
  /** Actual gain of the outcome, from the drive at `x`. */
  actual: number;
  /** True if the model has no maximum; the step then uses the model with reflected eigenvalues. */
  isReflected: boolean;
}

export interface Iterations {
  goal: Goal;
  names: readonly string[];
  ranges: readonly SliderRange[];
  /** How the search ended. */
  message: string;
  list: readonly Iteration[];
}

export function iterationsCall(
  base: RequestBase, of: string, names: readonly string[], ranges: readonly SliderRange[],
): Call {
  const vary = names.map((name, k) => ({ name, low: ranges[k]!.low, high: ranges[k]!.high }));
  return { endpoint: 'iterations', request: { ...base, of, vary } };
}

export function readIterations({ head, block }: Numbers, goal: Goal, ranges: readonly SliderRange[]): Iterations {
  const names = head.parameters ?? [];
  const n = names.length;
  let at = 0;
  const next = () => block[at++] ?? NaN;
  const numbers = (count: number) => block.subarray(at, at += count);
  const list = Array.from({ length: Number(head.iterations) }, (): Iteration => {
    const [search, number, value, residual] = [next(), next(), next(), next()];
    const [accepted, predicted, actual, reflected] = [next(), next(), next(), next()];
    const x = numbers(n);
    const bounds = numbers(n);
    const gradient = numbers(n);
    const hessian = numbers(n * n);
    const [low, high, trial] = [numbers(n), numbers(n), numbers(n)];
    return {
      search,
      number,
      value,
      residual,
      trial: Number.isNaN(accepted) ? null
        : { x: trial, isAccepted: accepted === 1, predicted, actual, isReflected: reflected === 1 },
      x,
      bounds,
      gradient,
      hessian,
      low,
      high,
    };
  });
  return { goal, names, ranges, message: head.message ?? '', list };
}

/** The quadratic model of an iteration at another point. */
export function modelAt({ value, x, gradient, hessian }: Iteration, at: ArrayLike<number>): number {
  const n = x.length;
  let sum = value;
  for (let i = 0; i < n; i += 1) {
    const d = at[i]! - x[i]!;
    sum += gradient[i]! * d;
    for (let k = 0; k < n; k += 1) sum += 0.5 * d * hessian[i * n + k]! * (at[k]! - x[k]!);
  }
  return sum;
}
