// The scales of a curve: numbers along the horizontal axis, and lines with numbers along the
// vertical axis.
import { MARGIN } from './scale';

interface Scale {
  ticks: readonly number[];
  /** The coordinate of a tick, pixels. */
  place: (tick: number) => number;
  text: (tick: number) => string;
}

interface Props {
  across: Scale;
  up: Scale;
  width: number;
  /** The y coordinate of the numbers below the curve, pixels. */
  bottom: number;
}

export function ChartScales({ across, up, width, bottom }: Props) {
  return (
    <>
      {across.ticks.map((tick) => (
        <text class="tick" key={tick} x={across.place(tick)} y={bottom} text-anchor="middle">{across.text(tick)}</text>
      ))}
      {up.ticks.map((tick) => (
        <g key={tick}>
          <line class="grid" x1={MARGIN.left} x2={width - MARGIN.right} y1={up.place(tick)} y2={up.place(tick)} />
          <text class="tick" x={MARGIN.left - 6} y={up.place(tick) + 4} text-anchor="end">{up.text(tick)}</text>
        </g>
      ))}
    </>
  );
}
