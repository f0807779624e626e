// Whether the avatar is in step with the sound, and how long our own part of a frame takes: measured with draw calls stubbed
// and counted, since a machine of tests draws in software.
import assert from "node:assert/strict";
import {sentence, still, visit} from "./visit.mjs";

const most_ms = 1000 / 15;  // a frame of the motion
const mostOwn_ms = 6;
const mostWait_ms = 500;

function watch() {
  globalThis.draws = 0;
  for (const name of ["drawElements", "drawArrays"]) WebGL2RenderingContext.prototype[name] = () => { ++globalThis.draws; };
  const start = AudioBufferSourceNode.prototype.start;
  AudioBufferSourceNode.prototype.start = function(when, offset, ...rest) {
    globalThis.played = {context: this.context, when, offset};
    return start.call(this, when, offset, ...rest);
  };
  const request = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.own = [];
  globalThis.requestAnimationFrame = callback => request(time => {
    const begun = performance.now();
    callback(time);
    globalThis.own.push(performance.now() - begun);
  });
}

// While it plays: how far each pose, when it is drawn, is from the sound that is heard then.
const measured = page => page.evaluate(() => new Promise(resolve => {
  const canvas = document.querySelector("canvas");
  const apart = [];
  globalThis.own.length = 0;
  const before = globalThis.draws;
  const watching = new MutationObserver(() => {
    const {context, when, offset} = globalThis.played;
    const heard = offset + context.currentTime - when - context.outputLatency;
    apart.push(1000 * Math.abs(heard - Number(canvas.dataset.time)));
    if (apart.length >= 120) end();
  });
  const end = () => {
    watching.disconnect();
    resolve({apart, own: globalThis.own, draws: globalThis.draws - before});
  };
  setTimeout(end, 3000);  // each speech is longer
  watching.observe(canvas, {attributes: true, attributeFilter: ["data-time"]});
}));

// From pressing Generate to another pose of the motion, in ms.
const movingAfter = () => new Promise((resolve, reject) => {
  const canvas = document.querySelector(".stage canvas");
  const begun = performance.now();
  const seen = new Set([canvas.dataset.time]);
  const watching = new MutationObserver(() => {
    seen.add(canvas.dataset.time);
    if (seen.size < 3 || canvas.dataset.time === "0.000") return;
    watching.disconnect();
    resolve(performance.now() - begun);
  });
  watching.observe(canvas, {attributes: true, attributeFilter: ["data-time"]});
  document.querySelector(".generate .primary").click();
  setTimeout(() => reject(new Error("the avatar does not move")), 20000);
});

const at = (numbers, share) => [...numbers].sort((a, b) => a - b)[Math.floor(share * (numbers.length - 1))];

export async function inStep(place) {
  const {page, context} = await visit(place, {script: watch});
  // The quickest of four, each of a new text, since other programs run beside it.
  const waits = [];
  for (let k = 0; k < 4; ++k) {
    if (k > 0) await still(page);
    await page.fill("#text", sentence.split(" ").slice(k).join(" "));
    waits.push(await page.evaluate(movingAfter));
  }
  const moving_ms = Math.min(...waits);
  await page.waitForFunction(() => Number(document.querySelector("canvas").dataset.time) > 0.1);
  const {apart, own, draws} = await measured(page);
  await context.close();
  assert.ok(apart.length >= 8 && draws >= apart.length, `${apart.length} frames, ${draws} draw calls`);
  assert.ok(at(apart, 0.95) < most_ms, `pose and sound: ${at(apart, 0.95).toFixed(1)} ms apart in 95 % of frames`);
  if (!process.env.DEIXIS_SLOW_MACHINE) assert.ok(at(own, 0.5) <= mostOwn_ms, `our part of a frame: ${at(own, 0.5).toFixed(1)} ms`);
  if (!process.env.DEIXIS_SLOW_MACHINE) assert.ok(moving_ms < mostWait_ms, `moving after ${moving_ms.toFixed(0)} ms`);
  return `moving ${moving_ms.toFixed(0)} ms after Generate; ${apart.length} frames: pose and sound ${at(apart, 0.5).toFixed(1)} ms apart (median), ${at(apart, 0.95).toFixed(1)} (95 %), ` +
      `${at(apart, 1).toFixed(1)} (most); our part of a frame ${at(own, 0.5).toFixed(2)} ms (median), ${(draws / apart.length).toFixed(1)} draw calls`;
}
