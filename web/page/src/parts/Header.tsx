// Preset, units, goal, undo and redo.
import { useComputed } from '@preact/signals';
import type { Goal } from '../state/state';
import { GOALS } from '../state/state';
import type { System } from '../setup/units';
import { usePage } from './context';

const SYSTEMS: readonly (readonly [System, string])[] = [['us', 'yards, mph'], ['metric', 'metres, m/s']];

export function Header() {
  const { explorer, address } = usePage();
  const preset = useComputed(() => explorer.design.value.preset).value;
  const goal = explorer.goal.value;
  const units = explorer.units.value;
  return (
    <header>
      <h1>longdrive</h1>
      <label>
        <span>preset</span>
        <select value={preset} title={explorer.catalog.preset(preset)?.about}
          onChange={(event) => explorer.changeDesign({ preset: event.currentTarget.value, set: {} })}>
          {explorer.catalog.presets.map(({ name }) => <option value={name} key={name}>{name}</option>)}
        </select>
      </label>
      <label>
        <span>longest</span>
        <select value={goal}
          onChange={(event) => explorer.change({ ...explorer.state.value, goal: event.currentTarget.value as Goal })}>
          {GOALS.map((name) => <option value={name} key={name}>{name}</option>)}
        </select>
      </label>
      <label>
        <span>units</span>
        <select value={units}
          onChange={(event) => explorer.change({ ...explorer.state.value, units: event.currentTarget.value as System })}>
          {SYSTEMS.map(([system, text]) => <option value={system} key={system}>{text}</option>)}
        </select>
      </label>
      <span class="buttons">
        <button type="button" disabled={!address.canUndo.value} onClick={() => address.undo()}>undo</button>
        <button type="button" disabled={!address.canRedo.value} onClick={() => address.redo()}>redo</button>
      </span>
    </header>
  );
}
