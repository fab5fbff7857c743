// The outcome over two parameters, with contours, your drive and the optimum.
import { useComputed } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { isIdle, withValues } from '../setup/design';
import { labelOf } from '../setup/parameters';
import { digits, textOf, withUnit } from '../setup/units';
import type { Best } from '../state/best';
import type { MapData } from '../state/map';
import type { Explorer } from '../state/explorer';
import { usePage } from './context';
import { useSteady } from './steady';
import { Figure } from './Figure';
import { inLength, length, lengthUnit } from './lengths';
import { LoopLines, useLoop } from './LoopMap';
import { Areas, HEIGHT, MapScales, planOf, TOP } from './MapPicture';
import type { Grid } from './MapPicture';
import type { Plan } from './MapPicture';
import { MARGIN } from './scale';
import { useWidth } from './size';

export function MapView() {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const { ref, width } = useWidth();
  const map = explorer.map.last;
  const best = bestOf(map, explorer);
  const mark = useComputed(() =>
    explorer.map.mark.value || (bestOf(explorer.map.last, explorer) && explorer.mapBest.mark.value) || '');
  const most = useMemo(() => (map ? Math.max(...map.values.filter(Number.isFinite)) : NaN), [map]);
  const valuesOfBest = useComputed(() => {
    const { names = [], values = {} } = explorer.mapBest.last ?? {};
    return names.map((name) => {
      const value = withUnit(explorer.shown(name, values[name] ?? NaN), explorer.unit(name));
      return `${labelOf(name)} ${value}`;
    }).join(', ');
  }).value;
  const longest = map
    ? `The longest ${map.goal} over ${labelOf(map.across)} and ${labelOf(map.up)} is `
      + `${length(best?.flight[map.goal] ?? most, units)}${best ? `, at ${valuesOfBest}` : ''}.`
    : 'No map yet.';
  const refusal = explorer.map.isCurrent ? null : explorer.mapMessage.current;
  const sentence = refusal ?? longest;
  const outside = useComputed(() => outsideOf(explorer)).value;
  const over = useLoop(map);
  const said = [sentence, outside, over?.sentence].filter((text) => text).join(' ');
  return (
    <Figure name="map" title="Map" sentence={said} mark={mark} place={ref} below={<Axes />}
      table={() => (map ? tableOf(map, units, explorer) : { head: [], rows: [] })}>
      {map && <Picture map={map} width={width} sentence={said} loop={over?.loop ?? null} />}
    </Figure>
  );
}

/** A sentence if your drive is outside of the map; null otherwise. */
function outsideOf(explorer: Explorer): string | null {
  const map = explorer.map.last;
  if (!map) return null;
  const places = [map.across, map.up].flatMap((name, axis) => {
    const value = explorer.value(name) ?? NaN;
    const { low, high } = map.ranges[axis]!;
    return value < low || value > high
      ? [`${labelOf(name)} ${withUnit(explorer.shown(name, value), explorer.unit(name))}`] : [];
  });
  return places.length > 0 ? `Your drive is outside of the map: ${places.join(', ')}.` : null;
}

/** The best point over the map; null if it is of other parameters or of another goal. */
function bestOf(map: MapData | null, explorer: Explorer): Best | null {
  const best = explorer.mapBest.last;
  const isOfMap = best && map && best.goal === map.goal
    && best.names.every((name) => [map.across, map.up].includes(name));
  return isOfMap ? best : null;
}

interface PictureProps {
  map: MapData;
  width: number;
  sentence: string;
  loop: Grid | null;
}

function Picture({ map, width, sentence, loop }: PictureProps) {
  const { explorer } = usePage();
  const plan = planOf(map, width);
  const best = bestOf(map, explorer);
  const theirs = [
    plan.x(best?.values[map.across] ?? NaN), plan.y(best?.values[map.up] ?? NaN)] as const;
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
    <svg class={explorer.map.mark} width={width} height={HEIGHT}
      role="img" aria-label={`Map. ${sentence}`}
      onPointerDown={take} onPointerMove={move} onPointerUp={() => explorer.release()} onPointerCancel={() => explorer.release()}>
      <Areas map={map} width={width} />
      {loop && <LoopLines loop={loop} map={map} width={width} />}
      <MapScales map={map} plan={plan} />
      {theirs.every(Number.isFinite) && (
        <g class={explorer.mapBest.mark}><Star x={theirs[0]} y={theirs[1]} /></g>
      )}
      <Yours map={map} plan={plan} />
    </svg>
  );
}

/**
 * The point of your drive. It is a component of its own: a move of a slider moves it without
 * drawing the map.
 */
function Yours({ map, plan }: { map: MapData; plan: Plan }) {
  const { explorer } = usePage();
  const [across, up] = [map.across, map.up].map((name) => explorer.value(name) ?? NaN);
  const isInside = [across, up].every((value, axis) =>
    value! >= map.ranges[axis]!.low && value! <= map.ranges[axis]!.high);
  return isInside ? <circle class="on-map" cx={plan.x(across!)} cy={plan.y(up!)} r={6} /> : null;
}

const Star = ({ x, y }: { x: number; y: number }) => (
  <path class="ghost star" d={`M${x - 7},${y}H${x + 7}M${x},${y - 7}V${y + 7}`} />
);

/** The table of the map: some of its rows and columns. */
function tableOf(map: MapData, units: 'us' | 'metric', explorer: Explorer) {
  const every = Math.max(1, Math.round(map.columns / 6));
  const take = (count: number) => Array.from({ length: count }, (_, k) => k)
    .filter((k) => k % every === 0 || k === count - 1);
  const places = (name: string, axis: 0 | 1, count: number) => {
    const { low, high } = map.ranges[axis];
    const values = take(count).map((k) => low + ((high - low) * k) / (count - 1));
    const unit = explorer.unit(name);
    return explorer.distinct(name, values).map((number) => withUnit(number, unit));
  };
  const ups = places(map.up, 1, map.rows);
  return {
    head: [`${map.goal} [${lengthUnit(units)}]`, ...places(map.across, 0, map.columns)],
    rows: take(map.rows).map((row, k) => [
      ups[k]!,
      ...take(map.columns).map((column) =>
        digits(inLength(map.values[row * map.columns + column] ?? NaN, units), 1)),
    ]),
  };
}

/** The parameters that may be on an axis. */
function axisNames(explorer: Explorer): string[] {
  const { catalog } = explorer;
  const names = catalog.of(explorer.law.value)
    .map(({ parameter }) => parameter)
    .filter((name) => {
      const value = explorer.value(name);
      const isNumber = value !== null && Number.isFinite(value);
      return isNumber && !isIdle(name, explorer.design.value, catalog);
    });
  return [...new Set([...explorer.mapNames.value, ...names])];
}

/** The lists from which the two parameters of the map are chosen. */
function Axes() {
  const { explorer } = usePage();
  const { state } = explorer;
  // the lists are long and rarely change: make them again only if they do
  const { axes, names } = useSteady(
    () => ({ axes: explorer.mapNames.value, names: axisNames(explorer) }));
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
