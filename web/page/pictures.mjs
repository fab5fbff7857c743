// Draws the pictures of docs/explorer.md from the page that web/build has built: node pictures.mjs
import { fileURLToPath } from 'node:url';
import { file, launch, open, settle } from './tests/browser.mjs';

const folder = fileURLToPath(new URL('../../docs/pictures', import.meta.url));
const PICTURES = [
  ['explorer', '#1&tour-average&swing.speed=95mph&club.loft=10.5deg&swing.face_angle=1deg', { width: 1280, height: 800 }],
  ['explorer-phone', '#1&amateur-average', { width: 390, height: 844 }],
];

const browser = await launch();
for (const [name, fragment, size] of PICTURES) {
  const { page, context } = await open(browser, file + fragment, size);
  await settle(page);
  await page.screenshot({ path: `${folder}/${name}.png` });
  await context.close();
}
await browser.close();
