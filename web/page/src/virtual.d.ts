declare module 'virtual:worker' {
  /** The worker as one classic script. */
  const code: string;
  export default code;
}
declare module '*.css';
