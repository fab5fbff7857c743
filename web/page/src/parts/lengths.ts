// Lengths of results in the chosen units.
import type { System } from '../setup/units';
import { digits, fromSI, signed } from '../setup/units';

export const lengthUnit = (system: System) => (system === 'us' ? 'yd' : 'm');

export const inLength = (metres: number, system: System) => fromSI(metres, lengthUnit(system));

/** A length: "286.0 yd". */
export const length = (metres: number | null | undefined, system: System) =>
  `${digits(inLength(metres ?? NaN, system), 1)} ${lengthUnit(system)}`;

/** A change of a length, with its sign: "+14.5 yd". */
export const lengthChange = (metres: number, system: System) =>
  `${signed(inLength(metres, system), 1)} ${lengthUnit(system)}`;

/** A distance to the side, with its direction: "3.2 yd right". */
export function sideways(metres: number, system: System): string {
  const number = digits(Math.abs(inLength(metres, system)), 1);
  if (Number(number) === 0) return 'on the target line';
  return `${number} ${lengthUnit(system)} ${metres > 0 ? 'right' : 'left'}`;
}

/** The text of a tick with all of its digits: `ticks` gives round numbers. */
export const tickText = (tick: number) => String(tick).replaceAll('-', '−');

/** Round numbers within a range, in steps of which about `count` fit into the range. */
export function ticks(low: number, high: number, count: number): number[] {
  const raw = (high - low) / Math.max(1, count);
  if (!(raw > 0) || !Number.isFinite(raw)) return [];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((part) => part * power).find((each) => each >= raw) ?? raw;
  const first = Math.ceil(low / step - 1e-9);
  const length = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}
