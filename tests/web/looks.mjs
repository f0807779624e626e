// What it looks like and weighs: at two sizes, light and dark, and for those who cannot see it.
import assert from "node:assert/strict";
import fs from "node:fs";
import {createRequire} from "node:module";
import {generate, still, visit} from "./visit.mjs";

const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const mostBytes = 3e6;
const mostLoad_ms = 1000;

async function inspected(page, where) {
  // Over the protocol, past the page's policy.
  await page.evaluate(axe);
  const {violations} = await page.evaluate(() => globalThis.axe.run());
  const words = violations.map(one => `${one.impact}: ${one.id}: ${one.nodes.map(node => node.target.join(" ") + " " + node.failureSummary).join("; ")}`);
  assert.deepEqual(words.filter((_, k) => ["serious", "critical"].includes(violations[k].impact)), [], where);
  return violations.map(one => one.id);
}

// Nothing is wider or higher than the window, and no words of buttons are cut.
async function fits(page, where) {
  const found = await page.evaluate(() => {
    const {scrollWidth, scrollHeight, clientWidth, clientHeight} = document.documentElement;
    const cut = [...document.querySelectorAll(".button, h2, label, .state")].filter(one => one.checkVisibility() &&
        one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflow !== "visible").map(one => one.textContent);
    const boxes = [...document.querySelectorAll(".panel, .stage, .timeline, .header")].map(one => one.getBoundingClientRect());
    const over = boxes.filter(box => box.right > clientWidth + 0.5 || box.bottom > clientHeight + 0.5).length;
    const outside = [...document.querySelectorAll(".panel")].flatMap(panel => [...panel.querySelectorAll("button, input, select, textarea")]
        .filter(one => one.checkVisibility() && one.getBoundingClientRect().right > panel.getBoundingClientRect().right).map(one => one.outerHTML.slice(0, 80)));
    return {wide: scrollWidth > clientWidth, high: scrollHeight > clientHeight, cut, over, outside};
  });
  assert.deepEqual(found, {wide: false, high: false, cut: [], over: 0, outside: []}, where);
}

// Of windows that have nothing in their cache: bytes over the wire, and when the page was drawn and its avatar was there, in
// ms since the address was entered. The fastest of five, since other programs run beside it.
async function loaded(place) {
  const found = [];
  for (let k = 0; k < 5; ++k) {
    const {page, context} = await visit(place);
    await page.waitForFunction(() => performance.getEntriesByName("first-contentful-paint").length > 0);
    found.push(await page.evaluate(() => ({
      bytes: [...performance.getEntriesByType("resource"), ...performance.getEntriesByType("navigation")].reduce((sum, one) => sum + one.transferSize, 0),
      drawn_ms: performance.getEntriesByName("first-contentful-paint")[0].startTime, avatar_ms: performance.getEntriesByName("avatar")[0].startTime})));
    await context.close();
  }
  return found.sort((a, b) => a.avatar_ms - b.avatar_ms)[0];
}

export async function looks(place) {
  const minor = new Set();
  for (const [width, height] of [[1280, 720], [1920, 1080]])
    for (const dark of [false, true]) {
      const where = `${width}x${height}-${dark ? "dark" : "light"}`;
      const {page, context, said} = await visit(place, {width, height, dark});
      (await inspected(page, `${where}, empty`)).forEach(one => minor.add(one));
      await fits(page, `${where}, empty`);
      await page.screenshot({path: place.at(`empty-${where}.png`)});
      await generate(page);
      await still(page);
      await page.locator(".ruler").click({position: {x: 0.13 * width, y: 10}});
      await page.locator(".tile").nth(2).click();
      await page.locator(".ruler").click({position: {x: 0.5 * width, y: 10}});
      await page.keyboard.press("Escape");
      await page.getByRole("button", {name: "Happy"}).click();
      await page.getByRole("button", {name: "Close the message"}).click();
      await page.waitForTimeout(300);
      (await inspected(page, `${where}, style`)).forEach(one => minor.add(one));
      await fits(page, `${where}, style`);
      await page.screenshot({path: place.at(`style-${where}.png`)});
      await page.locator(".tile").nth(4).click();
      await page.locator(".word").nth(10).dblclick();
      await page.locator(".control.pose").nth(1).click();
      await page.waitForTimeout(700);
      (await inspected(page, `${where}, pose`)).forEach(one => minor.add(one));
      await fits(page, `${where}, pose`);
      await page.screenshot({path: place.at(`pose-${where}.png`)});
      await page.keyboard.press("?");
      (await inspected(page, `${where}, help`)).forEach(one => minor.add(one));
      await page.screenshot({path: place.at(`help-${where}.png`)});
      assert.deepEqual(said, [], where);
      await context.close();
    }
  const {bytes, drawn_ms, avatar_ms} = await loaded(place);
  assert.ok(bytes > 0 && bytes <= mostBytes, `${bytes} bytes over the wire`);
  if (!process.env.DEIXIS_SLOW_MACHINE) assert.ok(avatar_ms < mostLoad_ms, `the avatar is there after ${avatar_ms.toFixed(0)} ms`);
  return `axe finds nothing serious (minor: ${[...minor].join(", ") || "none"}); ${(bytes / 1e6).toFixed(2)} MB over the wire; ` +
      `drawn after ${drawn_ms.toFixed(0)} ms, with its avatar after ${avatar_ms.toFixed(0)} ms`;
}
