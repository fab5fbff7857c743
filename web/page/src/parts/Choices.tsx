// The parameters of a setup whose values are names, not numbers.
import type { Design } from '../setup/design';
import { withValues } from '../setup/design';
import type { Choice } from '../setup/parameters';
import { labelOf } from '../setup/parameters';
import { usePage } from './context';
import { useSteady } from './steady';

const METHOD = 'flight.method';
const STEP = 'flight.step';

export function Choices() {
  const { explorer } = usePage();
  const { choices } = explorer.catalog;
  const isLaunch = explorer.isLaunch.value;
  const design = useSteady(() => statedChoices(explorer.design.value, choices));
  const isUsed = ({ choice }: Choice) => choice === METHOD || !isLaunch;
  return (
    <div class="choices">
      {choices.filter(isUsed).map((choice) => <ChoiceRow choice={choice} design={design} key={choice.choice} />)}
    </div>
  );
}

/** The design with its choices and the step alone. */
function statedChoices({ preset, set }: Design, choices: readonly Choice[]): Design {
  const names = [STEP, ...choices.map(({ choice }) => choice)];
  const rows = Object.entries(set).filter(([name]) => names.includes(name));
  return { preset, set: Object.fromEntries(rows) };
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
