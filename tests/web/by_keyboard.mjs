// A session by keyboard alone: the mouse is never used, and the focus is always seen.
import assert from "node:assert/strict";
import fs from "node:fs";
import {projectOf, sentence, undrawn, visit} from "./visit.mjs";

const focused = page => page.evaluate(() => {
  const at = document.activeElement;
  const {outlineStyle, outlineWidth} = getComputedStyle(at);
  return {id: at.id, kind: at.className?.baseVal ?? at.className, name: at.getAttribute("aria-label") ?? at.textContent, tag: at.tagName,
    seen: at === document.body || outlineStyle !== "none" && parseFloat(outlineWidth) >= 2};
});

// Tab until something has the focus; each stop on the way must be seen.
export async function tabTo(page, wanted, key = "Tab") {
  const way = [];
  for (let k = 0; k < 80; ++k) {
    await page.keyboard.press(key);
    const at = await focused(page);
    assert.ok(at.seen, `the focus on ${at.tag} ${at.name} is seen`);
    if (wanted(at)) return at;
    way.push(at.name);
  }
  throw new Error(`Tab does not lead there, but to ${way.join(", ")}`);
}

const labels = page => page.locator(".control > .hidden").allTextContents();

export async function byKeyboard(place) {
  const {page, context, said} = await visit(place, {script: undrawn});
  await tabTo(page, at => at.id === "text");
  await page.keyboard.type(`${sentence} ${sentence}`); // room for a gesture twice
  await page.keyboard.press("Control+Enter");
  await page.locator(".word").first().waitFor();
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  await page.getByRole("button", {name: "Pause"}).waitFor();

  // The playhead: stopped, then put on the third word.
  await tabTo(page, at => at.name === "Playhead");
  await page.keyboard.press("Space");
  await page.keyboard.press("Home");
  for (let k = 0; k < 5; ++k) await page.keyboard.press("Control+ArrowRight");
  assert.match(await page.getByRole("slider", {name: "Playhead"}).getAttribute("aria-valuetext"), /seconds/);

  // From the library: searched, chosen by arrows, added.
  await tabTo(page, at => at.name === "Search gestures", "Shift+Tab");
  await page.keyboard.type("rais");
  await tabTo(page, at => at.kind.includes("tile"));
  await page.keyboard.press("ArrowRight");
  assert.match((await focused(page)).kind, /tile/);
  await page.keyboard.press("Enter");
  await page.locator(".control.pose").waitFor();
  const [added] = await labels(page);

  // Moved, stretched, flipped.
  await tabTo(page, at => at.kind.includes("control pose"));
  const times = async () => (await labels(page))[0].match(/([\d.]+) to ([\d.]+) s/).slice(1).map(Number);
  const first = await times();
  for (let k = 0; k < 3; ++k) await page.keyboard.press("Control+ArrowRight");
  const moved = await times();
  assert.ok(Math.abs(moved[0] - first[0] - 0.2) < 0.011, `moved by three frames: ${first} ${moved}`);
  for (let k = 0; k < 3; ++k) await page.keyboard.press("Shift+ArrowRight");
  const longer = await times();
  assert.ok(longer[0] === moved[0] && Math.abs(longer[1] - moved[1] - 0.2) < 0.011, "stretched by three frames");
  await page.keyboard.press("f");
  assert.match((await labels(page))[0], /flipped/);
  assert.match((await focused(page)).kind, /control pose/, "the focus stays on the control");

  // Copied to the end, and the copy deleted.
  await page.keyboard.press("Control+c");
  await page.keyboard.press("End");
  await page.keyboard.press("Control+v");
  await page.waitForFunction(() => document.querySelectorAll(".control.pose").length === 2);
  await page.keyboard.press("Delete");
  await page.waitForFunction(() => document.querySelectorAll(".control.pose").length === 1);

  // Its pose, by a handle on the avatar.
  await tabTo(page, at => at.kind.includes("control pose"), "Shift+Tab").catch(() => tabTo(page, at => at.kind.includes("control pose")));
  await page.keyboard.press("Enter");
  const base = async () => (await projectOf(page)).project.document.poseControls[0].base[0];
  const untouched = await base();
  await tabTo(page, at => at.name === "Right wrist of the pose", "Shift+Tab");
  for (let k = 0; k < 4; ++k) {
    await page.keyboard.press("ArrowUp");
    await page.waitForTimeout(60);
  }
  assert.notDeepEqual(await base(), untouched, "the arrows move the wrist");

  // A style over a marked word.
  await tabTo(page, at => at.kind.startsWith("word"));
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+Enter");
  await page.locator(".range").waitFor();
  await page.keyboard.press("s");
  await page.locator(".control.style").waitFor();
  await tabTo(page, at => at.id === "slider-speed", "Shift+Tab");
  for (let k = 0; k < 5; ++k) await page.keyboard.press("ArrowRight");
  assert.match((await labels(page)).at(-1), /speed 0\.5, space free/);

  // Undone and done again.
  await page.keyboard.press("Control+z");
  assert.match((await labels(page)).at(-1), /speed 0\.0/);
  await page.keyboard.press("Control+Shift+z");
  assert.match((await labels(page)).at(-1), /speed 0\.5/);

  // Generated inside the range, then the motion out.
  await page.keyboard.press("Control+Shift+Enter");
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  await page.keyboard.press("Control+Home");
  await tabTo(page, at => at.name === "BVH", "Shift+Tab");
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
  assert.ok(fs.readFileSync(await download.path(), "utf8").startsWith("HIERARCHY"));
  assert.match(await page.getByRole("status").first().textContent(), /./);

  // The help opens, is closed, and gives the focus back.
  await page.keyboard.press("?");
  await page.locator("dialog[open]").waitFor();
  await page.keyboard.press("Escape");
  await page.locator("dialog[open]").waitFor({state: "hidden"});
  assert.equal((await focused(page)).name, "BVH");
  assert.deepEqual(said, []);
  await context.close();
  return `typed, generated, added ${JSON.stringify(added)}, moved, stretched, flipped, posed, styled, undone, exported`;
}
