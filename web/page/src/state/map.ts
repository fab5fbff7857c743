// The map: an outcome over two parameters.
import type { Call, Numbers } from '../core/messages';
import { lawOf } from '../setup/design';
import type { Travel } from '../setup/travel';
import { travelOf } from '../setup/travel';
import type { Explorer } from './explorer';
import type { Goal } from './state';
import { mapOf } from './state';

export interface MapData {
  across: string;
  up: string;
  /** The ranges of both, SI. */
  ranges: readonly [Travel, Travel];
  goal: Goal;
  columns: number;
  rows: number;
  /** Row by row from the lowest, m; NaN without a landing. */
  values: Float64Array;
}

/** The range of an axis does not follow the hand, so that the map stays while one drags in it. */
function rangeOf(explorer: Explorer, name: string): Travel {
  const law = lawOf(explorer.design.value, explorer.catalog);
  const parameter = explorer.catalog.parameter(name, law);
  if (!parameter) throw new Error(`no parameter ${name}`);
  return travelOf(parameter, explorer.presetValue(name), null);
}

/** A text that is another one where the map is another one. */
export function mapKey(explorer: Explorer): string {
  const { design, state } = explorer;
  const axes = mapOf(state.value);
  const rest = Object.entries(design.value.set).filter(([name]) => !axes.includes(name));
  return JSON.stringify([design.value.preset, axes, state.value.goal, rest]);
}

export function mapCall(explorer: Explorer, nodes: number): Call {
  const { goal, units } = explorer.state.value;
  const [across, up] = mapOf(explorer.state.value).map((name) => {
    const { low, high } = rangeOf(explorer, name);
    return { name, low, high };
  });
  const request = {
    setup: explorer.setup(), units, of: [goal], across, up, nodes: [nodes, nodes],
  };
  return { door: 'map', request };
}

export function readMap({ head, block }: Numbers, explorer: Explorer): MapData {
  const [across, up] = mapOf(explorer.state.value);
  return {
    across,
    up,
    ranges: [rangeOf(explorer, across), rangeOf(explorer, up)],
    goal: explorer.state.value.goal,
    columns: Number(head.columns),
    rows: Number(head.rows),
    values: block,
  };
}
