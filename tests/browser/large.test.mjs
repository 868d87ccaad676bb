// A shop of 100,000 programs with 50,000 findings. The time is printed; the bounds only keep it from hanging.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { eventually, open, start, stop } from "./browser.mjs";
import { samplePage } from "./sample.mjs";

before(start);
after(stop);

test("100,000 programs with 50,000 findings can be used", async (t) => {
  const file = samplePage(100_000, 50_000);
  const started = Date.now();
  const page = await open(file, "#/findings");
  t.diagnostic(`loaded in ${Date.now() - started} ms`);
  assert.equal(await page.locator(".found").textContent(), "50,000 findings");
  assert.ok((await page.locator(".row").count()) < 60, "only what is in view is there");
  for (const words of ["part12", "ow508", "o77"]) {
    const took = await page.evaluate(async (text) => {
      const shown = () => document.querySelector(".found").textContent;
      const input = document.getElementById("search");
      const [before, started] = [shown(), performance.now()];
      input.value = text;
      input.dispatchEvent(new Event("input", { bubbles: true }));
      while (shown() === before && performance.now() < started + 5000) await new Promise((done) => requestAnimationFrame(done));
      return shown() === before ? -1 : performance.now() - started;
    }, words);
    assert.ok(took >= 0, `${words} filters nothing within five seconds`);
    t.diagnostic(`filtered by ${words} in ${Math.round(took)} ms`);
    assert.match(await page.locator(".found").textContent(), /^[1-9]/);
  }
  await page.goto(`${page.url().split("#")[0]}#/programs`);
  await eventually(async () => assert.equal(await page.locator(".found").textContent(), "100,000 programs"));
  await page.locator(".row a").first().focus();
  await page.keyboard.press("End");
  await page.waitForFunction(() => Number(document.activeElement.closest(".row")?.dataset.index) === 99_999);
  await page.goto(`${page.url().split("#")[0]}#/`);
  await page.getByRole("link", { name: "customer000/" }).waitFor();
  assert.deepEqual(page.troubles, []);
  await page.context().close();
});
