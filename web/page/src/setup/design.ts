// A design: a preset, and the parameters that differ from it.
import type { Catalog, Value } from './parameters';
import { CLUB_FIRST, LAUNCH_FIRST } from './parameters';
import { siOf, valueOf } from './units';

/** The text that unsets a parameter. */
export const NONE = 'none';

export interface Design {
  readonly preset: string;
  /** Values as they are typed, with units: "10.5 deg". */
  readonly set: Readonly<Record<string, string>>;
}

/** The setup of a request to the core. */
export const setupOf = ({ preset, set }: Design) => ({
  preset,
  set: Object.fromEntries(
    Object.entries(set).map(([name, text]) => [name, text === NONE ? null : text] as const)),
});

export const hasLaunch = ({ set }: Design) =>
  Object.entries(set).some(([name, text]) => name.startsWith('launch.') && text !== NONE);

const OF_STRIKE = /^(swing|club|strike|impact)\.|^golfer$/;

/**
 * True for a parameter or choice without effect. If a launch is given, these are the parameters of
 * the strike, otherwise those of the launch.
 */
export const isReplaced = (name: string, isLaunch: boolean) =>
  (isLaunch ? OF_STRIKE.test(name) : name.startsWith('launch.'));

/**
 * The sliders of the first screen for the start of the ball: of the launch if it is given,
 * otherwise of the club.
 */
export function firstOf(design: Design): readonly string[] {
  if (!hasLaunch(design)) return CLUB_FIRST;
  return hasSpinAxis(design) ? LAUNCH_FIRST.map((name) => BY_SPIN[name] ?? name) : LAUNCH_FIRST;
}

/** The parameter of a launch for the amount of its spin. */
export const spinOf = (design: Design) => (hasSpinAxis(design) ? 'launch.spin' : 'launch.backspin');

/** True if a launch states its spin with an axis, false if as backspin and sidespin. */
const hasSpinAxis = ({ set }: Design) =>
  Object.values(BY_SPIN).some((name) => (set[name] ?? NONE) !== NONE);

/** The parameters of a spin with an axis, by those of the same spin as backspin and sidespin. */
const BY_SPIN: Readonly<Record<string, string>> = {
  'launch.backspin': 'launch.spin',
  'launch.sidespin': 'launch.spin_axis',
};

/** The aerodynamic law of a design. */
export const lawOf = (design: Design, catalog: Catalog): Value =>
  design.set['aero.law'] ?? catalog.preset(design.preset)?.setup['aero.law'] ?? null;

/**
 * True for a parameter without effect in a design: launch or strike replace it, or it is a
 * coefficient of another law.
 */
export function isIdle(name: string, design: Design, catalog: Catalog): boolean {
  const law = lawOf(design, catalog);
  const ofLaw = catalog.parameter(name, law)?.law ?? null;
  return isReplaced(name, hasLaunch(design)) || (ofLaw !== null && ofLaw !== law);
}

/**
 * Value (SI) and source of a parameter that the design does not state. The value is that of the
 * preset. If the design has another law than its preset, a coefficient has the value of the law.
 */
export function defaultOf(name: string, design: Design, catalog: Catalog) {
  const law = lawOf(design, catalog);
  const preset = catalog.preset(design.preset);
  const row = catalog.parameter(name, law);
  const isOfLaw = row !== undefined && row.law !== null && row.law === law;
  if (isOfLaw && law !== preset?.setup['aero.law']) {
    return { owner: 'law', value: siOf(row.default), source: row.source };
  }
  return { owner: 'preset', value: siOf(preset?.setup[name] ?? null), source: preset?.sources[name] };
}

/** The SI value of a parameter: null if it is unset, NaN if the core has not read its text. */
export function numberOf(name: string, design: Design, catalog: Catalog): number | null {
  const text = design.set[name];
  if (text === NONE) return null;
  if (text === undefined) return defaultOf(name, design, catalog).value;
  const unit = catalog.parameter(name, lawOf(design, catalog))?.unit ?? '';
  return valueOf(text, unit) ?? catalog.readValue(text, unit) ?? NaN;
}

/** Keeps the values, SI, that the core has read from the texts of a design. */
export function keepValues(
  values: ReadonlyMap<string, number>, design: Design, catalog: Catalog,
) {
  for (const [name, value] of values) {
    const text = design.set[name];
    const isNew = text !== undefined && Number.isNaN(numberOf(name, design, catalog));
    const unit = catalog.parameter(name, lawOf(design, catalog))?.unit ?? '';
    if (isNew) catalog.keepValue(text, unit, value);
  }
}

/** The design with these values. The value `undefined` restores the value of the preset. */
export function withValues(design: Design, values: Record<string, string | undefined>): Design {
  const set: Record<string, string> = { ...design.set };
  for (const [name, text] of Object.entries(values)) {
    if (text === undefined) delete set[name];
    else set[name] = text;
  }
  return { ...design, set };
}

/**
 * A default for the parameter without which `name` has no effect: speed and direction of the wind
 * need each other.
 */
export function together(name: string, design: Design): Record<string, string> {
  if (name === 'wind.speed' && design.set['wind.from'] === undefined) return { 'wind.from': '0 deg' };
  if (name === 'wind.from' && design.set['wind.speed'] === undefined) return { 'wind.speed': '0 mph' };
  return {};
}

/**
 * The changes that reset a parameter. If `wind.speed` stays, `wind.from` becomes 0, because a speed
 * needs a direction.
 */
export function resetOf(name: string, design: Design): Record<string, string | undefined> {
  if (name === 'wind.speed') return { 'wind.speed': undefined, 'wind.from': undefined };
  const hasSpeed = (design.set['wind.speed'] ?? NONE) !== NONE;
  if (name !== 'wind.from' || !hasSpeed) return { [name]: undefined };
  return together('wind.speed', withValues(design, { 'wind.from': undefined }));
}

/** The values that the program documents for unset parameters. */
export const WHEN_UNSET: Readonly<Record<string, number>> = {
  'wind.speed': 0,
  'wind.from': 0,
  'air.altitude': 0,
  'air.temperature': 298.15,
};
