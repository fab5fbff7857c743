// The outcome over two parameters, with contours, your drive and the optimum.
import { contours } from 'd3-contour';
import { useMemo } from 'preact/hooks';
import { hasLaunch, lawOf, withValues } from '../setup/design';
import { labelOf } from '../setup/parameters';
import { digits, fromSI, symbolOf, textOf, toSI } from '../setup/units';
import type { MapData } from '../state/map';
import { mapOf } from '../state/state';
import type { Explorer } from '../state/explorer';
import { usePage } from './context';
import { useSteady } from './steady';
import { Figure } from './Figure';
import { inLength, length, lengthUnit, ticks } from './lengths';
import { MARGIN } from './scale';
import { useWidth } from './size';

const HEIGHT = 300;
const LEVELS = 14;
/** The least distance of two labels, pixels. */
const LABEL = 30;
/** Space above for the name of the axis. */
const TOP = 28;

interface Plan {
  x: (value: number) => number;
  y: (value: number) => number;
  width: number;
}

function planOf({ ranges: [across, up] }: MapData, width: number): Plan {
  const wide = width - MARGIN.left - MARGIN.right;
  const tall = HEIGHT - TOP - MARGIN.bottom;
  return {
    x: (value) => MARGIN.left + ((value - across.low) / (across.high - across.low)) * wide,
    y: (value) => TOP + ((up.high - value) / (up.high - up.low)) * tall,
    width,
  };
}

export function MapView() {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const { ref, width } = useWidth();
  const map = explorer.map.value;
  const best = explorer.mapBest.value;
  const [across, up] = mapOf(explorer.state.value);
  const most = useMemo(() => (map ? Math.max(...map.values.filter(Number.isFinite)) : NaN), [map]);
  const bestText = best && map && best.names.every((name) => [map.across, map.up].includes(name))
    ? best.names.map((name) => `${labelOf(name)} ${explorer.shown(name, best.values[name] ?? NaN)}`
      + `${symbolOf(explorer.field(name).unit)}`).join(', ') : null;
  const sentence = map
    ? `The longest ${map.goal} over ${labelOf(across)} and ${labelOf(up)} is `
      + `${length(best?.flight[map.goal] ?? most, units)}${bestText ? `, at ${bestText}` : ''}.`
    : 'No map yet.';
  return (
    <Figure name="map" title="Map" sentence={sentence} place={ref} below={<Axes />}
      table={() => (map ? tableOf(map, units, explorer) : { head: [], rows: [] })}>
      {map && <Picture map={map} width={width} sentence={sentence} />}
    </Figure>
  );
}

function Picture({ map, width, sentence }: { map: MapData; width: number; sentence: string }) {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const plan = planOf(map, width);
  const areas = useMemo(() => contoursOf(map, units, planOf(map, width)), [map, units, width]);
  const best = explorer.mapBest.value;
  const at = (name: string) => explorer.value(name) ?? NaN;
  const [yours, theirs] = [
    [at(map.across), at(map.up)] as const,
    [best?.values[map.across] ?? NaN, best?.values[map.up] ?? NaN] as const,
  ];
  const move = (event: PointerEvent) => {
    const svg = event.currentTarget as SVGSVGElement;
    if (!svg.hasPointerCapture(event.pointerId)) return;
    const box = svg.getBoundingClientRect();
    const [wide, tall] = [width - MARGIN.left - MARGIN.right, HEIGHT - TOP - MARGIN.bottom];
    const parts = [
      (event.clientX - box.left - MARGIN.left) / wide,
      1 - (event.clientY - box.top - TOP) / tall,
    ];
    const values = [map.across, map.up].map((name, axis) => {
      const { low, high } = map.ranges[axis]!;
      const part = Math.min(1, Math.max(0, parts[axis]!));
      const { unit, decimals } = explorer.field(name);
      return [name, textOf(low + part * (high - low), unit, decimals)] as const;
    });
    explorer.changeDesign(withValues(explorer.design.value, Object.fromEntries(values)), false);
  };
  const take = (event: PointerEvent) => {
    (event.currentTarget as SVGSVGElement).setPointerCapture(event.pointerId);
    move(event);
  };
  return (
    <svg width={width} height={HEIGHT} role="img" aria-label={`Map. ${sentence}`}
      onPointerDown={take} onPointerMove={move} onPointerUp={() => explorer.release()}>
      {areas.map(({ level, path, label }, k) => (
        <path key={level} d={path} class="area" fill-opacity={0.1 + (0.75 * k) / LEVELS}>
          <title>{label}</title>
        </path>
      ))}
      {areas.map(({ level, spot, label }) => spot
        && <text class="level" key={level} x={spot[0]} y={spot[1]} text-anchor="middle">{label}</text>)}
      <MapScales map={map} plan={plan} />
      {theirs.every(Number.isFinite) && <Star x={plan.x(theirs[0])} y={plan.y(theirs[1])} />}
      {yours.every(Number.isFinite)
        && <circle class="on-map" cx={plan.x(yours[0])} cy={plan.y(yours[1])} r={6} />}
    </svg>
  );
}

const Star = ({ x, y }: { x: number; y: number }) => (
  <path class="ghost star" d={`M${x - 7},${y}H${x + 7}M${x},${y - 7}V${y + 7}`} />
);

