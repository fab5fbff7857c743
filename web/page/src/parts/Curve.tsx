// The path of a drive and its roll.
import { useMemo } from 'preact/hooks';
import type { Drive } from '../drive/drive';
import { line } from './scale';

interface Props {
  drive: Drive;
  name: string;
  /** The coordinate that is drawn vertically; the horizontal coordinate is the distance. */
  axis: 'height' | 'right';
  x: (metres: number) => number;
  y: (metres: number) => number;
  /** A key that changes whenever `x` or `y` changes. */
  scale: string;
}

export function Curve({ drive, name, axis, x, y, scale }: Props) {
  const [path, roll] = useMemo(() => [drive.path, drive.roll].map((points) =>
    line(points.map((point) => [x(point.downrange), y(point[axis])]))), [drive, scale]);
  return (
    <>
      <polyline class={name} points={path} />
      <polyline class={`${name} roll`} points={roll} />
    </>
  );
}
