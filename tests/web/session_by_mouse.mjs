// A study's session by mouse: every kind of board, a trial by the model whose time runs out, one by keyframes that is
// finished.
import assert from "node:assert/strict";
import {drag, middleOf} from "./visit.mjs";
import {atWork, button, byKeyframes, byModel, headed, press, until, visitSession} from "./session_visit.mjs";

async function boards(page, session) {
  await headed(page, "Consent");
  assert.equal(await page.evaluate(() => document.activeElement.tagName), "H1", "the focus is on the head");
  await press(page, "I agree");
  await headed(page, "Making gestures");
  await page.waitForTimeout(320);
  await button(page, "Continue").dblclick();
  await headed(page, "About what you have just done");
  await page.waitForTimeout(320);
  assert.equal(session.step, "survey", "a double click presses once");

  await press(page, "Continue");
  await page.getByText("Please answer all questions.").nth(1).waitFor();
  for (const [group, step] of [[0, "6"], [0, "5"], [1, "2"]])
    await page.getByRole("group").nth(group).getByRole("button", {name: step, exact: true}).click();
  await page.waitForFunction(() => document.querySelectorAll(".board [aria-pressed=true]").length === 2);
  assert.deepEqual(await page.locator(".board [aria-pressed=true]").allTextContents(), ["5", "2"]);
  const slider = page.getByRole("slider", {name: /demanding/});
  await slider.focus();
  assert.equal(await slider.getAttribute("aria-valuetext"), "no answer yet");
  assert.equal(session.board.sliders[0].value, null, "nothing is set that was not touched");
  await slider.click();
  await until(() => session.board.sliders[0].value === 50, "the slider is at its middle");
  await drag(page, await middleOf(slider), {x: 100, y: 0});
  await until(() => session.board.sliders[0].value > 60, "the slider is dragged");
  await press(page, "Continue");

  await headed(page, "How old are you");
  await page.getByRole("textbox", {name: /How old/}).fill("29");
  await press(page, "the right");
  await button(page, "key frames").click();
  await until(() => session.board.buttons.some(one => one.label === "key frames" && one.chosen), "an option is chosen");
  await button(page, "games").click();
  await page.getByRole("textbox", {name: /What did you like/}).click();
  await page.keyboard.type("That one sees at once what one does.");
  await button(page, "Continue").click();

  await headed(page, "Which of these");
  assert.deepEqual(session.answers.at(-1), {board: "person", chosen: [1101, 1200, 1202], values: [], texts: ["29", "That one sees at once what one does."]});
  await page.waitForTimeout(320);
  await page.getByRole("button", {description: /I first thought/}).click();
  await page.getByRole("slider").click();
  await press(page, "Continue");
}

async function byTheModel(page, session) {
  await headed(page, "Trial 1 of 2");
  await atWork(page);
  await page.getByText("Practice").waitFor();
  for (const name of ["Open", "Save", "New", "Projects", "Film", "BVH", "WAV", "Rules", "Add own", "Finish"]) assert.equal(await button(page, name).count(), 0, name);
  assert.equal(await page.getByRole("combobox", {name: "Voice"}).count(), 0);
  assert.ok(await page.locator("#text").evaluate(text => text.readOnly));
  assert.ok(await page.getByRole("button", {name: "Undo"}).isDisabled(), "nothing leads back behind what was given");
  await page.locator(".options").click();
  await page.getByRole("slider", {name: /Variety/}).waitFor();
  assert.equal(await page.getByRole("radio").count(), 0, "what makes the gestures is not to be chosen");
  await page.keyboard.press("Escape");

  await page.locator(".tile").nth(3).click();
  await until(() => session.works.length === 1, "work is sent");
  const [first] = session.works;
  assert.deepEqual([first.trial, first.generated, first.edits.map(one => one.what)], [1, 0, ["Add Frame"]]);
  assert.ok(first.edits[0].at_s > 0 && first.edits[0].at_s < 60 && first.edits[0].patch[0].path[0] === "poseControls");
  assert.deepEqual([first.project.document.poseControls.length, first.project.document.speech.wav], [1, ""], "it goes as it came, without its sound");
  await button(page, "Generate").click();
  await until(() => session.works.at(-1).generated === 1, "generating is told");
  assert.ok(session.works.at(-1).project.document.motion.frames.length > 10 && JSON.stringify(session.works.at(-1).edits).length < 1000);

  await press(page, "Pause session");
  await headed(page, "Paused");
  const before = session.left();
  await page.keyboard.press("Escape");
  await page.waitForTimeout(400);
  assert.equal(session.left(), before, "the time stands still");
  await press(page, "Go on");
  await atWork(page);
  assert.ok(await page.getByRole("button", {name: /^Undo: Generate/}).isEnabled(), "and nothing is lost");

  session.leave(59.5);
  await page.getByText("1 minute left.").waitFor({state: "attached"});
  session.leave(2.2);
  await page.getByText("10 seconds left.").waitFor({state: "attached"});
  await page.waitForTimeout(1200);
  await page.locator(".tile").nth(1).click();
  await headed(page, "Trial 2 of 2");
  const answer = session.answers.at(-1);
  assert.deepEqual([answer.by, answer.project.document.poseControls.length], ["time", 2], "what was done in the last second counts");
}

async function byKeys(page, session) {
  await atWork(page);
  assert.equal(await page.locator(".control").count(), 0, "nothing is left of the trial before");
  assert.equal(await page.locator(".style-track").count() + await button(page, "Range only").count() + await page.getByRole("spinbutton", {name: "Version"}).count(), 0);
  await page.locator(".options").click();
  await page.locator("dialog[open]").getByRole("checkbox").waitFor();  // one: neither fade nor still
  await button(page, "Done").click();
  await page.locator(".tile").nth(2).click();
  const [request] = await Promise.all([page.waitForRequest("**/v1/generate"), button(page, "Generate").click()]);
  assert.deepEqual([request.postDataJSON().system, "fade" in request.postDataJSON()], ["keyframes", false]);
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  await button(page, "Finish").click();
  await button(page, "Go on working").click();
  assert.ok(session.task, "it asks once");
  await button(page, "Finish").click();
  await page.locator("dialog[open]").getByRole("button", {name: "Finish"}).click();
  await headed(page, "Thank you");
  await page.getByText("You can close this window").waitFor();
  const {by, project} = session.answers.at(-1);
  assert.deepEqual([by, project.document.system, project.document.poseControls.length, project.document.motion.system], ["finish", "keyframes", 1, "keyframes"]);
}

export async function sessionByMouse(place) {
  if (place.program) return "with the stand-in alone";
  const {session, page, said, close} = await visitSession(place, ["consent", "instructions", "survey", "person", "long", byModel({practice: true}), byKeyframes({may_end_early: true}), "over"],
      {expected: /409/});
  await boards(page, session);
  await byTheModel(page, session);
  await byKeys(page, session);
  assert.deepEqual(said, []);
  assert.ok(session.refused <= 1, `${session.refused} refused`);  // work that is sent as the time ends may be too late
  await close();
  return `${session.presses.length} presses, ${session.works.length} times work, ${session.answers.length} answers`;
}
