// A browser that may go nowhere, and pages of real audits for it.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";
import { fileURLToPath } from "node:url";
import { gunzipSync } from "node:zlib";
import { chromium } from "playwright-core";

const here = dirname(fileURLToPath(import.meta.url));
export const repository = join(here, "..", "..");
export const shots = process.env.SHOTS ?? join(here, "shots");
const owlint = process.env.OWLINT ?? join(repository, "build", "release", "owlint");
const axeFile = createRequire(import.meta.url).resolve("axe-core/axe.min.js");

export function scratch() {
  return mkdtempSync(join(tmpdir(), "owlint-page-"));
}

/** One run of an audit; findings make its status 1, which is no fault here. */
export function audit(folder, ...options) {
  return auditOf(folder, "shop", "--isolated", ...options);
}

export function auditOf(folder, ...options) {
  const done = spawnSync(owlint, ["audit", ...options], { cwd: folder, encoding: "utf8" });
  if (done.status > 1 || done.status === null) throw new Error(`owlint audit: ${done.status} ${done.stderr}`);
  return done;
}

/** How many fixtures of each rule are in a shop: enough to fill each view, for all of them make a page that loads slowly. */
const perRule = 3;
/** One that a test opens by its name. */
const wanted = "longer-than-the-axis.ngc";

/** The corpus and some fixtures of each rule as a shop, audited twice with changes in between: the page of the second run. */
export function shopPage(change = () => {}) {
  const folder = scratch();
  const shop = join(folder, "shop");
  cpSync(join(repository, "corpus"), shop, { recursive: true });
  const fixtures = join(repository, "tests", "programs");
  for (const code of readdirSync(fixtures)) {
    const names = readdirSync(join(fixtures, code)).sort().filter((name, at) => at < perRule || name === wanted);
    for (const name of names) cpSync(join(fixtures, code, name), join(shop, "fixtures", code, name), { recursive: true });
  }
  writeFileSync(join(shop, "old.ngc"), "o100 endif\nM2\n");
  audit(folder);
  writeFileSync(join(shop, "old.ngc"), "M2\n");
  writeFileSync(join(shop, "new.ngc"), "o<probe> sub\n  o100 if [#1 GT 1]\n    o<touch> call [#1]\n  o100 endif\no<probe> endsub\no<touch> sub\no<touch> endsub\no<probe> call [2]\no100 if [1]\no100 if [0]\no100 endif\no100 endif\nM2\n");
  writeFileSync(join(shop, "calling.ngc"), "o<called> call [1]\nM2\n");
  writeFileSync(join(shop, "called.ngc"), "o<called> sub\no<called> endsub\nM2\n");
  writeFileSync(join(shop, "modes.ngc"), "G21 G90 G17\nG0 X0 Y0\no<leaves> call\nG0 X10\no100 if [#5070 EQ 0]\n  G90 G18\no100 endif\nG0 X20\nM2\nG0 X30\n");
  writeFileSync(join(shop, "leaves.ngc"), "o<leaves> sub\n  G91 G0 Z5\no<leaves> endsub\nM2\n");
  writeFileSync(join(shop, "arc.ngc"), "G21 G90 G17 F200\nG0 X0 Y0\nG2 X20 Y0 I10.1 J0\nG3 X40 Y0 R9\nM2\n");
  mkdirSync(join(shop, "machines"));  // beside the programs, they would use it
  writeFileSync(join(shop, "machines", "unused.ini"), "[EMC]\nVERSION = 1.1\n[RS274NGC]\nOWORD_NARGS = YES\n");
  change(shop);
  audit(folder, "--report", "audit.html");
  return join(folder, "audit.html");
}

/** The data in a page: its index, and the details of programs by their numbers. */
export function dataOf(file) {
  const html = readFileSync(file, "utf8");
  const data = { details: {} };
  for (const [, id, text] of html.matchAll(/<script type="text\/plain" id="owlint-(index|part-\d+)">([^<]*)</g)) {
    const json = JSON.parse(gunzipSync(Buffer.from(text.replace(/\s+/g, ""), "base64")).toString());
    if (id === "index") data.index = json;
    else Object.assign(data.details, json);
  }
  return data;
}

/** The address of a program in the top folder or, by its name, in another one. */
export function programIn(data, name, query = "") {
  const paths = data.index.files.path;
  return `#/program/${paths.includes(name) ? paths.indexOf(name) : paths.findIndex((path) => path.endsWith(`/${name}`))}${query}`;
}

/** Of a program with a finding of a rule that has a safe fix, the finding chosen. */
export function fixableIn(data, code) {
  const { file: files, rule, fix, line } = data.index.findings;
  const i = rule.findIndex((r, at) => data.index.rules[r].code === code && fix[at] === 2);
  return `#/program/${files[i]}?line=${line[i]}`;
}

let browser;

export async function start() {
  mkdirSync(shots, { recursive: true });
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
  });
}

export async function stop() {
  await browser.close();
}

/** A view of a page; whatever goes wrong in it, and every request that is not for the file itself, ends up in `troubles`. */
export async function open(file, route = "#/", options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  page.troubles = [];
  page.on("console", (message) => { if (message.type() === "error") page.troubles.push(message.text()); });
  page.on("pageerror", (error) => page.troubles.push(String(error)));
  page.on("request", (request) => { if (!request.url().startsWith(`file://${file}`) && !request.url().startsWith("data:")) page.troubles.push(`request: ${request.url()}`); });
  // SLOWER=10 makes the browser ten times as slow: what a test does not wait for shows then.
  if (process.env.SLOWER) await (await context.newCDPSession(page)).send("Emulation.setCPUThrottlingRate", { rate: Number(process.env.SLOWER) });
  await show(page, file, route);
  return page;
}

/** Loads a view into a page that is there: a fresh one costs more than a second on a machine of two cores. */
export async function show(page, file, route) {
  await page.goto("about:blank");  // else only the fragment changes, and the view before may still be there
  await page.goto(`file://${file}${route}`);
  await page.waitForSelector("#app[data-ready]", { timeout: 120_000 });
}

/** Runs `act` in a page of its own, and then asks that nothing went wrong in it. */
export async function looking(file, route, options, act) {
  const page = await open(file, route, options);
  await act(page);
  assert.deepEqual(page.troubles, []);
  await page.context().close();
}

/** Asserts again and again until it holds: what a click or a key does is drawn some time after it. */
export async function eventually(assertion) {
  const end = Date.now() + 20_000;
  for (;;) {
    try {
      return await assertion();
    } catch (failure) {
      if (Date.now() > end) throw failure;
      await pause(20);
    }
  }
}

/** What axe-core finds against the page, of all rules or of some. */
export async function violations(page, rules = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]) {
  await page.addScriptTag({ path: axeFile });
  const found = await page.evaluate((runOnly) => window.axe.run(document, { runOnly, resultTypes: ["violations"] }), rules);
  return found.violations.map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => `${n.target} ${n.failureSummary}`).join(" | ")}`);
}

export function run(...command) {
  return execFileSync(owlint, command, { encoding: "utf8" });
}
