// One drive: outcomes, path and roll, read from the numbers of the core.
import type { Numbers } from '../core/messages';

export interface PathPoint {
  time: number;
  height: number;
  right: number;
  downrange: number;
}

export interface Drive {
  status: string;
  message: string | null;
  outcomes: Readonly<Record<string, number>>;
  path: readonly PathPoint[];
  roll: readonly PathPoint[];
  warnings: readonly string[];
}

/** The drive if its ball lands; null otherwise. */
export const landedOf = (drive: Drive | null) => (drive?.status === 'landed' ? drive : null);

/** A warning without its numbers, which differ between two drives. */
const wordsOf = (warning: string) => warning.replace(/[-\u2212]?\b\d+(\.\d+)?/g, '#');

/**
 * The warnings of a drive that another drive does not have. Warnings that differ only in their
 * numbers count as the same.
 */
export function ownWarnings(drive: Drive | null, other: Drive | null): string[] {
  const others = (other?.warnings ?? []).map(wordsOf);
  return (drive?.warnings ?? []).filter((warning) => !others.includes(wordsOf(warning)));
}

/** The answer of the core if there are no numbers: its message, and the parameters at fault. */
export interface Refusal {
  message: string;
  parameters: readonly string[];
}

export const isRefused = ({ head }: Numbers) => !Array.isArray(head.outcomes) && head.status !== 'done';

export const refusalOf = ({ head }: Numbers): Refusal => ({
  message: head.message ?? head.status,
  parameters: head.parameters ?? [],
});

interface DriveHead {
  outcomes: string[];
  of: string[];
  wrt: string[];
  path?: number;
  run?: number;
  stated?: string[];
  warnings?: string[];
}

export function readDrive({ head, block }: Numbers): Drive {
  const read = head as unknown as DriveHead;
  // the path follows the outcomes, and the first and second derivatives
  let at = read.outcomes.length + 2 * read.of.length * read.wrt.length;
  const number = () => block[at++] ?? NaN;
  const path = Array.from({ length: read.path ?? 0 }, () => (
    { time: number(), height: number(), right: number(), downrange: number() }));
  const roll = Array.from({ length: read.run ?? 0 }, () => (
    { time: NaN, height: number(), right: number(), downrange: number() }));
  return {
    status: head.status,
    message: head.message ?? null,
    outcomes: Object.fromEntries(read.outcomes.map((name, k) => [name, block[k] ?? NaN])),
    path,
    roll,
    warnings: read.warnings ?? [],
  };
}

/**
 * The values, SI, of the texts of the setup, by the name of the parameter. A refused drive also has
 * the values of the texts that can be read.
 */
export function readStated({ head, block }: Numbers): Map<string, number> {
  const { stated = [] } = head as unknown as DriveHead;
  const begin = block.length - stated.length;
  return new Map(stated.map((name, k) => [name, block[begin + k] ?? NaN]));
}

/** First and second derivative of an outcome by one parameter, SI. */
export interface Slope {
  first: number;
  second: number;
}

interface Missing {
  of: string | null;
  wrt: string | null;
  message: string;
}

/** The reasons why outcomes have no derivative by a parameter, by the name of the parameter. */
export function readMissing({ head }: Numbers): Map<string, string> {
  const { missing } = head as unknown as { missing: Missing[] };
  return new Map(missing.flatMap(({ wrt, message }) => (wrt === null ? [] : [[wrt, message] as const])));
}

/**
 * First and second derivatives of the first outcome of `of`, by the name of the parameter.
 * Parameters without a derivative are left out.
 */
export function readSlopes({ head, block }: Numbers): Map<string, Slope> {
  const { outcomes, wrt } = head as unknown as DriveHead;
  const n = wrt.length;
  const begin = outcomes.length;
  const slopes = wrt.map((name, k) => [name, {
    first: block[begin + k] ?? NaN,
    second: block[begin + n + k] ?? NaN,
  }] as const);
  return new Map(slopes.filter(([, { first }]) => Number.isFinite(first)));
}
