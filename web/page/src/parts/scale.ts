// Plans of a picture: metres to pixels.
import type { Drive } from '../drive/drive';

/** Space around a picture for its scales, pixels. */
export const MARGIN = { left: 46, right: 18, top: 14, bottom: 34 };

/** The distance of a picture without a drive, m. */
const USUAL = 280;

/** The longest distance of the drives, m, rounded up so that the scale seldom changes. */
export function farthest(drives: readonly (Drive | null)[]): number {
  const ends = drives.map((drive) => {
    const { carry = 0, total = 0 } = drive?.outcomes ?? {};
    return Math.max(Number.isFinite(carry) ? carry : 0, Number.isFinite(total) ? total : 0);
  });
  const isEmpty = ends.every((end) => end === 0);
  return Math.ceil((Math.max(isEmpty ? USUAL : 50, ...ends) * 1.04) / 20) * 20;
}

/** The attribute `points` of a polyline. */
export const line = (points: readonly (readonly [number, number])[]) =>
  points.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ');
