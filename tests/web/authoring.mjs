// By mouse: gestures of one's own, rules, curves of style, poses that are tried and turned, the ball, and what makes it all.
import assert from "node:assert/strict";
import fs from "node:fs";
import {drag, generate, middleOf, projectOf, sentence, still, undrawn, visit} from "./visit.mjs";

const button = (page, name, exact = true) => page.getByRole("button", {name, exact});
const said = (page, words) => page.waitForFunction(part => document.querySelector(".messages").textContent.includes(part), words);
const upToDate = page => page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
export const has = async (page, name) => await button(page, name).count() > 0;
const documentOf = async page => (await projectOf(page)).project.document;
const lastUndo = page => page.getByRole("button", {name: /^Undo/}).getAttribute("aria-label");

// What Generate asks for.
export async function asked(page) {
  const [request] = await Promise.all([page.waitForRequest("**/v1/generate"), button(page, "Generate").click()]);
  await upToDate(page);
  await still(page);
  return request.postDataJSON();
}

async function ownGestures(page) {
  await page.locator(".word").nth(3).dblclick();
  const {motion, range} = await documentOf(page);
  await button(page, "Add own").click();
  await page.locator("dialog[open]").getByLabel("Name").fill("Here it is");
  const [request] = await Promise.all([page.waitForRequest(one => one.method() === "POST" && one.url().endsWith("/v1/motions")),
    button(page, "Add to the library").click()]);
  assert.deepEqual(request.postDataJSON().frames, motion.frames.slice(range.from, range.to), "the marked range's frames");
  const tiles = page.locator(".tile");
  await said(page, "Here it is is in the library");
  assert.deepEqual(await tiles.allTextContents(), ["Here it is"], "one's own are shown");
  await page.keyboard.press("Escape");
  await page.locator(".ruler").click({position: {x: 400, y: 10}});
  await tiles.first().click();
  assert.equal(await page.locator(".control.pose").count(), 1);

  // The same name again, of a clip in a file: another program's, then a project's.
  const {file} = await projectOf(page);
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, "BVH").click()]);
  const bvh = {name: "arms.bvh", mimeType: "text/plain", buffer: fs.readFileSync(await download.path())};
  await button(page, "Add own").click();
  await page.locator("dialog[open]").getByLabel("Name").fill("Here it is");
  await page.getByRole("radio", {name: "A clip in a file"}).click();
  await page.setInputFiles("#clip-file", {name: "none.json", mimeType: "application/json", buffer: Buffer.from("{}")});
  const wrong = () => page.waitForFunction(() => [...document.querySelectorAll("dialog[open] .problem-words")].some(one => one.textContent !== ""));
  await wrong();
  const reads = await page.evaluate(async () => "/v1/motions/read" in (await (await fetch("/v1/openapi.json")).json()).paths);
  if (reads) {
    await page.setInputFiles("#clip-file", {name: "arm.bvh", mimeType: "text/plain", buffer: Buffer.from("not a clip")});
    await wrong();
    await page.setInputFiles("#clip-file", bvh);
    await page.getByText("arms.bvh").first().waitFor();
    await page.locator("dialog[open]").getByRole("spinbutton", {name: "To"}).waitFor();
    assert.equal(await page.locator("dialog[open] .problem-words").textContent(), "");
  }
  await page.setInputFiles("#clip-file", file);
  await button(page, "Add to the library").click();
  await wrong();
  await page.locator("dialog[open]").getByLabel("Name").fill("All of it");
  await button(page, "Add to the library").click();
  await page.waitForFunction(() => document.querySelectorAll(".tile").length === 2);

  await page.locator(".tiles li").nth(1).hover();
  await button(page, "Delete All of it from the library").click();
  await page.waitForFunction(() => document.querySelectorAll(".tile").length === 1);
  await button(page, "Bring it back").click();
  await page.waitForFunction(() => document.querySelectorAll(".tile").length === 2);
  await button(page, "All").click();
  assert.ok(await tiles.count() > 2);
}

