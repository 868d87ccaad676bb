// The page of an audit of the corpus and all fixtures: what a reader does with it.
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { dataOf, eventually, fixableIn, looking, open, programIn, shopPage, shots, start, stop } from "./browser.mjs";

let file;
let data;

before(async () => { file = shopPage(); data = dataOf(file); await start(); });
after(stop);

const reading = (route, options, act) => looking(file, route, options, act);
const rows = (page) => page.locator(".row");
const found = async (page) => Number((await page.locator(".found").textContent()).split(" ")[0].replaceAll(",", ""));
const phone = { viewport: { width: 360, height: 740 }, hasTouch: true };
const program = (name, query) => programIn(data, name, query);
const fixable = (code) => fixableIn(data, code);
const says = (locator, pattern) => eventually(async () => assert.match(await locator.innerText({ timeout: 1000 }), pattern));
const counts = (locator, n) => eventually(async () => assert.equal(await locator.count(), n));

/** Waits until there are rows, and each of them fits. */
const allRows = (page, pattern) => eventually(async () => {
  const texts = await rows(page).allInnerTexts();
  assert.ok(texts.length > 0);
  for (const text of texts) assert.match(text, pattern);
});

/** Waits until the focus is on what the selector names. */
const focused = (page, selector) => page.waitForFunction((wanted) => document.activeElement?.matches(wanted), selector);

test("the overview says how many programs stop, what is new and what is gone", () => reading("#/", {}, async (page) => {
  assert.match(await page.title(), /owlint audit/);
  await says(page.locator(".totals"), /programs have errors/);
  await says(page.locator(".panel", { hasText: "New and gone" }), /new\.ngc/);
  await page.getByText("1 finding gone").click();
  await says(page.locator("ul.gone"), /old\.ngc/);
  await page.getByText("All runs as a table").click();
  await counts(page.locator("details table tbody tr"), 2);
  await page.screenshot({ path: join(shots, "overview.png") });
}));

