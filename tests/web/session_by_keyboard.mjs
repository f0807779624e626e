// A study's session by keyboard alone: boards, a trial by the model, one by keyframes; keys that are held down press once.
import assert from "node:assert/strict";
import {tabTo} from "./by_keyboard.mjs";
import {atWork, byKeyframes, byModel, headed, until, visitSession} from "./session_visit.mjs";

const keys = async (page, ...names) => { for (const name of names) await page.keyboard.press(name); };
const named = name => at => at.name === name;
const focusOn = (page, name) => tabTo(page, named(name));
const atHead = page => page.evaluate(() => document.activeElement.tagName);

// Enter is held down until the next board is there, and beyond.
async function held(page, words) {
  for (let k = 0; k < 3; ++k) await page.keyboard.down("Enter");
  await headed(page, words);
  for (let k = 0; k < 5; ++k) await page.keyboard.down("Enter");
  await page.keyboard.up("Enter");
}

async function boards(page, session) {
  await headed(page, "Consent");
  assert.equal(await atHead(page), "H1");
  await focusOn(page, "I agree");
  await held(page, "Making gestures");
  await page.waitForTimeout(100);
  assert.equal(session.step, "instructions");
  assert.equal(await atHead(page), "H1", "the focus is on the new board's head");
  await focusOn(page, "Continue");
  await held(page, "About what");

  // One stop of Tab for each question, arrows among its answers.
  await focusOn(page, "1");
  await keys(page, "ArrowRight", "ArrowRight", "End", "ArrowLeft", "Enter");
  await until(() => session.board.buttons.some(one => one.label === "6" && one.chosen), "6 is chosen");
  await focusOn(page, "1");
  await keys(page, "ArrowRight", "Space");
  await until(() => session.board.buttons.filter(one => one.chosen).length === 2, "2 is chosen");
  await page.waitForFunction(() => document.activeElement.textContent === "2" && document.activeElement.getAttribute("aria-pressed") === "true");
  await keys(page, "Tab");
  await keys(page, "Escape");
  assert.equal(session.board.sliders[0].value, null, "the slider is reached, and not set");
  await keys(page, "ArrowRight", "ArrowRight");
  await until(() => session.board.sliders[0].value === 52, "the slider is set");
  await focusOn(page, "Continue");
  await keys(page, "Enter");

  await headed(page, "How old are you");
  await tabTo(page, at => at.tag === "INPUT");
  await page.keyboard.type("31");
  await focusOn(page, "the left");
  await keys(page, "Enter");
  await focusOn(page, "key frames");
  await keys(page, "Enter", "ArrowRight", "Space");
  await tabTo(page, at => at.tag === "INPUT");
  await page.keyboard.type("Nothing is hidden.");
  await focusOn(page, "Continue");
  await keys(page, "Enter");
  await headed(page, "Which of these");
  assert.deepEqual(session.answers.at(-1), {board: "person", chosen: [1100, 1200, 1201], values: [], texts: ["31", "Nothing is hidden."]});
  await focusOn(page, "A");
  await keys(page, "ArrowDown", "Enter", "Tab", "End");
  await until(() => session.board.sliders[0].value === 100, "the slider is at its end");
  await focusOn(page, "Continue");
  await keys(page, "Enter");
}

async function work(page, session) {
  await headed(page, "Trial 1 of 2");
  await atWork(page);
  assert.equal(await atHead(page), "H1");
  await keys(page, "Control+s");
  await page.getByText("Your work is kept by itself.").waitFor();
  await tabTo(page, at => at.kind.includes("tile"));
  await keys(page, "Enter");
  await until(() => session.works.length > 0, "work is sent");
  await keys(page, "Control+z");
  await until(() => session.works.at(-1).edits.at(-1)?.what.startsWith("Undo: Add"), "undoing is told");
  await tabTo(page, named("Pause session"), "Shift+Tab");
  await keys(page, "Enter");
  await headed(page, "Paused");
  await focusOn(page, "Go on");
  await held(page, "Trial 1 of 2");
  await atWork(page);
  await page.waitForFunction(() => document.activeElement.textContent === "Pause session");  // where it was
  session.leave(0.3);

  await headed(page, "Trial 2 of 2");
  await atWork(page);
  assert.equal(await atHead(page), "H1");
  await tabTo(page, at => at.kind.includes("tile"));
  await keys(page, "Enter", "Control+Enter");
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  await tabTo(page, named("Finish"), "Shift+Tab");
  for (let k = 0; k < 4; ++k) await page.keyboard.down("Enter");
  await page.keyboard.up("Enter");
  await page.locator("dialog[open]").waitFor();
  assert.equal((await page.evaluate(() => document.activeElement.textContent)), "Go on working", "nothing is ended by a key that is held");
  await keys(page, "Escape");
  await page.locator("dialog[open]").waitFor({state: "detached"});
  await keys(page, "Enter");
  await page.locator("dialog[open]").waitFor();
  await focusOn(page, "Finish");
  await keys(page, "Enter");
  await headed(page, "Thank you");
  assert.deepEqual(session.answers.slice(-2).map(one => [one.by, one.project.document.poseControls.length]), [["time", 0], ["finish", 1]]);
}

export async function sessionByKeyboard(place) {
  if (place.program) return "with the stand-in alone";
  const {session, page, said, close} = await visitSession(place, ["consent", "instructions", "survey", "person", "long", byModel(), byKeyframes({may_end_early: true}), "over"],
      {expected: /409/});
  await boards(page, session);
  await work(page, session);
  assert.deepEqual(said, []);
  assert.ok(session.refused <= 1, `${session.refused} refused`);  // work that is sent as the time ends may be too late
  await close();
  return `${session.presses.length} presses, ${session.answers.length} answers`;
}
