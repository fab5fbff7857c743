// The worth of a change of one parameter, from exact first and second derivatives.
import type { System } from '../setup/units';
import { signed, sizeOf, symbolOf } from '../setup/units';
import type { Slope } from './drive';

/** The loss of the outcome within a band, m: a yard or a metre. */
export const LOSS: Readonly<Record<System, number>> = { us: 0.9144, metric: 1 };

/** A range of values of a parameter within which the outcome loses at most `loss`. */
export interface Band {
  low: number;
  high: number;
}

/**
 * The band around `value`, by the quadratic model: the changes x with first·x + second·x²/2 + loss
 * ≥ 0 that are connected with x = 0.
 */
export function bandOf(value: number, { first, second }: Slope, loss: number): Band {
  let low = -Infinity;
  let high = Infinity;
  const curvature = second / 2;
  const root = first * first - 4 * curvature * loss;
  if (Math.abs(curvature) * loss < 1e-12 * first * first || curvature === 0) {
    // the curvature is 0 or negligible: use the line
    if (first > 0) low = -loss / first;
    if (first < 0) high = -loss / first;
  } else if (root >= 0) {
    // roots of the quadratic, computed without cancellation
    const sum = -0.5 * (first + Math.sign(first || 1) * Math.sqrt(root));
    for (const end of [sum / curvature, loss / sum]) {
      if (end < 0) low = Math.max(low, end);
      if (end > 0) high = Math.min(high, end);
    }
  }
  return { low: value + low, high: value + high };
}

/** The number of units to which a printed price applies, if the price of one unit is too small. */
const STEPS: Readonly<Record<string, number>> = {
  rpm: 100, ft: 1000, m: 100, degF: 10, degC: 10, 'g cm^2': 100, hPa: 10, 'rad/s': 1,
};

/** The same for some parameters, whatever their unit. These numbers take precedence. */
const STEPS_OF: Readonly<Record<string, number>> = { 'wind.from': 10, 'ground.height': 1 };

export interface Price {
  /** The change of the outcome, yd or m, for this number of units. */
  change: number;
  /** The price in words: "+2.4 yd per mph". */
  text: string;
}

/** The price of a parameter in a unit. */
export function priceOf(name: string, { first }: Slope, unit: string, system: System): Price {
  const step = STEPS_OF[name] ?? STEPS[unit] ?? (unit === '' ? 0.01 : 1);
  const length = system === 'us' ? 'yd' : 'm';
  const change = (first * step * sizeOf(unit)) / sizeOf(length);
  const symbol = symbolOf(unit);
  const per = unit === '' ? String(step)
    : step === 1 ? (symbol === '°' ? 'degree' : symbol)
      : symbol === '°' ? `${step}°` : `${step} ${symbol}`;
  const decimals = Math.abs(change) < 0.095 && Math.abs(change) > 0.0005 ? 2 : 1;
  return { change, text: `${signed(change, decimals)} ${length} per ${per}` };
}
