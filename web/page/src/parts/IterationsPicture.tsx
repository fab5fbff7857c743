// One iteration of the optimizer: the iterate, the model of the outcome, the trust region, the step.
import { useMemo } from 'preact/hooks';
import { labelOf } from '../setup/parameters';
import type { SliderRange } from '../setup/slider';
import { fromSI, symbolOf, toSI } from '../setup/units';
import { isRefused } from '../drive/drive';
import type { Explorer } from '../state/explorer';
import type { MapAxes, MapData } from '../state/map';
import { mapCall, mapKey, readMap } from '../state/map';
import type { Iteration, Iterations } from '../state/iterations';
import { modelAt } from '../state/iterations';
import { useAnswer } from './answered';
import { ChartScales } from './ChartScales';
import { usePage } from './context';
import { inLength, lengthUnit, ticks, tickText } from './lengths';
import { Areas, HEIGHT, levelsOf, linesOf, MapScales, planOf, TOP } from './MapPicture';
import type { Plan } from './MapPicture';
import { line, MARGIN } from './scale';

/** Nodes of the map along a side, and nodes of a curve. */
const NODES = 40;
const CURVE = 121;

interface Props {
  iterations: Iterations;
  at: number;
  width: number;
  sentence: string;
  /** The class of the picture: 'stale' if the iterations are about an earlier drive. */
  mark: string;
}

export function IterationsPicture(props: Props) {
  const { explorer } = usePage();
  const { names } = props.iterations;
  const axes = axesOf(props.iterations, explorer);
  const isCurve = names.length === 1;
  const design = explorer.design.value;
  const { answer: map, mark } = useAnswer(`${mapKey(design, axes)} ${JSON.stringify([names, design.set[axes.up]])}`, 0, async () => {
    const nodes = isCurve ? [CURVE, 2] as const : [NODES, NODES] as const;
    const call = mapCall(axes, explorer.requestBase(), nodes);
    const numbers = await explorer.background.call('iterations map', call);
    if (!numbers) return undefined;
    return isRefused(numbers) ? null : readMap(numbers, axes);
  });
  // after a change of the parameters, `map` is still the map of the earlier ones: wait for the new
  // map
  if (!map || map.across !== axes.across || (!isCurve && map.up !== axes.up)) return null;
  return (
    <div class={mark || props.mark}>
      {isCurve ? <CurvePicture {...props} map={map} /> : <PlanePicture {...props} map={map} />}
    </div>
  );
}

/**
 * The axes of the picture: the parameters that the search varies if they are one or two, else the
 * parameters of the map.
 */
function axesOf({ goal, names, ranges }: Iterations, explorer: Explorer): MapAxes {
  const ofMap = explorer.mapNames.value;
  if (names.length === 1) {
    // draw a curve as a map whose second axis has a single value: the axis of a parameter that
    // every setup has
    const up = names[0] === 'gravity' ? 'ball.mass' : 'gravity';
    const value = explorer.value(up) ?? NaN;
    return { across: names[0]!, up, ranges: [ranges[0]!, { low: value, high: value, step: 0 }], goal };
  }
  const [across, up] = names.length === 2 ? names as [string, string] : ofMap;
  const range = (name: string): SliderRange => ranges[names.indexOf(name)] ?? explorer.sliderRange(name);
  return { across, up, ranges: [range(across), range(up)], goal };
}

/**
 * The coordinate of a point of the search on an axis. If the search does not vary the parameter, it
 * is the value of your drive.
 */
function coordinate(x: ArrayLike<number>, { names }: Iterations, name: string, explorer: Explorer): number {
  const varied = names.indexOf(name);
  return varied < 0 ? explorer.value(name) ?? NaN : x[varied] ?? NaN;
}

/**
 * The ends of the trust region on an axis; those of the axis if the search does not vary its
 * parameter.
 */
function region(iteration: Iteration, { names }: Iterations, name: string, { low, high }: SliderRange): [number, number] {
  const varied = names.indexOf(name);
  return varied < 0 ? [low, high] : [iteration.low[varied] ?? low, iteration.high[varied] ?? high];
}

