// Names and contents that would like to be markup are text.
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { eventually, open, shopPage, shots, start, stop, violations } from "./browser.mjs";

const names = ["<script>alert(1)</script>".replace("/", "∕"), "a\nb", "quote\"'`&amp;", "\u202egcn.txt", "<img src=x onerror=alert(1)>", "=cmd|calc"];
let file;

before(async () => {
  file = shopPage((shop) => {
    for (const name of names) writeFileSync(join(shop, `${name}.ngc`), "(</script><script>window.hit = 1</script><!-- ]]>)\no<x\"><img src=x onerror=window.hit=1> if [1]\no1 if [1]\n(\u202e\u0007)\no1 endwhile\nM2\n");
    writeFileSync(Buffer.concat([Buffer.from(`${shop}/latin-`), Buffer.from([0xe4, 0xff]), Buffer.from(".ngc")]), Buffer.from([0x6f, 0x31, 0x20, 0x65, 0x6e, 0x64, 0x69, 0x66, 0xff, 0x0a]));
    let deep = shop;
    while (deep.length < 3700) {
      deep = join(deep, "x".repeat(200));
      mkdirSync(deep);
    }
    writeFileSync(join(deep, "deep.ngc"), "o100 endif\nM2\n");
  });
  await start();
});
after(stop);

test("hostile names and contents are shown as text", async () => {
  const page = await open(file, "#/programs");
  for (const words of ["<script>alert(1)<", "a⏎b", "quote\"'`&amp;", "⟨202e⟩gcn.txt", "<img src=x onerror=alert(1)>", "=cmd|calc", "latin-äÿ", "deep.ngc"]) {
    await page.getByLabel("Search").fill(words.replace("⏎", "�").replace("⟨202e⟩", "\u202e"));
    await eventually(async () => assert.equal(await page.locator(".row").count(), 1, `programs for ${words}`));
    await page.locator(".row a").first().click();
    await page.locator(".source").waitFor();
    assert.equal(await page.evaluate(() => window.hit), undefined);
    assert.equal(await page.locator("#main img, #main script").count(), 0);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 1280, words);
    if (words === "deep.ngc" || words.startsWith("<img")) assert.deepEqual(await violations(page), []);
    const blocks = page.getByRole("link", { name: "Blocks" });
    if (await blocks.count()) {
      await blocks.click();
      await page.locator(".blocks .box").first().waitFor();
      assert.equal(await page.locator(".blocks img, .blocks script").count(), 0);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 1280, words);
    }
    await page.goto(`${page.url().split("#")[0]}#/programs`);
    await page.locator(".row").nth(1).waitFor();
  }
  await page.screenshot({ path: join(shots, "hostile.png") });
  assert.deepEqual(page.troubles, []);
  await page.context().close();
});

test("hostile names fit on a phone", async () => {
  const page = await open(file, "#/programs?q=deep", { viewport: { width: 360, height: 740 } });
  await page.locator(".row a").first().click();
  await page.locator(".source").waitFor();
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  await page.context().close();
});