function MapScales({ map, plan }: { map: MapData; plan: Plan }) {
  const { explorer } = usePage();
  const [across, up] = [map.across, map.up].map((name, axis) => {
    const { unit } = explorer.field(name);
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
          {digits(tick, Number.isInteger(tick) ? 0 : 1)}
        </text>
      ))}
      {up!.ticks.map((tick) => (
        <text class="tick" key={tick} x={MARGIN.left - 6} y={plan.y(toSI(tick, up!.unit)) + 4} text-anchor="end">
          {digits(tick, Number.isInteger(tick) ? 0 : 1)}
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
  /** The place of the label. */
  spot: readonly [number, number] | null;
}

function contoursOf(map: MapData, units: 'us' | 'metric', plan: Plan): Area[] {
  const { columns, rows } = map;
  const unit = lengthUnit(units);
  const values = Array.from(map.values, (value) => (Number.isFinite(value) ? value : -1));
  const landed = values.filter((value) => value >= 0);
  if (landed.length === 0) return [];
  const [low, high] = [Math.min(...landed), Math.max(...landed)];
  // the best part of the map has the closest contours
  const from = Math.max(low, high - 0.35 * high);
  const levels = ticks(fromSI(from, unit), fromSI(high, unit), LEVELS).map((level) => toSI(level, unit));
  const pixel = ([column, row]: readonly number[]) => {
    const [across, up] = map.ranges;
    const u = ((column ?? 0) - 0.5) / (columns - 1);
    const v = ((row ?? 0) - 0.5) / (rows - 1);
    const inside = (part: number) => Math.min(1, Math.max(0, part));
    return [
      plan.x(across.low + inside(u) * (across.high - across.low)),
      plan.y(up.low + inside(v) * (up.high - up.low)),
    ] as const;
  };
  const spots: (readonly [number, number])[] = [];
  return contours().size([columns, rows]).thresholds(levels)(values).map(({ value, coordinates }) => {
    const rings = coordinates.flat().map((ring) => ring.map(pixel));
    const path = rings.map((ring) =>
      `M${ring.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join('L')}Z`).join('');
    const place = spotOf(rings, plan);
    const isFree = place && spots.every(([x, y]) => Math.hypot(x - place[0], y - place[1]) > LABEL);
    if (isFree) spots.push(place);
    return { level: value, label: digits(fromSI(value, unit), 0), path, spot: isFree ? place : null };
  });
}

/** The lowest point of the longest ring that is inside of the picture. */
function spotOf(rings: readonly (readonly (readonly [number, number])[])[], plan: Plan) {
  const longest = rings.reduce<readonly (readonly [number, number])[]>(
    (best, ring) => (ring.length > best.length ? ring : best), []);
  const inner = longest.filter(([x, y]) => x > MARGIN.left + 20 && x < plan.width - MARGIN.right - 20
    && y > TOP + 14 && y < HEIGHT - MARGIN.bottom - 8);
  if (inner.length < 6) return null;
  return inner.reduce((lowest, point) => (point[1] > lowest[1] ? point : lowest));
}

/** Every twelfth or so value of the map. */
function tableOf(map: MapData, units: 'us' | 'metric', explorer: Explorer) {
  const every = Math.max(1, Math.round(map.columns / 6));
  const take = (count: number) => Array.from({ length: count }, (_, k) => k)
    .filter((k) => k % every === 0 || k === count - 1);
  const at = (name: string, axis: 0 | 1, k: number, count: number) => {
    const { low, high } = map.ranges[axis];
    const { unit } = explorer.field(name);
    return `${digits(fromSI(low + ((high - low) * k) / (count - 1), unit), 1)} ${symbolOf(unit)}`;
  };
  return {
    head: [`${map.goal} [${lengthUnit(units)}]`,
      ...take(map.columns).map((k) => at(map.across, 0, k, map.columns))],
    rows: take(map.rows).map((row) => [
      at(map.up, 1, row, map.rows),
      ...take(map.columns).map((column) =>
        digits(inLength(map.values[row * map.columns + column] ?? NaN, units), 1)),
    ]),
  };
}

/** The parameters that may be on an axis. */
function axisNames(explorer: Explorer): string[] {
  const design = explorer.design.value;
  const isLaunch = hasLaunch(design);
  const names = explorer.catalog.of(lawOf(design, explorer.catalog))
    .map(({ parameter }) => parameter)
    .filter((name) => {
      const value = explorer.value(name);
      const isOther = isLaunch ? /^(swing|club|strike|impact)\./.test(name) : name.startsWith('launch.');
      return value !== null && Number.isFinite(value) && !isOther;
    });
  return [...new Set([...mapOf(explorer.state.value), ...names])];
}

/** The two parameters of the map. */
function Axes() {
  const { explorer } = usePage();
  const { state, design } = explorer;
  const key = () => JSON.stringify(
    [design.value.preset, Object.keys(design.value.set), mapOf(state.value)]);
  // many options that seldom change
  const { axes, names } = useSteady(key, () => ({ axes: mapOf(state.value), names: axisNames(explorer) }));
  const select = (axis: 0 | 1, label: string) => (
    <label>
      {label}
      <select value={axes[axis]} onChange={(event) => {
        const name = event.currentTarget.value;
        const other = axes[1 - axis]!;
        const map: [string, string] = name === other ? [axes[1], axes[0]]
          : axis === 0 ? [name, other] : [other, name];
        explorer.change({ ...state.value, map });
      }}>
        {names.map((each) => <option value={each} key={each}>{labelOf(each)}</option>)}
      </select>
    </label>
  );
  return <p class="axes">{select(0, 'across')}{select(1, 'up')}</p>;
}
