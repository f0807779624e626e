// By keyboard alone: gestures of one's own, rules, curves, poses that are tried and turned, the ball, views, what makes it
// all, and projects.
import assert from "node:assert/strict";
import {has} from "./authoring.mjs";
import {projectOf, sentence, undrawn, visit} from "./visit.mjs";
import {tabTo} from "./by_keyboard.mjs";

const documentOf = async page => (await projectOf(page)).project.document;
const named = name => at => at.name === name;
const says = (page, words) => page.waitForFunction(part => document.querySelector(".messages").textContent.includes(part), words);
const press = async (page, ...keys) => { for (const key of keys) await page.keyboard.press(key); };
const focusOn = (page, name) => tabTo(page, named(name));

async function ownGestures(page) {
  await press(page, "i");
  await focusOn(page, "Add own");
  await press(page, "Enter");
  await page.locator("dialog[open] input:focus").waitFor();
  await page.keyboard.type("By keys");
  await press(page, "Enter");
  await says(page, "By keys is in the library");
  await page.waitForFunction(() => document.activeElement.textContent === "Add own", null, {timeout: 5000});  // where it was
  await tabTo(page, at => at.kind.includes("tile"));
  await press(page, "Delete");
  await says(page, "is deleted");
  await focusOn(page, "Bring it back");
  await press(page, "Enter");
  await says(page, " is in the library");
  await tabTo(page, named("All"), "Shift+Tab");
  await press(page, "Enter", "Escape");
}

async function rules(page) {
  const before = await page.locator(".control.pose").count();
  await focusOn(page, "Rules");
  await press(page, "Enter");
  await page.locator("dialog[open]").waitFor();
  await focusOn(page, "Add a rule");
  await press(page, "Enter");
  await page.waitForFunction(() => document.activeElement.matches(".rule input"));
  await press(page, "Control+a");
  await page.keyboard.type("hall");
  await page.keyboard.press("Tab");
  await page.keyboard.type("b"); // the first gesture that begins so
  await page.locator(".rule:last-child .chip").waitFor();
  await focusOn(page, "Save and put gestures");
  await press(page, "Enter");
  await says(page, "put by rules");
  assert.ok(await page.locator(".control.pose").count() > before);
  await press(page, "Control+z");
  assert.equal(await page.locator(".control.pose").count(), before);
}

async function curves(page) {
  await tabTo(page, at => at.kind === "ruler");
  await press(page, "Home", "s");
  await tabTo(page, at => at.name.startsWith("Speed: value"), "Shift+Tab");
  await page.keyboard.type("c");
  await tabTo(page, named("Speed, point 2 of 2"), "Shift+Tab");
  await press(page, "PageUp", "ArrowUp", "ArrowLeft", "Shift+Tab");
  await press(page, "Enter");
  await page.waitForFunction(() => document.activeElement.getAttribute("aria-label") === "Speed, point 2 of 3");
  await press(page, "ArrowDown", "ArrowDown");
  const {speed} = (await documentOf(page)).styleControls[0];
  assert.deepEqual([speed.length, speed[2].value], [3, 1.1]);
  assert.ok(speed[2].at < 1 && speed[1].value < 0.5, JSON.stringify(speed));
  await press(page, "Delete");
  assert.equal((await documentOf(page)).styleControls[0].speed.length, 2);
  assert.match(await page.evaluate(() => document.activeElement.getAttribute("aria-label")), /^Speed, point/, "the focus stays in the curve");
}

async function trying(page) {
  await press(page, "Escape", "Escape");
  await tabTo(page, at => at.kind === "ruler");
  await press(page, "End");
  const before = await documentOf(page);
  await press(page, "t", "r");
  await focusOn(page, "Turn: Left forearm").catch(() => tabTo(page, named("Turn: Left forearm"), "Shift+Tab"));
  await press(page, "ArrowUp", "ArrowUp", "Shift+ArrowRight");
  await page.getByText("Trying a pose (1 of 1)").waitFor();
  await press(page, "Escape");
  assert.deepEqual(await documentOf(page), before);
  await press(page, "t");
  await focusOn(page, "Turn: Left forearm").catch(() => tabTo(page, named("Turn: Left forearm"), "Shift+Tab"));
  await press(page, "ArrowUp", "k");
  assert.equal((await documentOf(page)).poseControls.length, before.poseControls.length + 1);
  await press(page, "r", "Control+z");
  assert.deepEqual(await documentOf(page), before);
}

async function pointing(page) {
  await press(page, "b");
  await tabTo(page, named("Ball to point at")).catch(() => tabTo(page, named("Ball to point at"), "Shift+Tab"));
  const at = () => page.locator(".triple input").evaluateAll(all => all.map(one => Number(one.value)));
  const first = await at();
  await press(page, "ArrowRight", "ArrowRight", "ArrowUp", "Shift+ArrowUp");
  const moved = await at();
  assert.ok(moved[0] > first[0] && moved[1] > first[1] && moved[2] < first[2], `${first} to ${moved}`);
  await page.getByText(/hand, [\d.]+° off/).waitFor();
  await tabTo(page, named("Left (m)"), "Shift+Tab").catch(() => {});
  await tabTo(page, at => at.name.startsWith("Point here at"));
  await press(page, "Enter");
  assert.match((await documentOf(page)).poseControls.at(-1).name, /^Point: /);
  await press(page, "Escape");
  assert.equal(await page.locator(".handle.ball").count(), 0);
}

async function views(page) {
  for (const [key, camera] of [["5", "across"], ["6", "beside"], ["1", "front"]]) {
    await press(page, key);
    await page.waitForFunction(wanted => document.querySelector(".views select").value === wanted, camera);
  }
}

async function systems(page) {
  await tabTo(page, at => at.kind.includes("options"));
  await press(page, "Enter");
  await page.locator("dialog[open]").waitFor();
  await page.waitForTimeout(100);
  await tabTo(page, at => at.tag === "INPUT");
  const others = await page.getByRole("radio").count() - 1;
  for (let k = 0; k < others; ++k) await press(page, "ArrowDown");
  await press(page, "Escape");
  await page.locator("dialog[open]").waitFor({state: "detached"});
  assert.equal(await page.locator(".style-track").count(), 0, "keyframes have no style");
  for (let k = 0; k < others; ++k) await press(page, "Control+z");
  assert.equal(await page.locator(".style-track").count(), 1);
}

async function projects(page) {
  await focusOn(page, "Projects");
  await press(page, "Enter");
  await page.locator("dialog[open]").waitFor();
  await focusOn(page, "Save here");
  await press(page, "Enter");
  await says(page, "saved on the server");
}

export async function authoringByKeys(place) {
  const {page, context, said} = await visit(place, {script: undrawn});
  await tabTo(page, at => at.id === "text");
  await page.keyboard.type(sentence);
  await press(page, "Control+Enter");
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  await page.getByRole("button", {name: "Pause"}).waitFor();
  await tabTo(page, at => at.kind === "ruler");
  await press(page, " ");
  const offers = {ownGestures: await has(page, "Add own"), rules: await has(page, "Rules"), curves: true, trying: true,
    pointing: await has(page, "Point"), views: true, systems: await page.locator(".options").count() > 0, projects: await has(page, "Projects")};
  for (const [name, check] of Object.entries({ownGestures, rules, curves, trying, pointing, views, systems, projects}))
    if (offers[name]) await check(page);
  assert.deepEqual(said, []);
  await context.close();
  return `done by keys: ${Object.keys(offers).filter(name => offers[name]).join(", ")}`;
}
