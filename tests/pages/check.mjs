// Checks pages of longdrive in Chromium: node check.mjs [PROGRAM [CHROMIUM]]
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import axe from "axe-core";
import { HtmlValidate } from "html-validate";
import { chromium } from "playwright-core";

const root = fileURLToPath(new URL("../..", import.meta.url));
const program = resolve(process.argv[2] ?? join(root, "target/debug/longdrive"));
const browserFile = process.argv[3] ?? "/usr/bin/chromium";
const shots = join(root, "examples/shots.csv");

// each page with the exit status of its command
const PAGES = [
  ["report", ["report"], 0],
  ["slow", ["report", "--set", "swing.speed=60mph"], 0],
  ["launch", ["report", "--launch", "ball_speed=150mph,launch_angle=12deg,backspin=2600rpm"], 0],
  ["infeasible", ["report", "--subject-to", "descent_angle >= 80 deg"], 1],
  ["no-flight", ["report", "--set", "swing.attack_angle=-20deg"], 1],
  ["held", ["report", "modern-driver", "--subject-to", "descent_angle >= 42 deg", "--set", "wind.right=5mph", "--set", "swing.path=2deg"], 0],
  ["metric", ["report", "--units", "metric"], 0],
  ["mae494", ["reproduce", "mae494"], 0],
  ["winfield-tan", ["reproduce", "winfield-tan"], 0],
  ["validate", ["validate"], 0],
  ["calibrate", ["calibrate", shots, "modern-driver", "--fit", "aero.cd0", "--fit", "aero.cl_max=0.2..1"], 0],
];
const SCREENS = [[390, 844], [768, 1024], [1280, 800]];
// A4 without margins, at 96 pixels per inch
const PAPER = [688, 1016];
const LEAST_TEXT = 12;
// axe's rules of colours: contrast of text, and of links in text
const COLOURS = ["color-contrast", "link-in-text-block"];
// typed text and quoted sources keep their units
const AS_WRITTEN = ".switch, .typed, .source, .doc, code";

const found = [];
const folder = mkdtempSync(join(tmpdir(), "longdrive-pages-"));

/** Writes a page and returns its file. */
function made([name, args, status]) {
  const into = join(folder, name);
  let ended = 0;
  try {
    execFileSync(program, [...args, args[0] === "calibrate" ? "--plot" : "-o", into], { stdio: "pipe" });
  } catch (error) {
    ended = error.status;
  }
  if (ended !== status) found.push(`${name}: the program ended with status ${ended}, not ${status}`);
  return join(into, "index.html");
}

// checks in the browser, which return the faults as texts

/** A page wider than the screen. */
function wide() {
  const { scrollWidth, clientWidth } = document.documentElement;
  return scrollWidth > clientWidth ? [`it is ${scrollWidth} pixels wide, on a screen of ${clientWidth}`] : [];
}

/** Tables wider than their column, whose right side is hidden until the reader scrolls. */
function clipped() {
  const tables = [...document.querySelectorAll(".wide")].filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth + 1);
  return tables.map((table) => `the table '${table.getAttribute("aria-label")}' is ${table.scrollWidth} pixels wide in ${table.clientWidth}`);
}

/** Pictures larger than a sheet of paper, which would be cut in two. */
function tall(sheet) {
  const figures = [...document.querySelectorAll("figure")].map((figure) => figure.getBoundingClientRect().height);
  return figures.filter((height) => height > sheet).map((height) => `a picture of ${height} pixels on a sheet of ${sheet}`);
}

/** A missing answer, or an answer that ends below the first screen. */
function answered() {
  const answer = document.querySelector(".answer");
  if (!answer) return ["it has no answer"];
  const { bottom } = answer.getBoundingClientRect();
  return bottom + scrollY > innerHeight ? [`the answer ends at ${bottom} of ${innerHeight} pixels`] : [];
}

/** Too small text in pictures. */
function small(least) {
  const wrong = [];
  for (const text of document.querySelectorAll("svg text")) {
    if (!text.checkVisibility()) continue;
    const size = parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a;
    if (size < least - 0.05) wrong.push(`'${text.textContent.trim()}' is ${size.toFixed(1)} pixels high`);
  }
  return wrong.slice(0, 3);
}

/** Text beyond the edge of its picture. */
function cut() {
  const wrong = [];
  for (const text of document.querySelectorAll("svg text")) {
    if (!text.checkVisibility() || !text.textContent.trim()) continue;
    const [inner, outer] = [text.getBoundingClientRect(), text.ownerSVGElement.getBoundingClientRect()];
    if (inner.left < outer.left - 1 || inner.right > outer.right + 1) wrong.push(`'${text.textContent.trim()}' is cut`);
  }
  return wrong.slice(0, 3);
}

