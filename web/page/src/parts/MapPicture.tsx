// Parts of all pictures over two parameters: the plan, areas between contours, lines and scales.
import { contours } from 'd3-contour';
import { useMemo } from 'preact/hooks';
import { labelOf } from '../setup/parameters';
import { digits, fromSI, symbolOf, toSI } from '../setup/units';
import type { System } from '../setup/units';
import type { MapData } from '../state/map';
import { usePage } from './context';
import { lengthUnit, ticks, tickText } from './lengths';
import { MARGIN } from './scale';

export const HEIGHT = 300;
const LEVELS = 14;
/** The smallest distance between two labels, pixels. */
const LABEL = 30;
/** Space above the map for the name of its vertical axis, pixels. */
export const TOP = 28;

export interface Plan {
  x: (value: number) => number;
  y: (value: number) => number;
  width: number;
}

export function planOf({ ranges: [across, up] }: MapData, width: number): Plan {
  const wide = width - MARGIN.left - MARGIN.right;
  const tall = HEIGHT - TOP - MARGIN.bottom;
  return {
    x: (value) => MARGIN.left + ((value - across.low) / (across.high - across.low)) * wide,
    y: (value) => TOP + ((up.high - value) / (up.high - up.low)) * tall,
    width,
  };
}

export function MapScales({ map, plan }: { map: MapData; plan: Plan }) {
  const { explorer } = usePage();
  const [across, up] = [map.across, map.up].map((name, axis) => {
    const unit = explorer.unit(name);
    const { low, high } = map.ranges[axis]!;
    const count = axis === 0 ? plan.width / 80 : 5;
    const symbol = symbolOf(unit);
    return {
      unit,
      ticks: ticks(fromSI(low, unit), fromSI(high, unit), count),
      text: `${labelOf(name)}${symbol ? ` [${symbol}]` : ''}`,
    };
  });
  return (
    <>
      {across!.ticks.map((tick) => (
        <text class="tick" key={tick} x={plan.x(toSI(tick, across!.unit))} y={HEIGHT - 20} text-anchor="middle">
          {tickText(tick)}
        </text>
      ))}
      {up!.ticks.map((tick) => (
        <text class="tick" key={tick} x={MARGIN.left - 6} y={plan.y(toSI(tick, up!.unit)) + 4} text-anchor="end">
          {tickText(tick)}
        </text>
      ))}
      <text class="tick" x={plan.width - MARGIN.right} y={HEIGHT - 4} text-anchor="end">{across!.text}</text>
      <text class="tick" x={4} y={14}>{up!.text}</text>
    </>
  );
}

interface Area {
  level: number;
  label: string;
  path: string;
  /** The position of the label; null if there is no room for it. */
  spot: readonly [number, number] | null;
}

/** Values at the nodes, row by row from the lowest row; NaN at a node without a value. */
export interface Grid {
  columns: number;
  rows: number;
  values: ArrayLike<number>;
}

/** Converts positions in the grid to pixels. In d3-contour, node k is at k + 0.5. */
function pixelOf({ columns, rows }: Grid, { ranges: [across, up] }: MapData, plan: Plan) {
  const inside = (part: number) => Math.min(1, Math.max(0, part));
  return ([column, row]: readonly number[]) => {
    const u = ((column ?? 0) - 0.5) / (columns - 1);
    const v = ((row ?? 0) - 0.5) / (rows - 1);
    return [
      plan.x(across.low + inside(u) * (across.high - across.low)),
      plan.y(up.low + inside(v) * (up.high - up.low)),
    ] as const;
  };
}

/** The levels of the contours, SI. Only the best part of the map has contours. */
export function levelsOf(map: MapData, units: System): number[] {
  const unit = lengthUnit(units);
  const landed = map.values.filter(Number.isFinite);
  if (landed.length === 0) return [];
  const [low, high] = [Math.min(...landed), Math.max(...landed)];
  const from = Math.max(low, high - 0.35 * high);
  return ticks(fromSI(from, unit), fromSI(high, unit), LEVELS).map((level) => toSI(level, unit));
}

/** A number for drives that do not land, below every level. */
const NONE = -1;

const ringsOf = ({ columns, rows, values }: Grid, levels: number[]) =>
  contours().size([columns, rows]).thresholds(levels)(
    Array.from(values, (value) => (Number.isFinite(value) ? value : NONE)));

function contoursOf(map: MapData, units: System, plan: Plan): Area[] {
  const unit = lengthUnit(units);
  const pixel = pixelOf(map, map, plan);
  const spots: (readonly [number, number])[] = [];
  return ringsOf(map, levelsOf(map, units)).map(({ value, coordinates }) => {
    const rings = coordinates.flat().map((ring) => ring.map(pixel));
    const path = rings.map((ring) =>
      `M${ring.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join('L')}Z`).join('');
    const place = spotOf(rings, plan);
    const isFree = place && spots.every(([x, y]) => Math.hypot(x - place[0], y - place[1]) > LABEL);
    if (isFree) spots.push(place);
    return { level: value, label: digits(fromSI(value, unit), 0), path, spot: isFree ? place : null };
  });
}

/** Contours of a grid over the two parameters of a map, as lines without the edge of the map. */
export function linesOf(grid: Grid, levels: number[], map: MapData, plan: Plan): string {
  const { columns, rows } = grid;
  const pixel = pixelOf(grid, map, plan);
  const edges = ([column = 0, row = 0]: readonly number[]) =>
    [column <= 0.5, column >= columns - 0.5, row <= 0.5, row >= rows - 0.5];
  const isAlongEdge = (from: readonly number[], to: readonly number[]) =>
    edges(from).some((isOn, side) => isOn && edges(to)[side]);
  const path: string[] = [];
  for (const ring of ringsOf(grid, levels).flatMap(({ coordinates }) => coordinates.flat())) {
    ring.forEach((point, k) => {
      const before = ring[k - 1];
      const [x, y] = pixel(point);
      path.push(`${!before || isAlongEdge(before, point) ? 'M' : 'L'}${x.toFixed(1)},${y.toFixed(1)}`);
    });
  }
  return path.join('');
}

interface AreasProps {
  map: MapData;
  width: number;
}

/** The areas between contours, with the levels written on them. */
export function Areas({ map, width }: AreasProps) {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const areas = useMemo(() => contoursOf(map, units, planOf(map, width)), [map, units, width]);
  return (
    <>
      {areas.map(({ level, path, label }, k) => (
        <path key={level} d={path} class="area" fill-opacity={0.1 + (0.75 * k) / LEVELS}>
          <title>{label}</title>
        </path>
      ))}
      {areas.map(({ level, spot, label }) => spot
        && <text class="level" key={level} x={spot[0]} y={spot[1]} text-anchor="middle">{label}</text>)}
    </>
  );
}

/**
 * The position of a label: the lowest point of the longest ring. Only points away from the edges of
 * the picture count; null if there are few.
 */
function spotOf(rings: readonly (readonly (readonly [number, number])[])[], plan: Plan) {
  const longest = rings.reduce<readonly (readonly [number, number])[]>(
    (best, ring) => (ring.length > best.length ? ring : best), []);
  const inner = longest.filter(([x, y]) => x > MARGIN.left + 20 && x < plan.width - MARGIN.right - 20
    && y > TOP + 14 && y < HEIGHT - MARGIN.bottom - 8);
  if (inner.length < 6) return null;
  return inner.reduce((lowest, point) => (point[1] > lowest[1] ? point : lowest));
}

