// Setup file, command, answers as JSON, report.
import { useState } from 'preact/hooks';
import { designOf, writeSetup } from '../setup/file';
import type { FileValues } from '../setup/file';
import { commandLine } from '../setup/words';
import { messageOf } from '../state/explorer';
import { usePage } from './context';
import { download } from './download';

/** The largest file that is read, bytes. */
const MOST_BYTES = 20e6;

export async function bytesOf(file: File): Promise<Uint8Array<ArrayBuffer>> {
  if (file.size > MOST_BYTES) {
    throw new Error(`${file.name} has ${Math.round(file.size / 1e6)} MB; this page reads up to 20 MB`);
  }
  return new Uint8Array(await file.arrayBuffer());
}

export function Files() {
  const { explorer } = usePage();
  const [message, setMessage] = useState<string | null>(null);
  const open = async (file: File) => {
    setMessage(null);
    const design = explorer.design.value;
    const bytes = await bytesOf(file);
    const files = { 'setup.toml': bytes };
    const reply = await explorer.run(`reading ${file.name}`, ['parameters', 'setup.toml', '--json'], files);
    if (!reply) return;
    if (reply.exit !== 0) {
      setMessage(messageOf(reply).replace(/setup\.toml/g, file.name));
      return;
    }
    if (design !== explorer.design.value) {
      setMessage(`${file.name} was not opened, because you changed the drive meanwhile. Open it again.`);
      return;
    }
    const values = JSON.parse(reply.answer) as FileValues;
    explorer.changeDesign(designOf(values, explorer.catalog, explorer.state.value.units));
  };
  const choose = (event: Event) => {
    const input = event.currentTarget as HTMLInputElement;
    const file = input.files?.[0];
    input.value = '';
    if (file) open(file).catch((error: Error) => setMessage(error.message));
  };
  const save = async (command: string, options: string[]) => {
    const reply = await explorer.run(command, [command, ...explorer.words(), ...options, '--json']);
    if (!reply) return;
    if (reply.answer) download(`${command}.json`, reply.answer, 'application/json');
    else setMessage(messageOf(reply));
  };
  const report = async () => {
    const words = [...explorer.words(), ...explorer.searchOptions(), '-o', 'drive', '--json'];
    const reply = await explorer.run('the report', ['report', ...words]);
    if (!reply) return;
    const page = reply.files['drive/index.html'];
    if (page) download('drive.html', new Uint8Array(page), 'text/html');
    else setMessage(messageOf(reply));
  };
  return (
    <section class="files" aria-label="files and command">
      <h2>Files and command</h2>
      <p class="buttons">
        <label class="button">
          open a setup file
          <input type="file" accept=".toml,text/plain" onChange={choose} />
        </label>
        <button type="button"
          onClick={() => download('setup.toml', writeSetup(explorer.design.value), 'application/toml')}>
          save the setup file
        </button>
        <button type="button" onClick={() => void save('simulate', [])}>drive (JSON)</button>
        <button type="button" onClick={() => void save('optimize', explorer.searchOptions())}>best drive (JSON)</button>
        <button type="button" onClick={() => void report()}>report (HTML, to print)</button>
      </p>
      {message && <p class="message" role="alert">{message}</p>}
      <Command />
    </section>
  );
}

/** The command that finds the best drive, to copy. */
function Command() {
  const { explorer } = usePage();
  const text = commandLine(['optimize', ...explorer.words(), ...explorer.searchOptions()]);
  const [isCopied, setCopied] = useState(false);
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(text);
      setCopied(true);
      setTimeout(() => setCopied(false), 2000);
    } catch {
      // without permission to copy, the user can still select the text
    }
  };
  return (
    <p class="command">
      as a command: <code>{text}</code>{' '}
      <button type="button" onClick={() => void copy()}>{isCopied ? 'copied' : 'copy'}</button>
    </p>
  );
}