async function rules(page) {
  const poses = page.locator(".control.pose");
  const before = await poses.count();
  await button(page, "Rules").click();
  for (const word of ["entrance", "behind", "Welcome"]) {
    await button(page, "Add a rule").click();
    await page.locator(".rule").last().getByRole("textbox").fill(word);
    await page.locator(".rule").last().getByRole("combobox").selectOption({index: 1});
  }
  await page.locator(".rule").last().getByRole("combobox").selectOption({index: 2});
  await page.locator(".rule").first().getByRole("textbox").fill("behind");
  await button(page, "Save", true).last().click();
  await page.getByText("has two rules").waitFor();
  await page.locator(".rule").first().getByRole("textbox").fill("entrance");
  await button(page, "Save and put gestures").click();
  await said(page, "put by rules");
  const put = await poses.count() - before;
  assert.ok(put >= 1, `${put} put`);
  await page.getByRole("button", {name: /^Undo/}).click();
  assert.equal(await poses.count(), before, "undone in one step");
  await page.getByRole("button", {name: /^Redo/}).click();
  assert.equal(await poses.count(), before + put);
  const starts = async () => (await documentOf(page)).poseControls.map(one => `${one.name} ${one.start}`).sort();
  const first = await starts();

  // At each Generate: those that a person has deleted come again, nothing comes twice.
  await poses.last().click();
  await page.keyboard.press("Delete");
  await button(page, "Rules").click();
  await page.locator("dialog[open]").getByRole("checkbox").check();
  await page.keyboard.press("Escape");
  const request = await asked(page);
  assert.equal(request.pose_controls.length, before + put);
  assert.deepEqual(await starts(), first);
}

async function curves(page) {
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await page.locator(".ruler").click({position: {x: 800, y: 10}});
  await button(page, "Happy").click();
  await page.getByLabel("Speed: value, curve or free").selectOption("curve");
  const points = page.locator(".curve-point");
  assert.equal(await points.count(), 2);
  await drag(page, await middleOf(points.nth(1)), {x: -40, y: 45});
  const label = page.locator(".control.style .hidden");
  assert.match(await label.textContent(), /speed a curve from 2\.0 to -/);
  const area = await page.locator(".curve").boundingBox();
  await page.mouse.dblclick(area.x + area.width / 2, area.y + 4);
  await page.waitForFunction(() => document.querySelectorAll(".curve-point").length === 3);
  const {speed} = (await documentOf(page)).styleControls[0];
  assert.ok(speed[1].value > 2 && speed[2].at < 0.95, JSON.stringify(speed));
  const {style_controls: pieces} = await asked(page);
  assert.ok(pieces.length >= 8 && pieces.every((one, k) => k === 0 || one.start_frame === pieces[k - 1].start_frame + pieces[k - 1].frame_count));
  assert.ok(pieces.every(one => one.space === 1 && one.handedness === 0));
  await page.keyboard.press("Escape");
}

const ring_px = 70;  // of the ring that faces the view, at 1280 by 720

async function trying(page) {
  await page.locator(".ruler").click({position: {x: 30, y: 10}});
  const at = Math.floor(15 * Number(await page.getByRole("slider", {name: "Playhead"}).getAttribute("aria-valuenow")));
  const before = await documentOf(page);
  await button(page, "Try a pose").click();
  const wrist = page.getByRole("button", {name: "Left wrist of the pose"});
  await wrist.waitFor();
  await page.waitForTimeout(300);
  await drag(page, await middleOf(wrist), {x: 50, y: -80});
  await page.getByText("Trying a pose (1 of 1)").waitFor();

  // Turned by the ring that faces the view.
  await button(page, "Turn").click();
  await page.waitForTimeout(300);
  await button(page, "Turn: Right upper arm").click();
  await page.waitForSelector("canvas[data-turns=rightUpperArm]");
  const arm = await middleOf(button(page, "Turn: Right upper arm"));
  await drag(page, {x: arm.x - ring_px, y: arm.y}, {x: 15, y: -40});
  await page.getByText("Trying a pose (2 of 2)").waitFor();
  await page.keyboard.press("Control+z");
  await page.getByText("Trying a pose (1 of 2)").waitFor();
  await page.keyboard.press("Control+Shift+z");
  assert.deepEqual(await documentOf(page), before, "what is tried is no edit");
  await button(page, "Drop").click();
  await wrist.waitFor({state: "detached"}).catch(() => {});
  assert.deepEqual(await documentOf(page), before);

  await button(page, "Try a pose").click();
  await page.waitForTimeout(300);
  await button(page, "Turn: Left forearm").click();
  await page.waitForSelector("canvas[data-turns=leftForearm]");
  const forearm = await middleOf(button(page, "Turn: Left forearm"));
  await drag(page, {x: forearm.x + ring_px, y: forearm.y}, {x: -15, y: -40});
  await page.getByText("Trying a pose (1 of 1)").waitFor();
  await button(page, "Keep").click();
  const {poseControls} = await documentOf(page);
  assert.equal(poseControls.length, before.poseControls.length + 1);
  const [frame] = poseControls.at(-1).base;
  const shown = before.motion.frames[at];
  assert.ok(Math.hypot(...frame.slice(15, 18).map((one, k) => one - shown[15 + k])) > 0.1, "the forearm is turned");
  assert.ok(Math.abs(Math.hypot(...frame.slice(15, 18)) - 1) < 1e-6, "and as long as it was");
  assert.deepEqual(frame.slice(0, 15), shown.slice(0, 15), "nothing else is");
  await button(page, "Turn").click();
}