function PlanePicture({ iterations, at, width, sentence, map }: Props & { map: MapData }) {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const plan = planOf(map, width);
  const iteration = iterations.list[at]!;
  const model = useMemo(
    () => modelLines(iteration, iterations, map, planOf(map, width), levelsOf(map, units)),
    [iteration, map, width, units],
  );
  const pixel = (x: ArrayLike<number>) => [
    plan.x(coordinate(x, iterations, map.across, explorer)),
    plan.y(coordinate(x, iterations, map.up, explorer)),
  ] as const;
  const [left, right] = region(iteration, iterations, map.across, map.ranges[0]).map(plan.x) as [number, number];
  const [bottom, top] = region(iteration, iterations, map.up, map.ranges[1]).map(plan.y) as [number, number];
  const way = iterations.list.slice(0, at + 1).filter(({ search }) => search === iteration.search).map(({ x }) => pixel(x));
  const here = pixel(iteration.x);
  const to = iteration.trial && pixel(iteration.trial.x);
  return (
    <svg width={width} height={HEIGHT} role="img" aria-label={`Optimizer. ${sentence}`}>
      <Areas map={map} width={width} />
      <path class="model" d={model} />
      <rect class="region" x={left} y={top} width={right - left} height={bottom - top} />
      <ActiveBounds iteration={iteration} iterations={iterations} map={map} plan={plan} />
      <polyline class="way" points={line(way)} />
      {way.slice(0, -1).map(([x, y], k) => <circle class="before" key={k} cx={x} cy={y} r={3} />)}
      {to && <TrialMark from={here} to={to} isAccepted={iteration.trial!.isAccepted} />}
      <circle class="on-map" cx={here[0]} cy={here[1]} r={6} />
      <MapScales map={map} plan={plan} />
      <Legend width={width} />
    </svg>
  );
}

/** Contours of the quadratic model. Parameters without an axis keep the values of the iteration. */
function modelLines(iteration: Iteration, { names }: Iterations, map: MapData, plan: Plan, levels: number[]): string {
  const [across, up] = [map.across, map.up].map((name) => names.indexOf(name)) as [number, number];
  const values = Array.from({ length: NODES * NODES }, (_, node) => {
    const part = [node % NODES, Math.floor(node / NODES)].map((k) => k / (NODES - 1)) as [number, number];
    const x = iteration.x.slice();
    [across, up].forEach((varied, axis) => {
      const { low, high } = map.ranges[axis as 0 | 1];
      if (varied >= 0) x[varied] = low + part[axis as 0 | 1] * (high - low);
    });
    return modelAt(iteration, x);
  });
  return linesOf({ columns: NODES, rows: NODES, values }, levels, map, plan);
}

interface BoundsProps {
  iteration: Iteration;
  iterations: Iterations;
  map: MapData;
  plan: Plan;
}

/** A bar at each bound that the iterate has reached. */
function ActiveBounds({ iteration, iterations, map, plan }: BoundsProps) {
  const [left, right] = [map.ranges[0].low, map.ranges[0].high].map(plan.x) as [number, number];
  const [bottom, top] = [map.ranges[1].low, map.ranges[1].high].map(plan.y) as [number, number];
  const side = (name: string) => iteration.bounds[iterations.names.indexOf(name)] ?? 0;
  const [across, up] = [side(map.across), side(map.up)];
  const x = across < 0 ? left : right;
  const y = up < 0 ? bottom : top;
  return (
    <>
      {across !== 0 && <line class="bound" x1={x} x2={x} y1={top} y2={bottom} />}
      {up !== 0 && <line class="bound" x1={left} x2={right} y1={y} y2={y} />}
    </>
  );
}

interface TrialProps {
  from: readonly [number, number];
  to: readonly [number, number];
  isAccepted: boolean;
}

const TrialMark = ({ from, to: [x, y], isAccepted }: TrialProps) => (
  <>
    <line class={isAccepted ? 'trial' : 'trial refused'} x1={from[0]} y1={from[1]} x2={x} y2={y} />
    <path class="ghost star" d={isAccepted ? `M${x - 6},${y}H${x + 6}M${x},${y - 6}V${y + 6}`
      : `M${x - 5},${y - 5}L${x + 5},${y + 5}M${x - 5},${y + 5}L${x + 5},${y - 5}`} />
  </>
);

