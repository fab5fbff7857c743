// Outcomes in the words and units of a launch monitor.
import type { Drive } from '../drive/drive';
import type { System } from '../setup/units';
import { digits, fromSI, withUnit } from '../setup/units';

interface Row {
  name: string;
  label: string;
  unit: Readonly<Record<System, string>>;
  decimals: number;
}

const both = (unit: string) => ({ us: unit, metric: unit });
const LENGTH = { us: 'yd', metric: 'm' } as const;
const SPEED = { us: 'mph', metric: 'm/s' } as const;

const row = (name: string, label: string, unit: Row['unit'], decimals: number): Row =>
  ({ name, label, unit, decimals });

export const ROWS: readonly Row[] = [
  row('ball_speed', 'ball speed', SPEED, 1),
  row('smash_factor', 'smash factor', both(''), 3),
  row('launch_angle', 'launch angle', both('deg'), 1),
  row('launch_direction', 'launch direction', both('deg'), 1),
  row('backspin', 'backspin', both('rpm'), 0),
  row('sidespin', 'sidespin', both('rpm'), 0),
  row('spin_axis', 'spin axis', both('deg'), 1),
  row('carry', 'carry', LENGTH, 1),
  row('total', 'total', LENGTH, 1),
  row('run', 'run', LENGTH, 1),
  row('lateral', 'lateral', LENGTH, 1),
  row('apex_height', 'apex height', LENGTH, 1),
  row('descent_angle', 'descent angle', both('deg'), 1),
  row('landing_speed', 'landing speed', SPEED, 1),
  row('flight_time', 'flight time', both('s'), 2),
];

/** All outcomes of a drive, SI; null for an outcome without a value. */
export const outcomesOf = ({ outcomes }: Drive) =>
  Object.fromEntries(Object.entries(outcomes).map(([name, value]) => [name, Number.isFinite(value) ? value : null]));

/** The printed value of an outcome. */
export function shown({ unit, decimals, name }: Row, drive: Drive, system: System): string {
  const number = drive.outcomes[name] ?? NaN;
  if (Number.isNaN(number)) return '–';
  return withUnit(digits(fromSI(number, unit[system]), decimals), unit[system]);
}