test("folders are gone down and up", () => reading("#/", {}, async (page) => {
  await page.getByRole("link", { name: "fixtures/" }).click();
  await page.getByRole("link", { name: "OW104/" }).click();
  await says(page.locator(".steps"), /all \/ fixtures \/ OW104/);
  await page.getByRole("link", { name: "programs right here" }).click();
  await says(rows(page).first(), /fixtures\/OW104\//);
  await page.goBack();
  await page.getByRole("link", { name: "all", exact: true }).click();
  await page.getByRole("link", { name: "fixtures/" }).waitFor();
}));

test("findings are filtered, searched and sorted", () => reading("#/findings", {}, async (page) => {
  const fewer = (than) => eventually(async () => {
    const n = await found(page);
    assert.ok(n > 0 && n < than, `${n} of ${than}`);
    return n;
  });
  const all = await found(page);
  await allRows(page, /error/);  // the worst come first, unasked
  await page.getByLabel("Sort by", { exact: true }).selectOption("path");
  await eventually(async () => {
    const paths = await page.locator(".row .path bdi").allTextContents();
    assert.deepEqual(paths.map((path) => path.split(":")[0]), [...paths].map((path) => path.split(":")[0]).sort());
  });
  await page.getByLabel("Sort by", { exact: true }).selectOption("");
  await page.getByLabel("Severity", { exact: true }).selectOption("errors");
  const errors = await fewer(all);
  await page.getByLabel("Rule", { exact: true }).selectOption({ value: "OW104" });
  await fewer(errors);
  await allRows(page, /OW104/);
  await page.getByLabel("Rule", { exact: true }).selectOption("");
  await page.getByLabel("Severity", { exact: true }).selectOption("");
  await eventually(async () => assert.equal(await found(page), all));
  await page.getByLabel("Search").fill("NEW.ngc");
  await fewer(all);
  await allRows(page, /new\.ngc/);
  await page.getByLabel("Search").fill("no such words");
  await page.getByText("No finding fits.").waitFor();
  await page.getByLabel("Search").fill("");
  await page.getByLabel("Sort by", { exact: true }).selectOption("rule");
  await says(rows(page).first(), /OW[01]\d\d/);
  await page.getByLabel("State", { exact: true }).selectOption("new");
  await allRows(page, /(new|modes|arc)\.ngc|unused\.ini/);  // also of an INI that has come since
  await page.screenshot({ path: join(shots, "findings.png") });
}));

test("a finding leads to its line, with what LinuxCNC says and the rule beside it", () => reading("#/findings?q=keyslots-copied-label", {}, async (page) => {
  await rows(page).locator("a").first().click();
  const line = page.locator("li.chosen[data-line='33']");
  await says(line, /LinuxCNC says/);
  await says(line.locator("mark.error").first(), /^o130$/);
  await says(page.locator("aside"), /OW104 if-label-reused/);
  await line.getByRole("link", { name: "line 16" }).click();
  await page.locator("li.chosen[data-line='16']").waitFor();
  await page.screenshot({ path: join(shots, "program.png") });
}));

test("a finding in the boxes of the blocks leads to its line", () => reading("#/findings?q=keyslots-copied-label", {}, async (page) => {
  await rows(page).locator("a").first().click();
  await page.getByRole("link", { name: "Blocks" }).click();
  const box = page.locator(".blocks .box.error");
  await says(box.locator(".head").first(), /o130 if .*lines 33 to \d+/s);
  await page.screenshot({ path: join(shots, "blocks.png") });
  await box.locator(".finding a").click();
  await focused(page, "li.chosen[data-line='33']");
  const line = page.locator("li.chosen[data-line='33']");
  await eventually(async () => assert.ok(await line.evaluate((element) => element.getBoundingClientRect().top < innerHeight)));
}));

test("beside its lines stands how far a program goes", () => reading(program("longer-than-the-axis.ngc"), {}, async (page) => {
  const extents = page.locator(".extents");
  await says(extents, /Extents in mm/);
  await says(extents.locator("tbody tr").first(), /X\s+0\s+600/);
  await extents.getByRole("link", { name: "600" }).click();
  await eventually(async () => assert.match(page.url(), /line=8/));
}));

test("blocks are boxes in each other, with what they call and what is found in them", () => reading(program("new.ngc", "?view=blocks"), {}, async (page) => {
  const main = page.locator(".blocks > .box.scope", { hasText: "main program" });
  await says(main.locator("> .head"), /main program/);
  await says(main.locator("> ul > .call"), /calls o<probe> line 8 · sub on line 1/);
  await says(main.locator("> ul > .box > .head"), /o100 if \[1\] lines 9 to/);
  await says(page.locator(".blocks > .box.scope", { hasText: "o<probe> sub" }).locator("> ul > .box > ul > .call"), /calls o<touch> line 3 · sub on line 6/);
  assert.ok((await main.locator(".finding.error").count()) > 0);
  await main.locator("> ul > .call a").last().click();
  await page.locator("li.chosen[data-line='1']").waitFor();
}));

test("drawings can be read, on a phone as well", async () => {
  for (const options of [{}, phone]) {
    await reading(program("new.ngc", "?view=blocks"), options, async (page) => {
      await page.locator(".blocks .box").first().waitFor();
      for (const words of await page.locator(".blocks a, .blocks code").all()) {
        assert.ok(Number.parseFloat(await words.evaluate((element) => getComputedStyle(element).fontSize)) >= 12);
      }
    });
    await reading(program("calling.ngc", "?view=calls"), options, async (page) => {
      const node = page.locator(".drawing g.node", { hasText: "called.ngc" }).locator("text").first();
      await eventually(async () => assert.ok((await node.boundingBox()).height >= 11, "large enough"));
      assert.equal(await node.textContent(), "called.ngc");  // its name, not its folder
    });
  }
});

test("the call graph leads to the called program", () => reading(program("calling.ngc"), {}, async (page) => {
  await page.getByRole("link", { name: "Calls" }).click();
  await page.locator(".drawing g.node.here").waitFor();
  const width = () => page.locator(".drawing svg").evaluate((svg) => svg.getBoundingClientRect().width);
  const drawn = await width();
  await page.getByRole("button", { name: "larger" }).click();
  await eventually(async () => assert.ok((await width()) > drawn));
  await page.getByRole("button", { name: "whole" }).click();
  await eventually(async () => assert.equal(Math.round(await width()), Math.round(drawn)));
  await page.screenshot({ path: join(shots, "calls.png") });
  await page.locator(".drawing g.node", { hasText: "called.ngc" }).click();
  await page.locator("h1", { hasText: "called.ngc" }).waitFor();
  await says(page.locator("aside"), /Called by/);
}));

test("everything can be done by keyboard", () => reading("#/", {}, async (page) => {
  const press = (key) => page.keyboard.press(key);
  await press("Tab");
  await focused(page, ".skip");
  await press("/");
  await page.locator("h1", { hasText: "Findings" }).waitFor();
  await press("/");
  await focused(page, "#search");
  await page.keyboard.type("keyslots-copied");
  await counts(rows(page), 1);
  await press("Escape");
  const focusOn = async (selector) => {
    for (let i = 0; i < 60; ++i) {
      await press("Tab");
      if (await page.evaluate((wanted) => document.activeElement?.matches(wanted), selector)) return;
    }
    assert.fail(`Tab does not get to ${selector}`);
  };
  await focusOn(".row a");
  await press("Enter");
  await focused(page, "li.chosen");
  await page.locator("#main").focus();
  await focusOn(".tabs a:not([aria-current])");
  await press("Enter");
  await page.locator(".blocks .box.error").waitFor();
  await focusOn(".finding a");
  await press("Enter");
  await focused(page, "li.chosen[data-line='33']");
  await page.goBack();
  await page.locator(".blocks .box.error").waitFor();
  await page.goto(`${page.url().split("#")[0]}${program("calling.ngc", "?view=calls")}`);
  await page.locator(".drawing g.node.here").waitFor();
  await focusOn(".drawing");
  await press("+");
  await press("0");
  await focusOn("g.node:not(.here)");
  await press("Enter");
  await page.locator("h1", { hasText: "called.ngc" }).waitFor();
}));

test("arrows, Page, Home and End move through a list", () => reading("#/programs", {}, async (page) => {
  await page.locator(".row a").first().focus();
  const at = () => page.evaluate(() => Number(document.activeElement.closest(".row")?.dataset.index ?? -1));
  const arrives = (expected) => eventually(async () => assert.ok(expected(await at()), `at ${await at()}`));
  await page.keyboard.press("ArrowDown");
  await arrives((row) => row === 1);
  await page.keyboard.press("PageDown");
  await arrives((row) => row > 3);
  await page.keyboard.press("End");
  const last = (await found(page)) - 1;
  await arrives((row) => row === last);
  await page.keyboard.press("Home");
  await arrives((row) => row === 0);
}));

test("dark colours come from the system, or from the switch", async () => {
  await reading("#/", { colorScheme: "dark" }, async (page) => {
    const back = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const dark = await back();
    await page.screenshot({ path: join(shots, "dark.png") });
    await page.getByRole("button", { name: "light colours" }).click();
    await eventually(async () => assert.notEqual(await back(), dark));
    await page.getByRole("button", { name: "dark colours" }).click();
    await eventually(async () => assert.equal(await back(), dark));
  });
});

test("a phone shows all of it without scrolling sideways", async () => {
  for (const [name, route] of [["overview", "#/"], ["findings", "#/findings"], ["programs", "#/programs"], ["program", "#/program/3?line=2"], ["fix", fixable("OW304")], ["blocks", program("new.ngc", "?view=blocks")], ["calls", program("calling.ngc", "?view=calls")], ["rule", "#/rule/OW104"]]) {
    await reading(route, phone, async (page) => {
      await page.locator("h1, .totals").first().waitFor();
      await page.waitForTimeout(200);  // what comes late must not widen it either
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360, name);
      await page.screenshot({ path: join(shots, `phone-${name}.png`) });
    });
  }
});

