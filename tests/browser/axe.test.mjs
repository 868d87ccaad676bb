// What axe-core finds against the views of an audit's page. Light and dark differ in colours only.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { dataOf, fixableIn, looking, programIn, shopPage, show, start, stop, violations } from "./browser.mjs";

let file;
let routes;

before(async () => {
  file = shopPage();
  const data = dataOf(file);
  routes = ["#/", "#/findings", "#/programs", "#/program/3", "#/program/3?view=blocks", fixableIn(data, "OW304"), programIn(data, "new.ngc", "?line=9"), programIn(data, "modes.ngc", "?line=4"), programIn(data, "arc.ngc", "?line=3"), programIn(data, "new.ngc", "?view=blocks"), programIn(data, "calling.ngc", "?view=calls"), "#/rule/OW104", "#/findings?q=none-at-all", "#/program/999999"];
  await start();
});
after(stop);

const inColours = ["color-contrast", "link-in-text-block"];

test("axe-core finds nothing on any view, light or dark", () => looking(file, "#/", { colorScheme: "light" }, async (page) => {
  for (const route of routes) {
    await show(page, file, route);
    await page.locator(".blocks, .drawing svg, .source, .empty, .list, .rule, .totals").first().waitFor();
    assert.deepEqual(await violations(page), [], `light ${route}`);
    await page.emulateMedia({ colorScheme: "dark" });
    assert.deepEqual(await violations(page, inColours), [], `dark ${route}`);
    await page.emulateMedia({ colorScheme: "light" });
  }
}));
