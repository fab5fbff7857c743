// The modules of the page that read external input, compiled for Node.
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

/** The code of the workers, which do not run under Node. */
const worker = {
  name: 'worker',
  resolveId: id => (id === 'virtual:worker' ? id : undefined),
  load: id => (id === 'virtual:worker' ? "export default ''" : undefined),
};

export async function pageModules() {
  const entry = fileURLToPath(new URL('modules.ts', import.meta.url));
  const [{ output }] = [await build({
    configFile: false,
    logLevel: 'warn',
    plugins: [worker],
    build: { write: false, minify: false, target: 'es2022', lib: { entry, formats: ['es'] } },
  })].flat();
  const script = Buffer.from(output[0].code).toString('base64');
  return import(`data:text/javascript;base64,${script}`);
}