test("a path that does not fit loses its front, never the name of the file", () => reading("#/programs?q=fixtures", phone, async (page) => {
  await rows(page).first().waitFor();
  const paths = await page.locator(".row .path").evaluateAll((all) => all.map((path) => {
    const [box, text] = [path.getBoundingClientRect(), path.querySelector("bdi").getBoundingClientRect()];
    return { cut: text.left < box.left - 1, end: text.right <= box.right + 1 };
  }));
  assert.ok(paths.some(({ cut }) => cut), "some are cut");
  assert.ok(paths.every(({ end }) => end), "all show their end");
}));

test("filters are folded on a phone", () => reading("#/findings", phone, async (page) => {
  await page.getByLabel("Severity", { exact: true }).waitFor({ state: "hidden" });
  await page.getByText("Filter and sort").click();
  await page.getByLabel("Severity", { exact: true }).selectOption("errors");
  await page.getByText("Filter and sort (1 chosen)").waitFor();
  await allRows(page, /error/);
}));

test("errors have a scale of their own beside warnings", () => reading("#/", {}, async (page) => {
  for (const [of, label] of [["errors", "errors"], ["warnings", "warnings"]]) {
    const drawn = await page.locator(`svg.trend.${of} circle`).evaluateAll((all) => all.map((circle) => Number(circle.getAttribute("cy"))));
    const counts = data.index.runs.map((run) => run[of]);
    assert.equal(drawn.length, counts.length);
    const [bottom, top] = await page.locator(`svg.trend.${of} line.grid`).evaluateAll((all) => all.map((line) => Number(line.getAttribute("y1"))));
    counts.forEach((n, i) => assert.ok(Math.abs(drawn[i] - (bottom - ((bottom - top) * n) / Math.max(...counts))) < 0.01, label));
  }
}));

