// The parameters of a setup whose values are names, not numbers.
import type { Design } from '../setup/design';
import { hasLaunch, withValues } from '../setup/design';
import type { Choice } from '../setup/parameters';
import { labelOf } from '../setup/parameters';
import { usePage } from './context';
import { useSteady } from './steady';

const METHOD = 'flight.method';
const STEP = 'flight.step';

export function Choices() {
  const { explorer } = usePage();
  const { all, design } = useSteady(
    () => {
      const { preset, set } = explorer.design.value;
      const values = explorer.catalog.choices.map(({ choice }) => set[choice]);
      return JSON.stringify([preset, values, set[STEP], hasLaunch(explorer.design.value)]);
    },
    () => ({ all: explorer.catalog.choices, design: explorer.design.value }),
  );
  const isUsed = ({ choice }: Choice) => choice === METHOD || !hasLaunch(design);
  return (
    <div class="choices">
      {all.filter(isUsed).map((choice) => <ChoiceRow choice={choice} design={design} key={choice.choice} />)}
    </div>
  );
}

function ChoiceRow({ choice: { choice, names, doc }, design }: { choice: Choice; design: Design }) {
  const { explorer } = usePage();
  const { preset, set } = design;
  const { setup, states_step: hasStep = false } = explorer.catalog.preset(preset) ?? {};
  const ofPreset = setup?.[choice];
  const isStep = choice === METHOD;
  const isSet = choice in set || (isStep && STEP in set);
  // if the preset states neither method nor step, the page may choose both
  const mayChoose = isStep && !hasStep;
  const isChosen = mayChoose && !isSet;
  const change = (name: string) => {
    const isBack = name === '' || (!mayChoose && name === ofPreset);
    const step = isStep && isBack ? { [STEP]: undefined } : {};
    explorer.changeDesign(withValues(
      explorer.design.value, { [choice]: isBack ? undefined : name, ...step }));
  };
  return (
    <label class={isSet ? 'changed' : undefined} title={doc}>
      <span>{labelOf(choice)}</span>
      <select value={isChosen ? '' : set[choice] ?? String(ofPreset)}
        onChange={(event) => change(event.currentTarget.value)}>
        {mayChoose && <option value="">chosen for an error of 1 µm</option>}
        {names.map((name) => <option value={name} key={name}>{name}</option>)}
      </select>
      {isStep && !isChosen && <span class="unit">step {set[STEP] ?? 'of the preset'}</span>}
    </label>
  );
}
