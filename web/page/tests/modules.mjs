// The modules of the page that read external input, compiled for Node.
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

export async function pageModules() {
  const entry = fileURLToPath(new URL('modules.ts', import.meta.url));
  const [{ output }] = [await build({
    configFile: false,
    logLevel: 'warn',
    build: { write: false, minify: false, target: 'es2022', lib: { entry, formats: ['es'] } },
  })].flat();
  const script = Buffer.from(output[0].code).toString('base64');
  return import(`data:text/javascript;base64,${script}`);
}
