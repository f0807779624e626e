// What a session looks like: each of its states at two sizes, light and dark, and for those who cannot see it.
import assert from "node:assert/strict";
import {fits, inspected} from "./looks.mjs";
import {atWork, button, byKeyframes, byModel, visitSession} from "./session_visit.mjs";

const steps = () => ["consent", "instructions", "survey", "person", "long", byModel({practice: true}), byKeyframes({may_end_early: true}), "over"];

// In their order. Each leads there.
const states = [
  {name: "consent", lead: async () => {}},
  {name: "instructions", lead: async (page, session) => session.next()},
  {name: "survey", async lead(page, session) {
    session.next();
    await page.locator("h1").filter({hasText: "About what"}).waitFor();
    await page.waitForTimeout(320);
    await button(page, "5").first().click();
    await page.waitForFunction(() => document.querySelector(".board .chosen"));
  }},
  {name: "notice", lead: async (page, session) => session.tell("Please answer all questions.")},
  {name: "person", async lead(page, session) {
    session.notice = "";
    session.next();
    await page.getByRole("textbox").first().fill("29");
  }},
  {name: "long", lead: async (page, session) => session.next()},
  {name: "model", async lead(page, session) {
    session.next();
    await atWork(page);
    await page.locator(".tile").nth(3).click();
  }},
  {name: "paused", lead: async (page, session) => session.pause()},
  {name: "keyframes", async lead(page, session) {
    session.resume();
    session.next();
    await page.locator("h1").filter({hasText: "Trial 2"}).waitFor();
    await atWork(page);
    session.leave(59.5);
    await page.locator(".time-left.soon").waitFor();
  }},
  {name: "finish", dialog: true, lead: page => button(page, "Finish").click(), leave: page => page.keyboard.press("Escape")},
  {name: "lost", async lead(page, session) {
    session.leave(9);
    await page.locator(".time-left.now").waitFor();
    await page.route("**/v1/session**", route => route.abort());
    session.changed();
    await page.locator(".connection p").waitFor();
  }, leave: page => page.unroute("**/v1/session**")},
  {name: "time", async lead(page, session) {
    session.leave(100);
    session.left = () => 0;
    session.changed();
    await page.getByText("The time is over.").waitFor();
    delete session.left;
  }},
  {name: "over", async lead(page, session) {
    session.next();
    await page.getByText("You can close this window").waitFor();
  }},
];

export async function sessionLooks(place) {
  if (place.program) return "with the stand-in alone";
  const minor = new Set();
  for (const [width, height] of [[1280, 720], [1920, 1080]])
    for (const dark of [false, true]) {
      if (height > 720 && dark) continue;  // colours do not depend on the size
      const where = `${width}x${height}-${dark ? "dark" : "light"}`;
      const {session, page, said, close} = await visitSession(place, steps(), {width, height, dark, expected: /ERR_FAILED/});
      for (const {name, dialog, lead, leave} of states) {
        await lead(page, session);
        if (dialog) await page.locator("dialog[open]").waitFor();
        await page.waitForTimeout(120);
        if (height === 720) (await inspected(page, `${where}, ${name}`, dialog ? "dialog[open]" : null)).forEach(one => minor.add(one));
        await fits(page, `${where}, ${name}`);
        await page.screenshot({path: place.at(`session-${name}-${where}.png`)});
        await leave?.(page);
      }
      assert.deepEqual(said, [], where);
      await close();
    }
  return `${states.length} states; axe finds nothing serious (minor: ${[...minor].join(", ") || "none"})`;
}
