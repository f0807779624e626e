// What it looks like and weighs: at two sizes, light and dark, and for those who cannot see it.
import assert from "node:assert/strict";
import fs from "node:fs";
import {createRequire} from "node:module";
import {generate, still, visit} from "./visit.mjs";

const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const mostBytes = 3e6;
const mostLoad_ms = 1000;

export async function inspected(page, where, part) {
  // Over the protocol, past the page's policy.
  await page.evaluate(axe);
  const {violations} = await page.evaluate(within => globalThis.axe.run(...within ? [within] : []), part);
  const words = violations.map(one => `${one.impact}: ${one.id}: ${one.nodes.map(node => node.target.join(" ") + " " + node.failureSummary).join("; ")}`);
  assert.deepEqual(words.filter((_, k) => ["serious", "critical"].includes(violations[k].impact)), [], where);
  return violations.map(one => one.id);
}

// Nothing is wider or higher than the window, and no words of buttons are cut.
export async function fits(page, where) {
  const found = await page.evaluate(() => {
    const {scrollWidth, scrollHeight, clientWidth, clientHeight} = document.documentElement;
    const cut = [...document.querySelectorAll(".button, h2, label, .state")].filter(one => one.checkVisibility() &&
        one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflow !== "visible").map(one => one.textContent);
    const boxes = [...document.querySelectorAll(".panel, .stage, .timeline, .header, .board")].map(one => one.getBoundingClientRect());
    const over = boxes.filter(box => box.right > clientWidth + 0.5 || box.bottom > clientHeight + 0.5).length;
    const outside = [...document.querySelectorAll(".panel")].flatMap(panel => [...panel.querySelectorAll("button, input, select, textarea")]
        .filter(one => one.checkVisibility() && one.getBoundingClientRect().right > panel.getBoundingClientRect().right).map(one => one.outerHTML.slice(0, 80)));
    return {wide: scrollWidth > clientWidth, high: scrollHeight > clientHeight, cut, over, outside};
  });
  assert.deepEqual(found, {wide: false, high: false, cut: [], over: 0, outside: []}, where);
}

// Of windows that have nothing in their cache: bytes over the wire, and when the page was drawn and its avatar was there, in
// ms since the address was entered. The fastest of three, since other programs run beside it.
async function loaded(place) {
  const found = [];
  for (let k = 0; k < 3; ++k) {
    const {page, context} = await visit(place);
    await page.waitForFunction(() => performance.getEntriesByName("first-contentful-paint").length > 0);
    found.push(await page.evaluate(() => ({
      bytes: [...performance.getEntriesByType("resource"), ...performance.getEntriesByType("navigation")].reduce((sum, one) => sum + one.transferSize, 0),
      drawn_ms: performance.getEntriesByName("first-contentful-paint")[0].startTime, avatar_ms: performance.getEntriesByName("avatar")[0].startTime})));
    await context.close();
  }
  return found.sort((a, b) => a.avatar_ms - b.avatar_ms)[0];
}

// The avatar is drawn for a picture only: a machine of tests draws in software, slowly.
function drawnOnDemand() {
  for (const name of ["drawElements", "drawArrays"]) {
    const draw = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function(...given) { if (globalThis.drawn) draw.apply(this, given); };
  }
}
async function picture(page, file) {
  const drawn = on => page.evaluate(now => new Promise(done => {
    globalThis.drawn = now;
    document.querySelector(".stage canvas").style.width = now ? "calc(100% - 1px)" : ""; // another size is drawn anew
    let frames = 4;
    requestAnimationFrame(function next() { if (--frames > 0) requestAnimationFrame(next); else done(); });
  }), on);
  await drawn(true);
  await page.screenshot({path: file});
  await drawn(false);
}

const button = (page, name) => page.getByRole("button", {name, exact: true});

