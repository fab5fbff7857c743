// The pictures of README and docs: node pictures.mjs PROGRAM CHROMIUM draws them in a temporary folder and lists the pictures of docs/pictures that
// differ; with --write it draws them in docs/pictures.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [program, browserFile] = process.argv.slice(2, 4).map((file) => resolve(file));
const isWriting = process.argv[4] === "--write";
const kept = fileURLToPath(new URL("../../docs/pictures/", import.meta.url));

const LAWS = ["--laws", "launch-monitor,ferguson,winfield-tan,naruo-mizota,usga-itr,bearman-harvey", "--width", "640"];
// each picture with its command; measured rounding differs between processors, so only its words are compared
const PLOTS = [
  ["map.svg", ["plot", "contour", "--width", "640"]],
  ["fairway.svg", ["plot", "fairway"]],
  ["laws-drag.svg", ["plot", "laws", ...LAWS]],
  ["laws-lift.svg", ["plot", "laws", "--show", "cl", ...LAWS]],
  ["vcurve.svg", ["plot", "vcurve", "mae494", "--of", "carry", "--wrt", "club.loft"], "words"],
];
// validation-*.svg are drawn by `LONGDRIVE_WRITE_VALIDATION=1 cargo test same_numbers_in_validation_md`, which compares them at every run
// the first screen of the report: report.png, and report.txt with its words and styles, because screenshots differ between machines with other fonts
const SCREEN = { width: 1280, height: 800 };
// largest difference of two coordinates that counts as rounding, in tenths of a pixel
const NEAR = 5;

const folder = mkdtempSync(join(tmpdir(), "longdrive-pictures-"));
const run = (args, file) => {
  const env = { ...process.env, SOURCE_DATE_EPOCH: "0" };
  execFileSync(program, [...args, "--units", "us", "--quiet", "-o", file], { env, stdio: ["ignore", "ignore", "inherit"] });
  return file;
};

/** The lines of text of a drawing. */
const words = (svg) => svg.split(/<[^>]*>/).map((text) => text.trim()).filter(Boolean).join("\n");

/** True if two drawings are equal to the rounding of their coordinates. */
function isSame(ours, theirs) {
  const number = /-?\d+(?:\.\d+)?/g;
  const attributes = (svg) => (svg.match(/<[^>]*>/g) ?? []).join("\n");
  const [a, b] = [ours, theirs].map(attributes);
  const [us, them] = [a, b].map((text) => text.match(number) ?? []);
  const isNear = () => us.length === them.length && us.every((one, i) => Math.abs(one - them[i]) <= NEAR);
  return a.replace(number, "#") === b.replace(number, "#") && isNear();
}

/** The first screen of the report: its words, an element a line, and its styles. */
function firstScreen(html) {
  const style = createHash("sha256").update(html.match(/<style>[^]*?<\/style>/)[0]).digest("hex").slice(0, 16);
  const shown = html.slice(html.indexOf("<body"), html.indexOf("<figure"));
  const text = words(shown.replace(/<(span|a)\b[^>]*class="metric"[^>]*>[^]*?<\/\1>/g, ""));
  return `style ${style}\n${text}\n`;
}

const stored = (name) => {
  try {
    return readFileSync(join(kept, name), "utf8");
  } catch {
    return "";
  }
};
const stale = [];
/** Compares a picture with the stored one, or stores it. */
function settle(name, drawn, isCurrent) {
  if (isCurrent(stored(name), drawn)) return true;
  if (isWriting) writeFileSync(join(kept, name), drawn);
  else stale.push(name);
  return false;
}

try {
  for (const [name, args, what] of PLOTS) {
    const drawn = readFileSync(run(args, join(folder, name)), "utf8");
    settle(name, drawn, (old, now) => words(old) === words(now) && (what === "words" || isSame(old, now)));
  }
  const page = join(run(["report"], join(folder, "report")), "index.html");
  const isCurrent = settle("report.txt", firstScreen(readFileSync(page, "utf8")), (old, now) => old === now);
  if (isWriting && !(isCurrent && stored("report.png"))) {
    const browser = await chromium.launch({ executablePath: browserFile, args: ["--no-sandbox", "--disable-gpu"] });
    const tab = await browser.newPage({ viewport: SCREEN, colorScheme: "light" });
    await tab.goto(pathToFileURL(page).href);
    await tab.screenshot({ path: join(kept, "report.png") });
    await browser.close();
  } else if (!stored("report.png")) {
    stale.push("report.png");
  }
} finally {
  rmSync(folder, { recursive: true });
}
for (const name of stale) console.error(`docs/pictures/${name} is not what the program draws now: draw the pictures with tests/pages/run --pictures, look at them and commit them`);
console.log(`${PLOTS.length + 1} pictures of README and docs: ${isWriting ? "drawn" : `${stale.length} not current`}`);
process.exit(stale.length ? 1 : 0);