test("there is one number of programs", () => reading("#/", {}, async (page) => {
  const { index } = data;
  const run = index.runs.at(-1);
  assert.equal(index.files.kind.filter((kind) => kind === 0).length, run.files);
  const words = `${run.files.toLocaleString("en")} programs`;
  await says(page.locator(".when"), new RegExp(words));
  await says(page.locator(".totals"), new RegExp(`of ${words}`));
  const inFolders = await page.locator("[aria-label='findings by folder'] tbody tr td:nth-child(2)").allTextContents();
  assert.equal(inFolders.reduce((n, text) => n + Number(text.replaceAll(",", "")), 0), run.files);
  await page.getByRole("link", { name: "Programs", exact: true }).click();
  await eventually(async () => assert.equal(await page.locator(".found").textContent(), words));
}));

test("fixes are shown as the lines that they change", () => reading(fixable("OW304"), {}, async (page) => {
  const fix = page.locator("li.chosen .fix").first();
  await says(fix, /Safe fix/);
  const lines = async (selector) => (await fix.locator(selector).allInnerTexts()).map((text) => text.trim());
  const [before, after] = [await lines("del"), await lines("ins")];
  const [number, ...words] = before[0].split(/\s*−\s*/);
  assert.equal(words.join("−").trim(), (await page.locator(`li[data-line='${number}'] > code`).innerText()).trim());
  assert.ok(after.length > 0 && after.every((line) => !before.includes(line)));
  await page.screenshot({ path: join(shots, "fix.png") });
}));

test("code has colours", async () => {
  for (const colorScheme of ["light", "dark"]) {
    await reading(program("keyslots-copied-label.ngc"), { colorScheme }, async (page) => {
      const colour = (selector) => page.locator(selector).first().evaluate((element) => getComputedStyle(element).color);
      const kinds = [".tok-oword", ".tok-keyword", ".tok-comment", ".tok-number", ".tok-word"];
      const colours = await Promise.all([...kinds.map((kind) => colour(`.source ${kind}`)), colour(".source")]);
      assert.equal(new Set(colours).size, colours.length, `${colours}`);
      await says(page.locator("li[data-line='33'] .tok-oword").first(), /^o130$/);
      await says(page.locator("li[data-line='33'] .tok-keyword").first(), /^if$/);
    });
  }
});

