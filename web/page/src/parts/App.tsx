// The page: answer, sliders, views.
import { useEffect, useState } from 'preact/hooks';
import { Answer } from './Answer';
import { Compare } from './Compare';
import { usePage } from './context';
import { Files } from './Files';
import { Header } from './Header';
import { IterationsView } from './IterationsView';
import { Live } from './Live';
import { LoopView } from './LoopView';
import { MapView } from './MapView';
import { Notices } from './Notices';
import { Panel } from './Panel';
import { Shots } from './Shots';
import { SideView } from './SideView';
import { Sliders } from './Sliders';
import { TopView } from './TopView';

/** The views of a narrow screen, which shows one at a time. */
const VIEWS = ['side', 'above', 'map', 'launch', 'more'] as const;

export function App() {
  const [view, setView] = useState<(typeof VIEWS)[number]>('side');
  const [isOpen, setOpen] = useState(true);
  const { explorer } = usePage();
  useKeys();
  return (
    <>
      <Header />
      <Notices />
      <main data-view={view} data-busy={explorer.busy}>
        <div class="answer-place"><Answer /></div>
        <nav class="views" aria-label="views">
          {VIEWS.map((name) => (
            <button type="button" key={name} aria-pressed={name === view} onClick={() => setView(name)}>{name}</button>
          ))}
        </nav>
        <div class="middle">
          <SideView />
          <TopView />
        </div>
        <div class="right">
          <MapView />
          <Panel />
        </div>
        <div class={`left sheet${isOpen ? ' open' : ''}`}>
          <button type="button" class="sheet-switch" aria-expanded={isOpen} onClick={() => setOpen(!isOpen)}>
            {isOpen ? '▾ sliders' : '▴ sliders'}
          </button>
          <Sliders />
        </div>
        <div class="more">
          <Compare />
          <Shots />
          <Files />
          <LoopView />
          <IterationsView />
        </div>
      </main>
      <footer>
        <p>
          Computed in this page by the program longdrive, with exact derivatives; nothing leaves it. The model is not exact:
          carries are within about 3 yd of launch monitors, totals within 10 yd.
        </p>
      </footer>
      <Live />
    </>
  );
}

/** Handles the keys for undo, redo and the best drive. */
function useKeys() {
  const { address, explorer } = usePage();
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      const isTyped = event.target instanceof HTMLInputElement && event.target.type !== 'range'
        && event.target.type !== 'radio' && event.target.type !== 'checkbox';
      const isCommand = event.ctrlKey || event.metaKey;
      // in a field whose number is set, undo the drive: the browser's undo would change only the
      // field
      const isCommitted = isTyped && event.target.matches('.number:not([data-draft])');
      if (isTyped && !(isCommand && isCommitted)) return;
      if (event.target instanceof HTMLSelectElement) return;
      const key = event.key.toLowerCase();
      if (isCommand && key === 'z' && !event.shiftKey) address.undo();
      else if (isCommand && (key === 'y' || (key === 'z' && event.shiftKey))) address.redo();
      else if (!isCommand && !event.altKey && key === 'b') explorer.goToBest();
      else return;
      event.preventDefault();
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  }, []);
}
