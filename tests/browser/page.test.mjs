// The page of an audit of the corpus and all fixtures: what a reader does with it.
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { eventually, open, shopPage, shots, start, stop, violations } from "./browser.mjs";

let file;

before(async () => { file = shopPage(); await start(); });
after(stop);

/** Runs `act` in a page of its own, and then asks that nothing went wrong in it. */
async function reading(route, options, act) {
  const page = await open(file, route, options);
  await act(page);
  assert.deepEqual(page.troubles, []);
  await page.context().close();
}

const rows = (page) => page.locator(".row");
const found = async (page) => Number((await page.locator(".found").textContent()).split(" of ")[0].replaceAll(",", ""));
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
  await says(page.locator(".totals"), /programs stop the machine/);
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
  await allRows(page, /new\.ngc/);
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

test("a node of the block graph leads to its line", () => reading("#/findings?q=keyslots-copied-label", {}, async (page) => {
  await rows(page).locator("a").first().click();
  await page.getByRole("link", { name: "Blocks" }).click();
  await page.locator(".drawing g.node.error").waitFor();
  await page.getByRole("button", { name: "larger" }).click();
  await page.getByRole("button", { name: "whole" }).click();
  await page.screenshot({ path: join(shots, "blocks.png") });
  await page.locator(".drawing g.node.error").click();
  await focused(page, "li.chosen[data-line='33']");
  const line = page.locator("li.chosen[data-line='33']");
  await eventually(async () => assert.ok(await line.evaluate((element) => element.getBoundingClientRect().top < innerHeight)));
}));

test("the call graph leads to the called program", () => reading("#/programs", {}, async (page) => {
  await page.getByLabel("Search").fill("calling");
  await counts(rows(page), 1);
  await rows(page).locator("a").first().click();
  await page.getByRole("link", { name: "Calls" }).click();
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
  await page.locator(".drawing g.node.error").waitFor();
  await focusOn(".drawing");
  await press("+");
  await press("ArrowLeft");
  await press("0");
  await focusOn("g.node.error");
  await press("Enter");
  await focused(page, "li.chosen[data-line='33']");
  await page.goBack();
  await page.locator(".drawing svg").waitFor();
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
  for (const [name, route] of [["overview", "#/"], ["findings", "#/findings"], ["programs", "#/programs"], ["program", "#/program/3?line=2"], ["rule", "#/rule/OW104"]]) {
    await reading(route, { viewport: { width: 360, height: 740 }, hasTouch: true }, async (page) => {
      await page.locator("h1, .totals").first().waitFor();
      await page.waitForTimeout(200);  // what comes late must not widen it either
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360, name);
      await page.screenshot({ path: join(shots, `phone-${name}.png`) });
    });
  }
});

test("on paper there are the findings and no controls", () => reading("#/findings?severity=2", {}, async (page) => {
  await page.emulateMedia({ media: "print" });
  await page.locator("ul.print-only li").first().waitFor();
  await counts(page.locator("ul.print-only li"), await found(page));
  for (const hidden of [".top", ".filters", ".list"]) await page.locator(hidden).waitFor({ state: "hidden" });
}));

test("axe-core finds nothing on any view, light or dark", async () => {
  for (const colorScheme of ["light", "dark"]) {
    for (const route of ["#/", "#/findings", "#/programs", "#/program/3", "#/program/3?view=blocks", "#/program/3?view=calls", "#/rule/OW104", "#/findings?q=none-at-all", "#/program/999999"]) {
      await reading(route, { colorScheme }, async (page) => {
        if (route.includes("view=blocks")) await page.locator(".drawing svg, .source, .empty").first().waitFor();
        assert.deepEqual(await violations(page), [], `${colorScheme} ${route}`);
      });
    }
  }
});