/** Text in units that are not chosen. */
function mixed([units, where, asWritten]) {
  const wrong = new Set();
  const unit = new RegExp(`\\d ?(${units.join("|")})(?![\\w/])|\\[(${units.join("|")})\\]`);
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let text = texts.nextNode(); text; text = texts.nextNode()) {
    const inside = text.parentElement;
    if (unit.test(text.data) && inside.closest(where) && !inside.closest(asWritten) && inside.checkVisibility()) wrong.add(`'${text.data.trim()}'`);
  }
  return [...wrong].slice(0, 3);
}

/** Folded parts, which are missing on paper. */
function folded() {
  const rest = [...document.querySelectorAll("details > :not(summary)")].filter((node) => node.getBoundingClientRect().height === 0);
  return rest.slice(0, 3).map((node) => `<${node.localName}> in a folded part is not printed`);
}

async function look(browser, name, file) {
  const isReport = readFileSync(file, "utf8").includes('class="answer"');
  for (const scheme of ["light", "dark"]) {
    const context = await browser.newContext({ colorScheme: scheme });
    const page = await context.newPage();
    const say = (where, all) => found.push(...all.map((what) => `${name} ${where} ${scheme}: ${what}`));
    page.on("console", (message) => say("console", [message.text()]));
    page.on("pageerror", (error) => say("script", [String(error)]));
    page.on("request", (request) => request.url().startsWith("file:") || say("request", [request.url()]));
    await page.goto(pathToFileURL(file).href);
    await page.evaluate(axe.source);
    // the layout does not depend on the colour scheme, nor colours on the width: only colours are
    // checked in the dark
    for (const [width, height] of scheme === "dark" ? SCREENS.slice(0, 1) : SCREENS) {
      const isFirst = width === SCREENS[0][0];
      await page.setViewportSize({ width, height });
      say(width, await page.evaluate(wide));
      say(width, await page.evaluate(cut));
      if (isReport) say(width, await page.evaluate(answered));
      if (isReport) say(width, await page.evaluate(clipped));
      if (isFirst) say(width, await page.evaluate(small, LEAST_TEXT));
      const isOff = { enabled: false };
      const options = scheme === "dark" ? { runOnly: COLOURS } : isFirst ? {} : { rules: Object.fromEntries(COLOURS.map((rule) => [rule, isOff])) };
      const { violations } = await page.evaluate((options) => axe.run({ resultTypes: ["violations"], ...options }), options);
      const grave = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
      say(width, grave.map(({ id, nodes }) => `axe ${id}: ${nodes.length} times, ${nodes[0].html.slice(0, 100)}`));
    }
    if (scheme === "light") {
      for (const [system, units] of [["metric", ["yd", "mph", "ft"]], ["us", ["m", "m/s"]]]) {
        // page.click would wait for animation frames: of two pages that are open at once, the
        // browser may draw only one
        await page.$eval(`label[for=units-${system}]`, (label) => label.click());
        // printed numbers of a paper keep their units, with the others beside them
        say(system, await page.evaluate(mixed, [units, isReport ? "body" : "svg", AS_WRITTEN]));
      }
      await page.emulateMedia({ media: "print" });
      await page.setViewportSize({ width: PAPER[0], height: PAPER[1] });
      say("print", await page.evaluate(wide));
      say("print", await page.evaluate(folded));
      say("print", await page.evaluate(tall, PAPER[1]));
      await page.pdf({ format: "A4", printBackground: true });
    }
    await context.close();
  }
}

try {
  const pages = PAGES.map((asked) => [asked[0], made(asked)]);
  const validator = new HtmlValidate({ root: true, extends: ["html-validate:recommended"] });
  for (const [name, file] of pages) {
    const report = await validator.validateFile(file);
    for (const { messages } of report.results) {
      found.push(...messages.map(({ ruleId, line, message }) => `${name}: html-validate ${ruleId}, line ${line}: ${message}`));
    }
  }
  const args = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-component-update"];
  const browser = await chromium.launch({ executablePath: browserFile, args });
  // two at a time
  const waiting = [...pages];
  const work = async () => {
    for (let next = waiting.shift(); next; next = waiting.shift()) await look(browser, ...next);
  };
  await Promise.all([work(), work()]);
  await browser.close();
} finally {
  rmSync(folder, { recursive: true });
}
for (const what of found) console.error(what);
console.log(`${PAGES.length} pages at ${SCREENS.map(([width]) => width).join(", ")} pixels, dark and in print: ${found.length} faults`);
process.exit(found.length ? 1 : 0);