test("the findings of a program stand above its lines, the worst first", () => reading(program("new.ngc"), {}, async (page) => {
  const contents = page.locator(".contents li");
  await contents.first().waitFor();
  const levels = (await contents.allInnerTexts()).map((text) => (/error/.test(text) ? 2 : /warning/.test(text) ? 1 : 0));
  assert.deepEqual(levels, [...levels].sort((a, b) => b - a));
  await contents.first().locator("a").click();
  await page.locator("li.chosen").waitFor();
}));

test("an arc that does not fit is drawn beside its finding", async () => {
  for (const [name, options] of [["light", {}], ["dark", { colorScheme: "dark" }], ["phone", phone]]) {
    await reading(program("arc.ngc", "?line=3"), options, async (page) => {
      const drawing = page.locator("li.chosen img.arc");
      await drawing.waitFor();
      assert.match(await drawing.getAttribute("alt"), /start: X0 Y0; end: X20 Y0; center, as written: X10\.1 Y0.*radius that fits: 10 mm/);
      await eventually(async () => assert.ok(await drawing.evaluate((image) => image.complete && image.naturalWidth > 0)));
      await page.screenshot({ path: join(shots, `arc-${name}.png`) });
    });
  }
});

test("the drawing has the colours of the page", () => reading(program("arc.ngc", "?line=3"), {}, async (page) => {
  const corner = () => page.locator("li.chosen img.arc").evaluate(async (image) => {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 4;
    const context = canvas.getContext("2d");
    context.drawImage(image, -190, -4);
    return [...context.getImageData(0, 0, 1, 1).data].join();
  });
  await page.locator("li.chosen img.arc").waitFor();
  await eventually(async () => assert.equal(await corner(), "255,255,255,255"));
  await page.getByRole("button", { name: "dark colours" }).click();
  await eventually(async () => assert.equal(await corner(), "31,35,41,255"));
}));

test("lines tell of modes that the line above does not show", () => reading(program("modes.ngc"), {}, async (page) => {
  const note = (line) => page.locator(`li[data-line='${line}'] .note`);
  await says(note(4), /^distance mode G91$/);
  await says(note(8), /plane G17 or G18/);
  await counts(page.locator(".source .note"), 2);
}));

test("the chosen line shows all modes in effect, and where they were set", async () => {
  await reading(program("modes.ngc"), {}, async (page) => {
    await says(page.locator("aside .modes-panel"), /Choose a line/);
    await page.locator("li[data-line='4'] .number").click();
    await says(page.locator("aside .modes-panel"), /Modes on line 4[^]*distance mode\s*G91\s*leaves\.ngc:2/);
    await says(page.locator("aside .modes-panel"), /motion mode\s*G0\s*line 2/);
    await page.screenshot({ path: join(shots, "modes.png") });
    await page.keyboard.press("ArrowDown");
    await says(page.locator("aside .modes-panel h2"), /line 5/);
    await page.locator("aside .modes-panel").getByRole("link", { name: "leaves.ngc:2" }).click();
    await page.locator("h1", { hasText: "leaves.ngc" }).waitFor();
  });
  await reading(program("modes.ngc", "?line=10"), {}, (page) => says(page.locator("aside .modes-panel"), /No run gets to this line/));
  await reading(program("modes.ngc", "?line=8"), { ...phone, colorScheme: "dark" }, async (page) => {
    await says(page.locator("li.chosen .modes-panel"), /distance mode\s*G90 or G91/);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
    await page.screenshot({ path: join(shots, "phone-modes.png") });
  });
});

test("INIs that no program uses are checked as well", () => reading("#/findings?q=unused.ini", {}, (page) => allRows(page, /unused\.ini/)));

test("on paper there are the findings and no controls", () => reading("#/findings?severity=2&q=OW1", {}, async (page) => {
  await page.emulateMedia({ media: "print" });
  await page.locator("ul.print-only li").first().waitFor();
  await counts(page.locator("ul.print-only li"), await found(page));
  for (const hidden of [".top", ".filters", ".list"]) await page.locator(hidden).waitFor({ state: "hidden" });
}));
