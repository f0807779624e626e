// A study's session when things go wrong: the page is left in a trial, the server is away, a board changes as one presses.
import assert from "node:assert/strict";
import {atWork, button, byKeyframes, byModel, headed, press, until, visitSession} from "./session_visit.mjs";

const poses = page => page.locator(".control.pose").count();

// Left and opened again, at once and after a while.
async function leftAndOpened(place) {
  const {session, page, said, close} = await visitSession(place, [byModel(), "over"]);
  await atWork(page);
  await page.locator(".tile").nth(1).click();
  await until(() => session.works.length === 1, "work is sent");
  await page.reload();
  await atWork(page);
  assert.equal(await poses(page), 1, "the server gives it back");
  await page.waitForTimeout(1100);
  const before = session.works.length;
  await page.locator(".tile").nth(2).click();
  await page.locator(".tile").nth(3).click();
  await page.reload();
  await atWork(page);
  assert.equal(await poses(page), 3, "what was not sent is there, too");
  await until(() => session.works.length > before && session.works.at(-1).project.document.poseControls.length === 3, "it is sent now");
  const told = session.works.flatMap(work => work.edits.map(one => one.what));
  assert.equal(told.filter(one => one.startsWith("Add")).length, 3, told.join(", "));
  await page.locator(".control.pose").first().waitFor();
  assert.deepEqual(said, []);
  // Another window waits until this one is closed.
  const second = await page.context().newPage();
  await second.goto(page.url());
  await second.getByText("open in another window").waitFor();
  assert.equal(await second.locator(".control").count(), 0);
  await second.close();
  // The next one to open the page with nothing unsent gets the server's.
  assert.equal(await page.evaluate(() => sessionStorage.length), 0);
  await close();
}

async function away(place) {
  const {session, page, said, close} = await visitSession(place, ["person", byKeyframes(), "over"], {expected: /Failed to load resource/});
  await headed(page, "How old");
  const cut = () => page.route("**/v1/**", route => route.abort());
  const back = () => page.unroute("**/v1/**");
  const lost = () => page.getByText("The connection is lost.").waitFor();
  const found = () => page.getByText("The connection is lost.").waitFor({state: "detached"});
  await page.waitForTimeout(320);
  await cut();
  session.changed();
  await lost();
  await page.getByRole("textbox", {name: /How old/}).fill("44");
  await button(page, "the right").click();
  assert.equal(await page.getByRole("textbox", {name: /How old/}).inputValue(), "44");
  await back();
  await found();
  await until(() => session.board.fields[0].text === "44", "what was typed arrives");
  await page.waitForTimeout(300);
  await press(page, "the right");
  await until(() => session.board.buttons.some(one => one.label === "the right" && one.chosen), "it is pressed");
  await press(page, "Continue");

  await atWork(page);
  await cut();
  session.changed();
  await lost();
  await page.locator(".tile").nth(1).click();
  await button(page, "Generate").click();
  await page.locator(".messages").getByText("does not answer").waitFor();
  await page.locator(".tile").nth(2).click();
  await page.waitForTimeout(1200);
  assert.equal(session.works.length, 0);
  await back();
  await found();
  await until(() => session.works.length > 0, "work is sent when it is back");
  assert.deepEqual(session.works.at(-1).edits.map(one => one.what.split(" ")[0]), ["Add", "Add"]);

  // The time runs out while it is away: what was sent counts, and nobody is asked anything.
  await cut();
  session.changed();
  await lost();
  session.leave(0.2);
  await until(() => session.step === "over", "the time is over");
  await back();
  await headed(page, "Thank you");
  assert.deepEqual(said, []);
  await close();
}

async function asOnePresses(place) {
  const {session, page, said, close} = await visitSession(place, ["consent", "instructions", "survey", byModel({limit_s: 300}), "over"], {expected: /409/});
  await headed(page, "Consent");
  await page.waitForTimeout(320);
  session.nextUnheard();
  await button(page, "I agree").click();
  await headed(page, "Making gestures");
  assert.deepEqual([session.presses, session.refused], [[], 1], "it is not pressed on the board that has come");
  await page.waitForTimeout(320);
  // The same board, but for a line: pressed all the same.
  session.notice = "The next one waits.";
  ++session.revision;
  await button(page, "Continue").click();
  await headed(page, "About what");
  assert.deepEqual([session.presses.length, session.refused], [1, 2]);

  // A trial that is over while its work is on the way.
  session.next();
  await atWork(page);
  await until(() => session.waiting.size > 0, "the page has asked for what comes next");
  session.nextUnheard();
  await page.locator(".tile").nth(1).click();
  await headed(page, "Thank you");
  assert.deepEqual([session.works.length, session.refused], [0, 3]);
  assert.equal(await page.getByRole("alert").allTextContents().then(all => all.join("")), "", "it is handled quietly");
  assert.deepEqual(said, []);
  await close();
}

export async function sessionGoesWrong(place) {
  if (place.program) return "with the stand-in alone";
  await leftAndOpened(place);
  await away(place);
  await asOnePresses(place);
  return "left and opened again, cut off, too late: nothing lost, nothing answered by accident";
}
