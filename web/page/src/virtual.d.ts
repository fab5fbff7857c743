declare module 'virtual:worker' {
  /** The worker as one classic script. */
  const code: string;
  export default code;
}
declare module '*.css';
declare module 'virtual:catalog' {
  import type { Choice, Parameter, Preset } from './setup/parameters';

  /** The lists of the program: `parameters --json` and `presets --json` with integrations. */
  const listed: { parameters: Parameter[]; choices: Choice[]; presets: Preset[] };
  export default listed;
}
