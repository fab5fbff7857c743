// The numbers of a launch monitor: your drive beside the best drive.
import type { Drive } from '../drive/drive';
import { usePage } from './context';
import { TableFiles, TableView } from './Figure';
import { outcomesOf, ROWS, shown } from './outcomes';

export function Panel() {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const { drive, driveMark, ghost } = explorer;
  const tableOf = (...drives: (Drive | null)[]) => ({
    head: ['', 'yours', 'best'],
    rows: ROWS.map((row) => [
      row.label,
      ...drives.map((each) => (each ? shown(row, each, units) : '–')),
    ]),
  });
  const stale = [...(driveMark.value ? [1] : []), ...(ghost.mark.value ? [2] : [])];
  // a file has no answers of an earlier drive
  const numbers = () => ({
    yours: drive.current && outcomesOf(drive.current),
    best: ghost.current && outcomesOf(ghost.current),
  });
  return (
    <section class="panel" aria-label="launch monitor">
      <h2>Launch and flight</h2>
      <TableView {...tableOf(drive.last, ghost.last)} stale={stale} />
      <TableFiles name="launch-and-flight" table={() => tableOf(drive.current, ghost.current)} numbers={numbers} />
    </section>
  );
}
