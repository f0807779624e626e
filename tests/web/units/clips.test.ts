import assert from "node:assert/strict";
import {test} from "node:test";
import {clipOf} from "../../../web/src/model/clip_file.ts";
import {scaled} from "../../../web/src/model/controls.ts";
import {emptyDocument, type StudioDocument} from "../../../web/src/model/document.ts";
import {writeProject} from "../../../web/src/model/project.ts";

const frame = Array.from({length: 9}, () => [0, 1, 0]).flat();
const frames = (count: number) => Array.from({length: count}, () => frame);
const speech = (count: number) => ({text: "a", voice: null, recording: null, pitch: [], pitch_fps: 100, duration_s: count / 15, words: [], accents: [], wav: ""});
const project = (count: number, range: StudioDocument["range"]): StudioDocument => ({...emptyDocument, speech: speech(count), range,
  motion: {frames: frames(count), tracks: {fps: 15, bones: ["head"], rotations: Array(count).fill([0, 0, 0, 1])}, system: "s", synthetic: true, madeFrom: "x"}});

test("of a project its marked range is taken, else as much as a gesture may be long", () => {
  const {from, to, frames: all} = clipOf(writeProject(project(40, {from: 5, to: 12}), []));
  assert.deepEqual([from, to, all.length], [5, 12, 40]);
  assert.deepEqual(clipOf(writeProject(project(400, null), [])).to, 300);
});

test("frames of an answer are read", () => {
  assert.equal(clipOf(JSON.stringify({fps: 15, frames: frames(3)})).frames.length, 3);
  assert.equal(clipOf(JSON.stringify(frames(2))).to, 2);
});

test("other files are refused with what is wrong", () => {
  assert.throws(() => clipOf("HIERARCHY"), /not JSON/);
  assert.throws(() => clipOf("{}"), /no frames/);
  assert.throws(() => clipOf("null"), /no frames/);
  assert.throws(() => clipOf(JSON.stringify({fps: 30, frames: frames(2)})), /30 frames a second/);
  assert.throws(() => clipOf(JSON.stringify({frames: [frame, [1]]})), /Frame 2 .* 27 numbers/);
  assert.throws(() => clipOf(writeProject(emptyDocument, [])), /no motion/);
});

test("times are scaled about a frame, all alike, and never into one another", () => {
  const spans = [{id: "a", start: 10, length: 5}, {id: "b", start: 20, length: 10}];
  const all = new Set(["a", "b"]);
  assert.deepEqual([...scaled(spans, all, 2, 0, 60)!.values()], [{id: "a", start: 20, length: 10}, {id: "b", start: 40, length: 20}]);
  assert.deepEqual([...scaled(spans, all, 0.5, 10, 60)!.values()], [{id: "a", start: 10, length: 3}, {id: "b", start: 15, length: 5}]);
  assert.equal(scaled(spans, all, 2, 0, 59), null, "over the speech's end");
  assert.equal(scaled(spans, all, 2, 30, 60), null, "before the speech's start");
  assert.equal(scaled(spans, new Set(["a"]), 3, 10, 60), null, "into another");
  assert.deepEqual(scaled(spans, new Set(["a"]), 2, 10, 60)!.get("a"), {id: "a", start: 10, length: 10});
});
