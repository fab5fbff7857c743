// Contours of the loop's carry over the map of the exact carry.
import { useMemo } from 'preact/hooks';
import { isRefused } from '../drive/drive';
import { digits } from '../setup/units';
import type { Explorer } from '../state/explorer';
import { loopMapCalls, readLoop, worstOf } from '../state/loop';
import type { MapData } from '../state/map';
import { mapKey } from '../state/map';
import { useAnswer } from './answered';
import { usePage } from './context';
import { inLength, lengthUnit } from './lengths';
import { levelsOf, linesOf, planOf } from './MapPicture';
import type { Grid } from './MapPicture';

/** Nodes along a side of the map: first a coarse map is computed, then a fine one. */
const COARSE = 16;
const FINE = 48;

interface LoopMap extends Grid {
  /** The largest distance between the carry of the loop and the exact carry, m. */
  worst: number;
}

async function fly(explorer: Explorer, map: MapData, nodes: number, step: number): Promise<LoopMap | null | undefined> {
  const calls = loopMapCalls(map, explorer.requestBase(), nodes, step);
  const answers = await explorer.background.calls(`loop map ${nodes}`, calls);
  if (!answers) return undefined;
  if (answers.some(isRefused)) return null;
  const rows = answers.map(readLoop);
  const values = rows.flatMap(({ loop }) => [...loop]);
  return { columns: nodes, rows: nodes, values, worst: Math.max(...rows.map(worstOf)) };
}

/** Contours of the loop, and a sentence about them; null if the loop is not drawn over the map. */
export function useLoop(map: MapData | null) {
  const { explorer } = usePage();
  const step = explorer.loopStep.value;
  const isOver = map !== null && step !== null && map.goal === 'carry';
  const key = isOver ? `${step} ${mapKey(explorer.design.value, map)}` : '';
  const ask = (nodes: number) => async () => (isOver ? fly(explorer, map, nodes, step) : null);
  const [coarse, fine] = [useAnswer(key, 150, ask(COARSE)), useAnswer(key, 150, ask(FINE))];
  const loop = [fine, coarse].find(({ isCurrent, answer }) => isCurrent && answer)?.answer;
  if (!isOver || !loop) return null;
  const units = explorer.units.value;
  const sentence = `Dashed: the loop of ${digits(step * 1000, 0)} ms, at the same levels, up to `
    + `${digits(inLength(loop.worst, units), 1)} ${lengthUnit(units)} from the exact carry.`;
  return { loop, sentence };
}

interface Props {
  loop: Grid;
  map: MapData;
  width: number;
}

export function LoopLines({ loop, map, width }: Props) {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const path = useMemo(() => linesOf(loop, levelsOf(map, units), map, planOf(map, width)), [loop, map, units, width]);
  return (
    <>
      <path class="loop" d={path} data-nodes={loop.columns} />
      <g class="legend">
        <line class="loop" x1={width - 160} x2={width - 136} y1={10} y2={10} />
        <text class="tick" x={width - 132} y={14}>loop of time steps</text>
      </g>
    </>
  );
}
