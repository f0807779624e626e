// A session by mouse: from a text to a motion that is corrected, saved and opened again.
import assert from "node:assert/strict";
import fs from "node:fs";
import {drag, generate, middleOf, projectOf, sentence, still, undrawn, visit} from "./visit.mjs";

const pictureOf = page => page.locator(".stage canvas").screenshot();

export async function byMouse(place) {
  const {page, context, said, asked, generated} = await visit(place);
  await page.fill("#text", sentence);
  const atRest = await pictureOf(page);
  await page.getByRole("button", {name: "Generate", exact: true}).click();
  await page.waitForFunction(() => Number(document.querySelector("canvas").dataset.time) > 0.05);
  assert.notDeepEqual(await pictureOf(page), atRest, "the avatar moves");
  await page.evaluate(undrawn);
  await still(page);
  const words = await page.locator(".word").allTextContents();
  assert.deepEqual(words, sentence.replaceAll(/[.,]/g, "").split(" "));
  assert.ok(await page.locator(".accent").count() > 0, "accents are marked");
  const drawn = await page.evaluate(() => {
    const canvas = document.querySelector(".waveform > div").shadowRoot.querySelector("canvas");
    const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return data.filter((one, k) => k % 4 === 3 && one > 0).length;
  });
  assert.ok(drawn > 1000, "the sound is drawn");

  // A gesture of the library at the playhead, searched for.
  await page.locator(".ruler").click({position: {x: 300, y: 10}});
  const all = await page.locator(".tile").count();
  await page.getByRole("searchbox").fill("point");
  await page.waitForFunction(count => document.querySelectorAll(".tile").length < count, all);
  await page.locator(".tile").first().click();
  const pose = page.locator(".control.pose");
  await pose.waitFor();
  await page.getByRole("searchbox").fill("");
  assert.match(await page.locator(".state").textContent(), /generate again/);

  // Moved, stretched at its end, then dragged against the end.
  const before = await middleOf(pose);
  await drag(page, before, {x: 150, y: 0}, {keys: ["Alt"]});
  const moved = await middleOf(pose);
  assert.ok(Math.abs(moved.left - before.left - 150) < 8, `moved by 150 px: ${moved.left - before.left}`);
  await drag(page, {x: moved.right - 3, y: moved.y}, {x: 90, y: 0}, {keys: ["Alt"]});
  const stretched = await middleOf(pose);
  assert.ok(Math.abs(stretched.left - moved.left) < 1 && Math.abs(stretched.right - moved.right - 90) < 8, "stretched at its end");
  await drag(page, stretched, {x: 3000, y: 0});
  const tracks = await middleOf(page.locator(".tracks"));
  const atEnd = await middleOf(pose);
  assert.ok(atEnd.right <= tracks.right + 1, `stays on the track: ends at ${atEnd.right}, the tracks at ${tracks.right}`);

  // Escape while dragging leaves it where it was.
  const here = await middleOf(pose);
  await page.mouse.move(here.x, here.y);
  await page.mouse.down();
  await page.mouse.move(here.x - 200, here.y, {steps: 4});
  await page.keyboard.press("Escape");
  await page.mouse.up();
  assert.ok(Math.abs((await middleOf(pose)).left - here.left) < 1, "Escape ends a drag");

  // Another by dragging from the library.
  await page.locator(".tile").nth(1).dragTo(page.locator(".pose-track"), {targetPosition: {x: 20, y: 20}});
  assert.equal(await pose.count(), 2);

  // The second one's pose by its wrist.
  const wrist = page.getByRole("button", {name: "Left wrist of the pose"});
  await wrist.waitFor();
  await page.waitForTimeout(500);
  const hand = await middleOf(wrist);
  await drag(page, hand, {x: 60, y: -90});
  await page.waitForFunction(x => Math.abs(document.querySelector(".handle.leftWrist").getBoundingClientRect().x + 12 - x) < 25, hand.x + 60);

  // A style, by a preset and by a slider.
  await page.locator(".ruler").click({position: {x: 700, y: 10}});
  await page.locator(".style-track").click({position: {x: 700, y: 20}});
  await page.getByRole("button", {name: "Happy"}).click();
  const style = page.locator(".control.style");
  await style.waitFor();
  await page.getByRole("slider", {name: "Space"}).fill("1.5");
  assert.match(await style.locator(".hidden").textContent(), /speed 2\.0, space 1\.5, handedness 0\.0/);

  // Generated again: with these controls.
  await page.getByRole("button", {name: "Generate", exact: true}).click();
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  await still(page);
  const {project} = await projectOf(page);
  assert.equal(project.document.poseControls.length, 2);
  assert.deepEqual(project.document.motion.frames, generated.at(-1).frames);

  // Inside the marked range only: all other frames stay bit for bit.
  await page.locator(".word").nth(4).dblclick();
  const kept = generated.at(-1).frames;
  const [range] = await Promise.all([page.waitForRequest("**/v1/generate"), page.getByRole("button", {name: "Range only"}).click()]);
  const {keep} = range.postDataJSON();
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  await still(page);
  const again = generated.at(-1).frames;
  assert.equal(again.length, kept.length);
  for (const [k, frame] of again.entries())
    if (k < keep.from_frame || k >= keep.to_frame) assert.deepEqual(frame, kept[k], `frame ${k} is outside`);

  // Everything is undone, and done again.
  const last = (await projectOf(page)).project.document;
  const undo = page.getByRole("button", {name: /^Undo/});
  let steps = 0;
  for (; await undo.isEnabled(); ++steps) await undo.click();
  assert.ok(steps >= 10, `${steps} steps`);
  assert.equal(await page.locator(".word").count(), 0);
  assert.equal(await page.inputValue("#text"), "");
  const redo = page.getByRole("button", {name: /^Redo/});
  for (let k = 0; k < steps; ++k) await redo.click();
  assert.ok(!await redo.isEnabled());
  assert.deepEqual((await projectOf(page)).project.document, last);

  // The motion as BVH.
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", {name: "BVH"}).click()]);
  const bvh = fs.readFileSync(await download.path(), "utf8");
  assert.match(download.suggestedFilename(), /\.bvh$/);
  assert.ok(bvh.startsWith("HIERARCHY") && bvh.includes(`Frames: `), "a BVH file");

  for (const [format, begins] of [["GLB", "glTF"], ["CSV", "frame,time"]]) {
    const [file] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", {name: format}).click()]);
    const content = fs.readFileSync(await file.path(), "latin1");
    assert.ok(!place.program || content.startsWith(begins), `${format}: ${content.slice(0, 40)}`);
  }

  // Without the pose controls, to compare.
  const bypass = page.getByRole("button", {name: "Generate without pose controls, to compare"});
  await bypass.click();
  const [without] = await Promise.all([page.waitForRequest("**/v1/generate"), page.getByRole("button", {name: "Generate", exact: true}).click()]);
  assert.ok(!("pose_controls" in without.postDataJSON()) && "style_controls" in without.postDataJSON());
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  await still(page);
  await page.getByRole("button", {name: /^Undo/}).click();
  await page.getByRole("button", {name: /^Undo/}).click();
  assert.deepEqual((await projectOf(page)).project.document, last);

  // A new project, and the saved one opened; a reload brings back both.
  const saved = await projectOf(page);
  await page.getByRole("button", {name: "New"}).click();
  assert.equal(await page.locator(".word").count(), 0);
  await page.setInputFiles("#project-file", saved.file);
  await page.locator(".word").first().waitFor();
  assert.deepEqual((await projectOf(page)).project.document, last);
  await page.reload();
  await page.locator(".control.pose").first().waitFor();
  assert.deepEqual((await projectOf(page)).project.document, last, "a reload loses nothing");
  assert.ok(await undo.isEnabled(), "nor what can be undone");

  // Its own sound as a recording in place of the voice.
  const [sound] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", {name: "WAV", exact: true}).click()]);
  await page.setInputFiles("#recording-file", await sound.path());
  await page.locator(".recording").waitFor();
  await page.getByRole("button", {name: "Generate", exact: true}).click();
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  assert.deepEqual(await page.locator(".word").allTextContents(), words);
  await still(page);
  await page.getByRole("button", {name: "Leave the recording out"}).click();

  // Another, shorter text keeps what fits.
  await generate(page, "Hello.");
  assert.ok(await pose.count() < 2, "what does not fit into a shorter speech goes");
  assert.deepEqual(said, [], "the page complains of nothing");
  assert.ok(asked.every(address => address.startsWith(place.server.address)), "nothing is asked of others");
  await context.close();
  return `${steps} steps undone and done again`;
}
