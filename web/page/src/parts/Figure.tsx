// A picture with a name, a sentence and a table of the same content; a table without a picture; and
// the buttons that download pictures and tables.
import type { ReadonlySignal } from '@preact/signals';
import type { ComponentChildren, Ref } from 'preact';
import { useState } from 'preact/hooks';
import { download, pictureOf } from './download';

export interface Table {
  head: readonly string[];
  rows: readonly (readonly string[])[];
}

interface Props {
  name: string;
  title: string;
  sentence: string;
  /** Called only while the table is visible, or to download it. */
  table: () => Table;
  /** The element around the picture, whose width the picture takes. */
  place?: Ref<HTMLDivElement>;
  children: ComponentChildren;
  below?: ComponentChildren;
  /** The class of sentence and table: 'stale' if they are about an earlier drive. */
  mark?: string | ReadonlySignal<string>;
  /** True if screen readers announce a change of the sentence. */
  isLive?: boolean;
  /** True if the table is open at first. */
  isOpen?: boolean;
  /** Index of the row that belongs to the picture. */
  at?: number;
}

const csvField = (text: string) => (/[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);

const csvOf = ({ head, rows }: Table) =>
  [head, ...rows].map((row) => row.map(csvField).join(',')).join('\r\n');

export function Figure({ name, title, sentence, table, place, children, below, ...more }: Props) {
  const [isOpen, setOpen] = useState(more.isOpen ?? false);
  const save = (event: Event) => {
    const svg = (event.currentTarget as Element).closest('figure')?.querySelector('svg');
    if (svg) download(`${name}.svg`, pictureOf(svg), 'image/svg+xml');
  };
  return (
    <figure class={`picture ${name}`} aria-label={title}>
      <h2>{title}</h2>
      <div ref={place ?? null}>{children}</div>
      <figcaption class={more.mark} aria-live={more.isLive ? 'polite' : undefined}>{sentence}</figcaption>
      {below}
      <details class="data" open={isOpen} onToggle={(event) => setOpen(event.currentTarget.open)}>
        <summary>table and files of the {title.toLowerCase()}</summary>
        <p class="buttons">
          <button type="button" onClick={save}>picture (SVG)</button>
          <TableButton name={name} table={table} />
        </p>
        {isOpen && <div class={more.mark}><TableView {...table()} at={more.at} /></div>}
      </details>
    </figure>
  );
}

interface SavedProps {
  name: string;
  table: () => Table;
  /** The numbers of the table, SI. */
  numbers: () => unknown;
}

/** Buttons that download a table without a picture. */
export function TableFiles({ name, table, numbers }: SavedProps) {
  return (
    <p class="buttons">
      <TableButton name={name} table={table} />
      <button type="button"
        onClick={() => download(`${name}.json`, `${JSON.stringify(numbers(), null, 2)}\n`, 'application/json')}>
        numbers (JSON)
      </button>
    </p>
  );
}

const TableButton = ({ name, table }: Pick<SavedProps, 'name' | 'table'>) => (
  <button type="button" onClick={() => download(`${name}.csv`, csvOf(table()), 'text/csv')}>
    table (CSV)
  </button>
);

interface TableProps extends Table {
  at?: number | undefined;
  /** Indices of the columns with answers about an earlier drive. */
  stale?: readonly number[];
}

export function TableView({ head, rows, at, stale = [] }: TableProps) {
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="table">
      <table>
        <thead><tr>{head.map((text) => <th scope="col" key={text}>{text}</th>)}</tr></thead>
        <tbody>
          {rows.map((row, k) => (
            <tr key={k} aria-current={k === at ? 'step' : undefined}>
              {row.map((text, column) => <td key={column} class={stale.includes(column) ? 'stale' : undefined}>{text}</td>)}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
