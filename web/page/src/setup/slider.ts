// Ranges of the sliders. The ranges of the program allow any physics; a slider covers golf.
import type { Parameter } from './parameters';
import { sizeOf, toSI } from './units';

export interface SliderRange {
  low: number;
  high: number;
  /** The smallest step of the slider, SI. */
  step: number;
}

/** Low, high and step in a unit, and this unit. */
type Row = readonly [low: number, high: number, step: number, unit: string];

const ROWS: Readonly<Record<string, Row>> = {
  'swing.speed': [60, 140, 0.1, 'mph'],
  'swing.attack_angle': [-10, 10, 0.1, 'deg'],
  'swing.path': [-10, 10, 0.1, 'deg'],
  'swing.face_angle': [-10, 10, 0.1, 'deg'],
  'club.loft': [4, 20, 0.1, 'deg'],
  'strike.toe': [-25, 25, 0.5, 'mm'],
  'strike.high': [-20, 20, 0.5, 'mm'],
  'wind.speed': [0, 40, 0.1, 'mph'],
  'wind.from': [-180, 180, 1, 'deg'],
  'air.altitude': [0, 10000, 10, 'ft'],
  'air.temperature': [-10, 45, 0.5, 'degC'],
  'launch.ball_speed': [90, 220, 0.1, 'mph'],
  'launch.launch_angle': [0, 25, 0.1, 'deg'],
  'launch.launch_direction': [-10, 10, 0.1, 'deg'],
  'launch.backspin': [500, 6000, 10, 'rpm'],
  'launch.sidespin': [-2000, 2000, 10, 'rpm'],
  'launch.spin': [500, 6000, 10, 'rpm'],
  'launch.spin_axis': [-40, 40, 0.1, 'deg'],
  'ground.slope': [-10, 10, 0.1, 'deg'],
  'ground.side_slope': [-10, 10, 0.1, 'deg'],
  'ground.height': [-30, 30, 0.1, 'm'],
  'ground.restitution': [0, 1, 0.01, ''],
  'impact.restitution': [0.6, 0.95, 0.001, ''],
  'wind.up': [-10, 10, 0.1, 'm/s'],
  'wind.right': [-20, 20, 0.1, 'm/s'],
  'wind.downrange': [-20, 20, 0.1, 'm/s'],
  'air.humidity': [0, 1, 0.01, ''],
  'air.pressure': [700, 1080, 1, 'hPa'],
};

/**
 * The range of a slider that has no row in `ROWS`: from half of the value to three halves of it, or
 * from −5 to 5 units if the value is 0 or unset.
 */
function around(value: number | null, unit: string): SliderRange {
  const size = value === null || value === 0 || !Number.isFinite(value)
    ? 10 * sizeOf(unit) : Math.abs(value);
  const middle = value !== null && Number.isFinite(value) ? value : 0;
  return { low: middle - size / 2, high: middle + size / 2, step: size / 200 };
}

const within = (end: number | string, value: number) =>
  typeof end === 'number' ? end : value;

/** The range of a slider. It stays within the range of the program, and contains the value. */
export function sliderRangeOf(parameter: Parameter, preset: number | null, value: number | null): SliderRange {
  const row = ROWS[parameter.parameter];
  const unit = parameter.shown_in;
  const range = row
    ? { low: toSI(row[0], row[3]), high: toSI(row[1], row[3]), step: row[2] * sizeOf(row[3]) }
    : around(preset, unit);
  const { low, high } = parameter.range ?? { low: '-inf', high: 'inf' };
  range.low = Math.max(range.low, within(low, range.low));
  range.high = Math.min(range.high, within(high, range.high));
  if (value === null || !Number.isFinite(value)) return range;
  return { ...range, low: Math.min(range.low, value), high: Math.max(range.high, value) };
}

/** Number of digits after the point in a field. */
export function decimalsOf({ step }: SliderRange, unit: string): number {
  const inUnit = step / sizeOf(unit);
  return Math.max(0, Math.min(8, Math.ceil(-Math.log10(inUnit) - 1e-9)));
}
