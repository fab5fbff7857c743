// The flight from the side, at true scale.
import { useMemo } from 'preact/hooks';
import type { Drive } from '../drive/drive';
import { landedOf } from '../drive/drive';
import { fromSI, toSI } from '../setup/units';
import { usePage } from './context';
import { Figure } from './Figure';
import { inLength, length, lengthUnit, ticks } from './lengths';
import { Curve } from './Curve';
import { farthest, MARGIN } from './scale';
import { useWidth } from './size';

const LEAST_HEIGHT = 30;

export function SideView() {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const { ref, width } = useWidth();
  const flown = explorer.drive.last;
  const drive = landedOf(flown);
  const ghost = explorer.ghost.last;
  const { driveMark } = explorer;
  const all = [drive, ghost];
  const distance = farthest(all);
  const scale = (width - MARGIN.left - MARGIN.right) / distance;
  const heights = all.flatMap((each) => each?.path.map(({ height }) => height) ?? []);
  // round up to steps, so that the picture seldom changes its height
  const top = Math.ceil(Math.max(LEAST_HEIGHT, ...heights) / 10 + 0.3) * 10;
  const bottom = Math.min(0, ...heights);
  const height = (top - bottom) * scale + MARGIN.top + MARGIN.bottom;
  const x = (downrange: number) => MARGIN.left + downrange * scale;
  const y = (up: number) => MARGIN.top + (top - up) * scale;
  const plan = `${scale} ${top}`;
  const ground = drive?.path.at(-1)?.height ?? 0;
  const unit = lengthUnit(units);
  const { apex_height, descent_angle, flight_time, carry } = drive?.outcomes ?? {};
  const sentence = drive
    ? `The ball rises to ${length(apex_height, units)} and lands after ${(flight_time ?? NaN).toFixed(1)} s `
      + `at ${length(carry, units)}, at ${fromSI(descent_angle ?? NaN, 'deg').toFixed(1)}° to the ground.`
    : flown?.message ?? 'No drive yet.';
  // compute the scales only when they change: most moves of a slider do not change them
  const scales = useMemo(() => (
    <>
      {ticks(0, inLength(distance, units), Math.max(3, width / 110)).map((tick) => (
        <g key={tick}>
          <line class="grid" x1={x(toSI(tick, unit))} x2={x(toSI(tick, unit))} y1={MARGIN.top} y2={y(bottom)} />
          <text class="tick" x={x(toSI(tick, unit))} y={height - 14} text-anchor="middle">{tick}</text>
        </g>
      ))}
      {ticks(inLength(bottom, units), inLength(top, units), 2).map((tick) => (
        <g key={tick}>
          <line class="grid" x1={x(0)} x2={x(distance)} y1={y(toSI(tick, unit))} y2={y(toSI(tick, unit))} />
          <text class="tick" x={MARGIN.left - 6} y={y(toSI(tick, unit)) + 4} text-anchor="end">{tick}</text>
        </g>
      ))}
      <text class="tick" x={4} y={MARGIN.top + 2}>{unit}</text>
    </>
  ), [width, distance, top, bottom, units]);
  return (
    <Figure name="side" title="Side view" sentence={sentence} mark={driveMark} table={() => pathTable(drive, unit)} place={ref}>
      <svg class={driveMark} width={width} height={height} role="img" aria-label={`Side view. ${sentence}`}>
        {scales}
        <line class="ground" x1={x(0)} x2={x(distance)} y1={y(ground)} y2={y(ground)} />
        <g class={explorer.ghost.mark}>
          {ghost && <Curve drive={ghost} name="ghost" axis="height" x={x} y={y} scale={plan} />}
          <Landed drive={ghost} x={x} y={y} name="ghost" />
        </g>
        {drive && <Curve drive={drive} name="yours" axis="height" x={x} y={y} scale={plan} />}
        <Landed drive={drive} x={x} y={y} name="yours" />
      </svg>
    </Figure>
  );
}

interface LandedProps {
  drive: Drive | null;
  x: (downrange: number) => number;
  y: (up: number) => number;
  name: string;
}

function Landed({ drive, x, y, name }: LandedProps) {
  const end = drive?.path.at(-1);
  return end ? <circle class={name} cx={x(end.downrange)} cy={y(end.height)} r={4} /> : null;
}

/** About twenty points of the path. */
export function pathTable(drive: Drive | null, unit: string) {
  const points = drive?.path ?? [];
  const every = Math.max(1, Math.floor(points.length / 20));
  const some = points.filter((_, at) => at % every === 0 || at === points.length - 1);
  const text = (metres: number) => fromSI(metres, unit).toFixed(1);
  return {
    head: ['time [s]', `downrange [${unit}]`, `height [${unit}]`, `right [${unit}]`],
    rows: some.map(({ time, downrange, height, right }) =>
      [time.toFixed(2), text(downrange), text(height), text(right)]),
  };
}
