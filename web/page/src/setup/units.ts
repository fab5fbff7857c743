// Units of fields and results.

export type System = 'us' | 'metric';

interface Unit {
  /** The SI unit of the same quantity. */
  si: string;
  /** SI = (number + offset) × factor. */
  factor: number;
  offset?: number;
  /** The printed unit, if it differs from the name. */
  symbol?: string;
}

const DEGREE = Math.PI / 180;
const RPM = Math.PI / 30;

/**
 * The units in which the page shows and writes numbers. The core reads texts in all units of the
 * program; the tests compare its values with this table.
 */
export const UNITS: Readonly<Record<string, Unit>> = {
  '': { si: '', factor: 1 },
  'm/s': { si: 'm/s', factor: 1 },
  mph: { si: 'm/s', factor: 0.44704 },
  m: { si: 'm', factor: 1 },
  mm: { si: 'm', factor: 1e-3 },
  ft: { si: 'm', factor: 0.3048 },
  yd: { si: 'm', factor: 0.9144 },
  deg: { si: 'rad', factor: DEGREE, symbol: '°' },
  'rad/s': { si: 'rad/s', factor: 1 },
  rpm: { si: 'rad/s', factor: RPM },
  g: { si: 'kg', factor: 1e-3 },
  'g cm^2': { si: 'kg m^2', factor: 1e-7, symbol: 'g cm²' },
  'kg/m^3': { si: 'kg/m^3', factor: 1, symbol: 'kg/m³' },
  'Pa s': { si: 'Pa s', factor: 1 },
  hPa: { si: 'Pa', factor: 100 },
  degC: { si: 'K', factor: 1, offset: 273.15, symbol: '°C' },
  degF: { si: 'K', factor: 5 / 9, offset: 459.67, symbol: '°F' },
  s: { si: 's', factor: 1 },
  '1/s': { si: '1/s', factor: 1 },
  's/m': { si: 's/m', factor: 1 },
  's/rad': { si: 's/rad', factor: 1 },
  'm/s^2': { si: 'm/s^2', factor: 1, symbol: 'm/s²' },
};

/** Units of each system that replace units in which the program shows values. */
const INSTEAD: Readonly<Record<System, Readonly<Record<string, string>>>> = {
  us: { degC: 'degF', 'm/s': 'mph' },
  metric: { mph: 'm/s', ft: 'm' },
};

export const unitIn = (system: System, shownIn: string) => INSTEAD[system][shownIn] ?? shownIn;

const known = (unit: string): Unit => UNITS[unit] ?? { si: unit, factor: 1 };

export const toSI = (number: number, unit: string) =>
  (number + (known(unit).offset ?? 0)) * known(unit).factor;

export const fromSI = (si: number, unit: string) => si / known(unit).factor - (known(unit).offset ?? 0);

/** The SI size of one unit. A difference is converted with it, without an offset. */
export const sizeOf = (unit: string) => known(unit).factor;

export const symbolOf = (unit: string) => known(unit).symbol ?? unit;

/** A number with its unit, as it is printed: "10.5°", "100 mph". */
export function withUnit(number: string, unit: string): string {
  const symbol = symbolOf(unit);
  if (symbol === '') return number;
  return symbol === '°' ? `${number}°` : `${number} ${symbol}`;
}

/** A number with a true minus sign, and without a sign if it rounds to zero. */
export function digits(number: number, decimals: number): string {
  if (!Number.isFinite(number)) return '–';
  const text = number.toFixed(decimals);
  return Number(text) === 0 ? text.replace('-', '') : text.replace('-', '−');
}

/** The largest number of decimals: a viscosity is about 1.8e-5 Pa s. */
const MOST_DECIMALS = 12;

/**
 * The texts of numbers, with at least `decimals` digits after the point. Numbers that differ by
 * more than rounding have different texts.
 */
export function distinct(numbers: readonly number[], decimals: number): string[] {
  const texts = numbers.map((number) => digits(number, decimals));
  const count = new Set(numbers.map((number) => digits(Number(number.toPrecision(9)), MOST_DECIMALS))).size;
  return new Set(texts).size === count || decimals >= MOST_DECIMALS
    ? texts : distinct(numbers, decimals + 1);
}

/** A difference with its sign. */
export function signed(number: number, decimals: number): string {
  const text = digits(number, decimals);
  return number > 0 && Number(text) !== 0 ? `+${text}` : text;
}

/** The number of a JSON value of the program (`inf`: infinity); null for other texts. */
export function siOf(value: number | string | null): number | null {
  if (typeof value === 'number') return value;
  return value === 'inf' ? Infinity : null;
}

const QUANTITY = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*(.*?)\s*$/i;

/** Number and unit of a text such as "10.5 deg"; null for other texts. */
export function parts(text: string): { number: number; unit: string } | null {
  const match = QUANTITY.exec(text.replace('−', '-'));
  return match ? { number: Number(match[1]), unit: match[2] ?? '' } : null;
}

/** The SI value of a text in a unit of `UNITS`; null for a text that only the core can read. */
export function valueOf(text: string, unitSI: string): number | null {
  const read = parts(text);
  if (!read || UNITS[read.unit]?.si !== unitSI) return null;
  return toSI(read.number, read.unit);
}

/** A quantity without the space before its unit: "10.5deg". */
export const compact = (text: string) => text.replace(/^([-+.\de]+) /i, '$1');

/** A text for the core, with 12 significant digits. */
export function preciseText(si: number, unit: string): string {
  const number = String(Number(fromSI(si, unit).toPrecision(12)));
  return unit === '' ? number : `${number} ${unit}`;
}

/**
 * A text for the core. It has as many digits after the point as the number needs, at most
 * `decimals`.
 */
export function textOf(si: number, unit: string, decimals: number): string {
  const number = String(Number(fromSI(si, unit).toFixed(decimals)));
  return unit === '' ? number : `${number} ${unit}`;
}