// The states that the page is seen in, in the order of a session. Each leads there; those that fill the page are looked at
// in the larger window, too.
const states = [
  {name: "empty", lead: async () => {}},
  {name: "style", large: true, async lead(page, width) {
    await generate(page);
    await still(page);
    await page.locator(".ruler").click({position: {x: 0.13 * width, y: 10}});
    await page.locator(".tile").nth(2).click();
    await page.locator(".ruler").click({position: {x: 0.5 * width, y: 10}});
    await page.keyboard.press("Escape");
    await button(page, "Happy").click();
    await button(page, "Close the message").click();
  }},
  {name: "curve", lead: page => page.getByLabel("Space: value, curve or free").selectOption("curve")},
  {name: "pose", large: true, async lead(page) {
    await page.locator(".tile").nth(4).click();
    await page.locator(".word").nth(10).dblclick();
    await page.locator(".control.pose").nth(1).click();
    await page.getByRole("button", {name: "Left wrist of the pose"}).waitFor();
  }},
  {name: "trying", async lead(page) {
    await page.keyboard.press("t");
    await page.keyboard.press("r");
    await button(page, "Turn: Left upper arm").press("ArrowLeft");
  }},
  {name: "pointing", large: true, needs: "Point", async lead(page) {
    await page.keyboard.press("Escape");
    await page.keyboard.press("b");
    await page.getByText(/off\./).waitFor();
  }},
  {name: "across", async lead(page) {
    await page.getByLabel("View", {exact: true}).selectOption("across");
    await page.keyboard.press("Escape");
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
  }},
  {name: "beside", lead: page => page.getByLabel("View", {exact: true}).selectOption("beside")},
  {name: "own", needs: "Add own", dialog: true, lead: page => button(page, "Add own").click()},
  {name: "rules", large: true, needs: "Rules", dialog: true, async lead(page) {
    await button(page, "Rules").click();
    await button(page, "Add a rule").click();
    for (let k = 0; k < 2; ++k) await page.locator(".rule").last().getByRole("combobox").selectOption({index: 2});
  }, leave: page => page.locator("dialog[open]").getByRole("button", {name: "Cancel"}).click()},
  {name: "options", large: true, needs: ".options", dialog: true, lead: page => page.locator(".options").click()},
  {name: "projects", needs: "Projects", dialog: true, async lead(page) {
    await button(page, "Projects").click();
    await button(page, "Save here").click();
    await page.waitForFunction(() => document.querySelector(".messages").textContent.includes("saved on the server"));
    await button(page, "Projects").click();
    await page.locator(".project").first().waitFor();
  }},
  {name: "film", needs: "Film", dialog: true, lead: page => button(page, "Film").click()},
  {name: "help", dialog: true, lead: page => page.keyboard.press("?")},
];

// In each state axe looks at both schemes, in the smaller window: colours do not depend on its size.
async function seen(place, width, height, dark, minor) {
  const where = `${width}x${height}-${dark ? "dark" : "light"}`;
  const {page, context, said} = await visit(place, {width, height, dark, script: drawnOnDemand});
  for (const {name, needs, large, dialog, lead, leave} of states) {
    if (height > 720 && !large) continue;
    if (needs && await (needs.startsWith(".") ? page.locator(needs) : button(page, needs)).count() === 0) continue;
    await lead(page, width);
    if (dialog) await page.locator("dialog[open]").waitFor();
    await page.waitForTimeout(150);
    if (height === 720) (await inspected(page, `${where}, ${name}`, dialog ? "dialog[open]" : null)).forEach(one => minor.add(one));
    await fits(page, `${where}, ${name}`);
    await picture(page, place.at(`${name}-${where}.png`));
    if (leave) await leave(page);
    else if (dialog) await page.keyboard.press("Escape");
    if (dialog) await page.locator("dialog[open]").waitFor({state: "detached"});
  }
  assert.deepEqual(said, [], where);
  await context.close();
}

export async function looks(place) {
  const minor = new Set();
  for (const [width, height] of [[1280, 720], [1920, 1080]])
    for (const dark of [false, true]) await seen(place, width, height, dark, minor);
  const {bytes, drawn_ms, avatar_ms} = await loaded(place);
  assert.ok(bytes > 0 && bytes <= mostBytes, `${bytes} bytes over the wire`);
  if (!process.env.DEIXIS_SLOW_MACHINE) assert.ok(avatar_ms < mostLoad_ms, `the avatar is there after ${avatar_ms.toFixed(0)} ms`);
  return `axe finds nothing serious (minor: ${[...minor].join(", ") || "none"}); ${(bytes / 1e6).toFixed(2)} MB over the wire; ` +
      `drawn after ${drawn_ms.toFixed(0)} ms, with its avatar after ${avatar_ms.toFixed(0)} ms`;
}
