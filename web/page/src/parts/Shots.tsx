// Shots of a launch monitor: the page flies a CSV file and shows measured beside computed numbers.
import { useComputed } from '@preact/signals';
import { useState } from 'preact/hooks';
import { fromSI, digits, signed, symbolOf } from '../setup/units';
import type { Design } from '../setup/design';
import { isReplaced } from '../setup/design';
import { setupWords } from '../setup/words';
import { messageOf } from '../state/explorer';
import { usePage } from './context';
import { download } from './download';
import { TableView } from './Figure';
import { bytesOf } from './Files';
import { ROWS } from './outcomes';

interface Residual {
  of: string;
  rows: number;
  bias: number | null;
  mean_absolute: number | null;
}

/** The answer of `fly`. */
interface FlyAnswer {
  rows: number;
  flown: number;
  residuals: Residual[];
  warnings: string[];
}

interface Result {
  name: string;
  /** The arguments of the setup of the flights, one a line. */
  setup: string;
  answer: FlyAnswer;
  csv: Uint8Array;
}

const OUTPUT = 'flown.csv';

/**
 * The arguments for the setup of the flights. Parameters of strike and launch are left out, because
 * each shot has its own launch.
 */
function flightWords({ preset, set }: Design): string[] {
  // `fly` refuses a stated parameter of the club if no row uses it
  const isMeasured = (name: string) => isReplaced(name, true) || isReplaced(name, false);
  const kept = Object.entries(set).filter(([name]) => !isMeasured(name));
  return setupWords({ preset, set: Object.fromEntries(kept) });
}

export function Shots() {
  const { explorer } = usePage();
  const [result, setResult] = useState<Result | null>(null);
  const [message, setMessage] = useState<string | null>(null);
  const fly = async (file: File) => {
    setMessage(null);
    const setup = flightWords(explorer.design.value);
    const files = { 'shots.csv': await bytesOf(file) };
    const words = ['fly', 'shots.csv', ...setup, '--json', '-o', OUTPUT, '--units', explorer.state.value.units];
    const reply = await explorer.run(`flying the shots of ${file.name}`, words, files);
    if (!reply) return;
    const csv = reply.files[OUTPUT];
    if (!csv) {
      setResult(null);
      setMessage(messageOf(reply).replace(/shots\.csv/g, file.name));
      return;
    }
    setResult({ name: file.name, setup: setup.join('\n'), answer: JSON.parse(reply.answer) as FlyAnswer, csv });
  };
  const begin = (file: File | undefined) => {
    if (file) fly(file).catch((error: Error) => setMessage(error.message));
  };
  const choose = (event: Event) => {
    const input = event.currentTarget as HTMLInputElement;
    begin(input.files?.[0]);
    input.value = '';
  };
  const drop = (event: DragEvent) => {
    event.preventDefault();
    begin(event.dataTransfer?.files[0]);
  };
  return (
    <section class="shots" aria-label="shots" onDrop={drop} onDragOver={(event) => event.preventDefault()}>
      <h2>Shots of a launch monitor</h2>
      <p>
        Drop a CSV export here, or{' '}
        <label class="button">
          open a CSV
          <input type="file" accept=".csv,.txt,text/csv" onChange={choose} />
        </label>
        ; ball, air, wind and ground are those of this drive. Nothing leaves this page.
      </p>
      {message && <p class="message" role="alert">{message}</p>}
      {result && <Compared {...result} />}
    </section>
  );
}

function Compared({ name, setup, answer, csv }: Result) {
  const { explorer } = usePage();
  const isStale = useComputed(() => flightWords(explorer.design.value).join('\n')).value !== setup;
  const units = explorer.units.value;
  const rows = answer.residuals.filter(({ rows: count }) => count > 0).map(({ of, rows: count, bias, mean_absolute: mean }) => {
    const known = ROWS.find((row) => row.name === of.replace('_distance', ''));
    const unit = known?.unit[units] ?? '';
    const decimals = known?.decimals ?? 1;
    return [
      known?.label ?? of.replace(/_/g, ' '),
      String(count),
      `${signed(fromSI(bias ?? NaN, unit), decimals)} ${symbolOf(unit)}`,
      `${digits(fromSI(mean ?? NaN, unit), decimals)} ${symbolOf(unit)}`,
    ];
  });
  return (
    <>
      <p role="status">
        {answer.flown} of {answer.rows} shots of {name} were flown.
        {answer.flown < answer.rows && ' For each shot that was not flown, the CSV below has the reason.'}
      </p>
      {isStale && (
        <p class="warning">
          These shots were flown with another setup: another preset, law, ball, air, wind or ground.
          Open the file again to fly them with this one.
        </p>
      )}
      {rows.length > 0 && (
        <div class={isStale ? 'stale' : undefined}>
          <TableView head={['outcome', 'shots', 'computed − measured, mean', 'mean absolute']} rows={rows} />
        </div>
      )}
      <p class="buttons">
        <button type="button" onClick={() => download('flown.csv', new Uint8Array(csv), 'text/csv')}>
          all shots, measured and computed (CSV)
        </button>
      </p>
      {answer.warnings.map((warning) => <p class="warning" key={warning}>{warning}</p>)}
    </>
  );
}
