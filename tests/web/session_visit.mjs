// A window in a stand-in's session, and what tests of it share.
import {givenProject} from "./stand_in.mjs";
import {StandInSession} from "./stand_in_session.mjs";
import {standInServes, undrawn, visit} from "./visit.mjs";

export const speech = "Welcome, everybody. Over here on the left you find the entrance, and the big hall is right behind me.";
export const byModel = more => ({system: "SGT", project: givenProject(speech, {moving: true}), limit_s: 300, ...more});
export const byKeyframes = more => ({system: "MANUAL", keyframes_only: true, project: givenProject(speech), limit_s: 300, ...more});

// `steps`: as StandInSession takes them.
export async function visitSession(place, steps, options = {}) {
  const session = new StandInSession(steps, options);
  const server = await standInServes(place.share, session);
  const {page, context, said, asked} = await visit({...place, server}, {script: undrawn, ready: ".board, .session-bar h1", ...options});
  return {session, page, said, asked, async close() {
    await context.close();
    clearTimeout(session.timer);
    server.stop();
  }};
}

const settle_ms = 320;  // a board that has just come takes no press
export const button = (page, name) => page.getByRole("button", {name, exact: true});
export const headed = (page, words) => page.locator("h1").filter({hasText: words}).waitFor();
export async function press(page, name, options) {
  await page.waitForTimeout(settle_ms);
  await button(page, name).click(options);
}
export const atWork = page => page.waitForFunction(() => document.querySelector(".task:not(.covered):not([inert])") && document.querySelector(".word") !== null);
export const until = async (holds, words) => {
  for (let k = 0; k < 400; ++k) {
    if (holds()) return;
    await new Promise(done => setTimeout(done, 25));
  }
  throw new Error(`it does not come to this: ${words}`);
};
