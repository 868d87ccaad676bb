// The page is mailed and put on servers: it names files as they are seen from the audited folders, and nothing in it says where
// on which machine these are.
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { homedir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { auditOf, dataOf, eventually, open, scratch, start, stop } from "./browser.mjs";

let folder;
let file;
let data;

/** Two roots; a machine INI and a sub lie outside of both. A blank in a folder's name must not hide its end. */
before(async () => {
  folder = scratch();
  const write = (path, text) => {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), text);
  };
  write("my shop/mill.ini", "[RS274NGC]\nSUBROUTINE_PATH = common subs\n[DISPLAY]\nPROGRAM_PREFIX = ../nowhere\n");
  write("my shop/common subs/slot.ngc", "o<slot> sub\no100 if [1]\nG0 X1\no100 endif\no100 if [1]\no100 endif\no<slot> endsub\nM2\n");
  write("my shop/parts/plate.ngc", "o<slot> call [1]\no<absent> call [2]\no100 if [1]\nM2\n");
  write("my shop/parts/deep/er/flange.ngc", "o<tapped> call\no<slot> call [2]\nM2\n");
  write("my shop/parts/deep/er/tapped.ngc", "o<other> sub\no<other> endsub\nM2\n");
  write("macros/probe.ngc", "o<probe> sub\n#<x> = #<nothing>\no<probe> endsub\no<probe> call\n");
  write("macros/gone.ngc", "o100 endif\nM2\n");
  const roots = [join(folder, "my shop", "parts"), "macros"];
  auditOf(folder, ...roots);
  write("macros/gone.ngc", "M2\n");
  write("macros/new.ngc", "o100 endif\nM2\n");
  file = join(folder, "audit.html");
  auditOf(folder, ...roots, "--report", file);
  data = dataOf(file);
  await start();
});
after(stop);

/** All texts in some data. The lines of programs and INIs are their own, and the pages of rules are the same everywhere. */
function* texts(json, key = "") {
  if (key === "source" || key === "markdown") return;
  if (typeof json === "string") yield json;
  else if (json !== null && typeof json === "object") for (const [name, value] of Object.entries(json)) yield* texts(value, name);
}

test("no data of the page say where the machine has its files", () => {
  const all = JSON.stringify(data);
  for (const place of [folder, homedir(), process.cwd(), dirname(folder) + "/"]) {
    if (place.length > 1) assert.ok(!all.includes(place), `${place} is in the page`);
  }
  const absolute = [...texts(data)].filter((text) => /(^|[\s`"'(:=])\/[\w.]+\/[\w.]/.test(text));
  assert.deepEqual(absolute, []);
  for (const path of [...data.index.files.path, ...data.index.gone.path]) assert.ok(!path.startsWith("/"), path);
});

test("files are named from their root, and others by their last folder", () => {
  const { path, kind } = data.index.files;
  assert.deepEqual(data.index.roots, ["parts", "macros"]);
  assert.deepEqual(path.filter((_, i) => kind[i] === 0).sort(), ["macros/gone.ngc", "macros/new.ngc", "macros/probe.ngc", "parts/deep/er/flange.ngc", "parts/deep/er/tapped.ngc", "parts/plate.ngc"]);
  assert.deepEqual(path.filter((_, i) => kind[i] === 1), ["…/my shop/mill.ini"]);
  assert.deepEqual(path.filter((_, i) => kind[i] === 2), ["…/common subs/slot.ngc"]);
  assert.deepEqual(data.index.gone.path, ["macros/gone.ngc"]);
});

test("what stands in messages and beside them is named likewise", () => {
  const slot = data.index.files.path.indexOf("…/common subs/slot.ngc");
  const related = Object.values(data.details).flatMap(({ findings }) => findings).flatMap((finding) => finding.related);
  assert.ok(related.every((place) => place.file < 0 || data.index.files.path[place.file] === place.path));
  assert.ok(data.details[slot].findings.length > 0);
  assert.ok([...texts(data)].some((text) => text.includes("…/") && text.includes("nowhere")), "the folder that the INI names and nobody has");
});

test("INIs and subs from elsewhere are not counted as programs", async () => {
  const page = await open(file, "#/");
  const says = (selector, pattern) => eventually(async () => assert.match(await page.locator(selector).first().innerText(), pattern));
  await says("h1", /^parts, macros$/);
  await says(".when", /6 programs/);
  await says(".totals", /of 6 programs/);
  await page.getByRole("link", { name: "1 machine INI with findings" }).click();
  await says(".found", /^1 machine INI$/);
  await says(".row", /…\/my shop\/mill\.ini/);
  await page.getByLabel("Show").selectOption("outside");
  await says(".found", /^1 outside sub$/);
  await page.getByLabel("Show").selectOption("");
  await says(".found", /^6 programs$/);
  for (const f of data.index.files.path.keys()) {
    await page.goto(`file://${file}#/program/${f}`);
    await page.locator(".source, .empty").first().waitFor();
    assert.ok(!(await page.title()).includes("/tmp") && !(await page.innerText("body")).includes(folder));
  }
  assert.deepEqual(page.troubles, []);
  await page.context().close();
});
