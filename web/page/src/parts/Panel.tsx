// The numbers of a launch monitor: your drive beside the best drive.
import { usePage } from './context';
import { TableFiles, TableView } from './Figure';
import { outcomesOf, ROWS, shown } from './outcomes';

export function Panel() {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const drive = explorer.drive.value;
  const ghost = explorer.ghost.value;
  const rows = ROWS.map((row) => [
    row.label,
    drive ? shown(row, drive, units) : '–',
    ghost ? shown(row, ghost, units) : '–',
  ]);
  const table = { head: ['', 'yours', 'best'], rows };
  const numbers = () => ({ yours: drive && outcomesOf(drive), best: ghost && outcomesOf(ghost) });
  return (
    <section class="panel" aria-label="launch monitor">
      <h2>Launch and flight</h2>
      <TableView {...table} />
      <TableFiles name="launch-and-flight" table={() => table} numbers={numbers} />
    </section>
  );
}
