// All parameters: sliders of the first screen, other sliders in groups, and a search.
import { useEffect, useState } from 'preact/hooks';
import { firstOf, withValues } from '../setup/design';
import { AIR_FIRST, groupOf, labelOf } from '../setup/parameters';
import { Choices } from './Choices';
import { usePage } from './context';
import { useSteady } from './steady';
import { FaceView } from './FaceView';
import { SliderRow } from './SliderRow';

/** The most sliders that a search shows. */
const MOST_FOUND = 12;

export function Sliders() {
  const { explorer } = usePage();
  const first = useSteady(() => firstOf(explorer.design.value));
  const isLaunch = explorer.isLaunch.value;
  return (
    <section class="sliders" aria-label="parameters">
      <StartSwitch isLaunch={isLaunch} />
      {first.map((name) => <SliderRow name={name} key={name} />)}
      {!isLaunch && <FaceView />}
      {AIR_FIRST.map((name) => <SliderRow name={name} key={name} />)}
      <Choices />
      <Others first={first} />
    </section>
  );
}

/**
 * A switch between a club that strikes the ball and a launch that a launch monitor has measured.
 */
function StartSwitch({ isLaunch }: { isLaunch: boolean }) {
  const { explorer } = usePage();
  // render again, to reset the button if the switch was cancelled
  const [, setTries] = useState(0);
  const toLaunch = () => void explorer.startWithLaunch().then(() => setTries((tries) => tries + 1));
  const toClub = () => {
    const { set } = explorer.design.value;
    const launch = Object.keys(set).filter((name) => name.startsWith('launch.'));
    explorer.changeDesign(withValues(
      explorer.design.value, Object.fromEntries(launch.map((name) => [name, undefined]))));
  };
  return (
    <fieldset class="switch">
      <legend>the drive starts with</legend>
      <label>
        <input type="radio" name="start" checked={!isLaunch} onChange={toClub} /> swing and club
      </label>
      <label>
        <input type="radio" name="start" checked={isLaunch} onChange={toLaunch} /> a measured launch
      </label>
    </fieldset>
  );
}

/** The parameters that are not on the first screen. */
function Others({ first }: { first: readonly string[] }) {
  const { explorer } = usePage();
  const [search, setSearch] = useState('');
  const [openGroup, setOpenGroup] = useState<string | null>(null);
  const all = explorer.catalog.of(explorer.law.value)
    .filter(({ parameter }) => !first.includes(parameter) && !AIR_FIRST.includes(parameter));
  const words = search.toLowerCase().split(/\s+/).filter((word) => word !== '');
  const found = all.filter(({ parameter, doc }) => {
    const text = `${parameter} ${labelOf(parameter)} ${doc}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
  const isSearch = words.length > 0;
  const inGroup = (group: string | null) => all.map(({ parameter }) => parameter)
    .filter((name) => groupOf(name) === group);
  const shown = isSearch
    ? found.slice(0, MOST_FOUND).map(({ parameter }) => parameter) : inGroup(openGroup);
  useEffect(() => explorer.setListed(shown), [shown.join()]);
  const groups = [...new Set(all.map(({ parameter }) => groupOf(parameter)))];
  return (
    <div class="others">
      <label class="search">
        further parameters
        <input type="search" value={search} placeholder="search, such as restitution"
          onInput={(event) => setSearch((event.target as HTMLInputElement).value)} />
      </label>
      {isSearch
        ? <Found names={shown} count={found.length} />
        : groups.map((group) => (
          <Group key={group} group={group} names={inGroup(group)} isOpen={group === openGroup}
            onToggle={() => setOpenGroup(group === openGroup ? null : group)} />
        ))}
    </div>
  );
}

function Found({ names, count }: { names: string[]; count: number }) {
  if (count === 0) return <p>No parameter has these words.</p>;
  return (
    <>
      {names.map((name) => <SliderRow name={name} key={name} />)}
      {count > names.length && <p>{names.length} of {count} parameters with these words.</p>}
    </>
  );
}

interface GroupProps {
  group: string;
  names: string[];
  isOpen: boolean;
  onToggle: () => void;
}

function Group({ group, names, isOpen, onToggle }: GroupProps) {
  const { explorer } = usePage();
  const stated = useSteady(() => Object.keys(explorer.design.value.set));
  const changed = names.filter((name) => stated.includes(name)).length;
  return (
    <div class="group">
      <button type="button" aria-expanded={isOpen} onClick={onToggle}>
        {isOpen ? '▾' : '▸'} {group} ({names.length}{changed > 0 ? `, ${changed} changed` : ''})
      </button>
      {isOpen && names.map((name) => <SliderRow name={name} key={name} isInGroup />)}
    </div>
  );
}