const Legend = ({ width }: { width: number }) => (
  <g class="legend">
    <line class="model" x1={width - 236} x2={width - 212} y1={10} y2={10} />
    <text class="tick" x={width - 208} y={14}>model</text>
    <line class="region" x1={width - 160} x2={width - 136} y1={10} y2={10} />
    <text class="tick" x={width - 132} y={14}>trust region</text>
  </g>
);

/** Space above and below the curve, as a fraction of its height. */
const ROOM = 0.15;

function CurvePicture({ iterations, at, width, sentence, map }: Props & { map: MapData }) {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const [iteration, name] = [iterations.list[at]!, iterations.names[0]!];
  const { unit } = explorer.field(name);
  const { low, high } = map.ranges[0];
  const values = map.values.subarray(0, map.columns);
  const known = values.filter(Number.isFinite);
  if (known.length === 0) return null;
  const [least, most] = [Math.min(...known), Math.max(...known)];
  const room = ROOM * (most - least || 1);
  const [bottom, top] = [least - room, most + room];
  const x = (value: number) => MARGIN.left + ((value - low) / (high - low)) * (width - MARGIN.left - MARGIN.right);
  const y = (value: number) => TOP + ((top - value) / (top - bottom)) * (HEIGHT - TOP - MARGIN.bottom);
  const places = Array.from({ length: map.columns }, (_, k) => low + ((high - low) * k) / (map.columns - 1));
  const exact = places.flatMap((place, k) => (Number.isFinite(values[k]) ? [[x(place), y(values[k]!)] as const] : []));
  const model = places.map((place) => [place, modelAt(iteration, [place])] as const)
    .filter(([, value]) => value >= bottom && value <= top)
    .map(([place, value]) => [x(place), y(value)] as const);
  const [left, right] = [x(iteration.low[0]!), x(iteration.high[0]!)];
  const bound = iteration.bounds[0] ?? 0;
  const end = x(bound < 0 ? low : high);
  const { trial } = iteration;
  const length = lengthUnit(units);
  const symbol = symbolOf(unit);
  return (
    <svg width={width} height={HEIGHT} role="img" aria-label={`Optimizer. ${sentence}`}>
      <rect class="region" x={left} y={TOP} width={right - left} height={HEIGHT - TOP - MARGIN.bottom} />
      <ChartScales width={width} bottom={HEIGHT - 20}
        across={{ ticks: ticks(fromSI(low, unit), fromSI(high, unit), width / 110), place: (tick) => x(toSI(tick, unit)), text: tickText }}
        up={{ ticks: ticks(inLength(bottom, units), inLength(top, units), 4), place: (tick) => y(toSI(tick, length)), text: String }} />
      <text class="tick" x={width - MARGIN.right} y={HEIGHT - 4} text-anchor="end">{labelOf(name)}{symbol ? ` [${symbol}]` : ''}</text>
      <text class="tick" x={4} y={14}>{map.goal} [{length}]</text>
      <polyline class="yours" points={line(exact)} />
      <polyline class="model" points={line(model)} />
      {bound !== 0 && <line class="bound" x1={end} x2={end} y1={TOP} y2={HEIGHT - MARGIN.bottom} />}
      {iterations.list.slice(0, at).filter(({ search }) => search === iteration.search).map((before) => (
        <circle class="before" key={before.number} cx={x(before.x[0]!)} cy={y(before.value)} r={3} />
      ))}
      {trial && (
        <TrialMark from={[x(iteration.x[0]!), y(iteration.value)]} isAccepted={trial.isAccepted}
          to={[x(trial.x[0]!), y(Math.min(top, Math.max(bottom, iteration.value + trial.predicted)))]} />
      )}
      <circle class="on-map" cx={x(iteration.x[0]!)} cy={y(iteration.value)} r={6} />
      <Legend width={width} />
    </svg>
  );
}
