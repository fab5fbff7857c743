// Notices: errors, parts of a link that are unknown, and the progress of a long command.
import { usePage } from './context';

export function Notices() {
  const { explorer, address } = usePage();
  const { trap, progress, working } = explorer;
  const unknown = address.unknown.value;
  return (
    <div class="notices">
      {trap.value && (
        <p class="message" role="alert">
          Internal error in the core, which was restarted; your values are unchanged. {trap.value.split('\n')[0]}{' '}
          <button type="button" onClick={() => { trap.value = null; }}>close</button>
        </p>
      )}
      {unknown.length > 0 && (
        <p class="warning" role="status">
          This page does not know these parts of the link: {unknown.join(', ')}.{' '}
          <button type="button" onClick={() => { address.unknown.value = []; }}>close</button>
        </p>
      )}
      {working.value && (
        <p class="working" role="status">
          {working.value}{' '}
          {progress.value && progress.value.of > 0
            && <progress aria-label={working.value} value={progress.value.done} max={progress.value.of} />}
          <button type="button" onClick={() => explorer.end()}>end</button>
        </p>
      )}
    </div>
  );
}