async function allControls(page) {
  await page.keyboard.press("Escape");
  const before = await documentOf(page);
  await button(page, "Mirror all").click();
  const mirrored = await documentOf(page);
  assert.ok(mirrored.poseControls.every((one, k) => one.mirrored !== before.poseControls[k].mirrored));
  await page.getByRole("spinbutton", {name: "Times to"}).fill("50");
  await button(page, "Scale").click();
  const scaled = await documentOf(page);
  for (const [k, control] of scaled.poseControls.entries())
    assert.ok(Math.abs(control.start - before.poseControls[k].start / 2) <= 0.5, "twice as early");
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  assert.deepEqual(await documentOf(page), before);
}

async function pointing(page) {
  const before = (await documentOf(page)).poseControls.length;
  await button(page, "Point").click();
  const ball = button(page, "Ball to point at");
  await page.getByText(/hand, [\d.]+° off/).waitFor();
  const x = () => page.getByLabel("Left (m)").inputValue().then(Number);
  const [here, from] = [await middleOf(ball), await x()];
  await drag(page, here, {x: 40, y: -20});
  assert.ok(await x() > from + 0.03, `${from} to ${await x()}`);
  await page.getByLabel("Ahead (m)").fill("1.5");
  await page.getByLabel("Ahead (m)").press("Enter");
  await page.getByRole("spinbutton", {name: "Length"}).fill("0.4");
  await page.getByRole("spinbutton", {name: "Length"}).press("Enter");
  await page.waitForTimeout(300);
  await page.locator(".word").nth(5).click();
  await button(page, "Point here at", false).click();
  const {poseControls} = await documentOf(page);
  assert.equal(poseControls.length, before + 1);
  assert.equal(poseControls.at(-1).length, 6);
  assert.match(poseControls.at(-1).name, /^Point: /);
  await button(page, "Put the ball away").click();
}

async function systems(page) {
  const options = page.locator(".options");
  await options.click();
  const dialog = page.locator("dialog[open]");
  await dialog.getByRole("checkbox", {name: /mean pose/}).check();
  const variety = dialog.getByRole("slider", {name: /Variety/});
  const hasModel = await variety.count() > 0;
  if (hasModel) await variety.fill("1.5");
  await button(page, "Done").click();
  const asModel = await asked(page);
  assert.deepEqual([asModel.fade, asModel.variety, "still" in asModel, asModel.relaxed_fingers], [true, hasModel ? 1.5 : undefined, false, true]);
  assert.ok("style_controls" in asModel);
  await options.click();
  await dialog.getByRole("radio", {name: /Keyframes/}).click();
  assert.equal(await dialog.getByRole("slider").count(), 0, "what it does not take is not offered");
  await button(page, "Done").click();
  assert.equal(await page.locator(".style-track").count(), 0);
  assert.equal(await button(page, "Range only").count(), 0);
  const asKeyframes = await asked(page);
  assert.deepEqual([asKeyframes.system, "style_controls" in asKeyframes, "variety" in asKeyframes], ["keyframes", false, false]);
  for (let k = 0; k < 2; ++k) await page.getByRole("button", {name: /^Undo/}).click();
  assert.equal(await page.locator(".style-track").count(), 1);
  assert.match(await lastUndo(page), /Generate|Change/);
}

export async function authoring(place) {
  const {page, context, said: complaints} = await visit(place, {expected: /400|409|412/, script: undrawn});
  await generate(page, sentence);
  await still(page);
  const offers = {ownGestures: await has(page, "Add own"), rules: await has(page, "Rules"), curves: true, trying: true, allControls: true,
    pointing: await has(page, "Point"), systems: await page.locator(".options").count() > 0};
  for (const [name, check] of Object.entries({ownGestures, rules, curves, trying, allControls, pointing, systems}))
    if (offers[name]) await check(page);
  assert.deepEqual(complaints, []);
  await context.close();
  const without = Object.keys(offers).filter(name => !offers[name]);
  return `done by mouse: ${Object.keys(offers).filter(name => offers[name]).join(", ")}${without.length > 0 ? `; this server has no ${without.join(", ")}` : ""}`;
}
