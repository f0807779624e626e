import assert from "node:assert/strict";
import {test} from "node:test";
import {byRules, drawn, isOfRules, plainWord, type Rule} from "../../../web/src/model/rules.ts";
import type {PoseControl, Word} from "../../../web/src/model/document.ts";

const frame = Array.from({length: 9}, () => [0, 1, 0]).flat();
const gesture = (id: string, length: number) => ({id, name: id.toUpperCase(), frames: Array.from({length}, () => frame)});
const gestures = [gesture("a", 9), gesture("b", 9), gesture("c", 9)];
const words = (...all: string[]): Word[] => all.map((word, k) => ({word, start_s: k, end_s: k + 0.6}));
let next = 0;
const newId = () => `n${++next}`;
const put = (poseControls: PoseControl[], said: Word[], rules: Rule[], seed = 1, total = 15 * said.length) =>
    byRules({poseControls, seed}, said, total, rules, gestures, newId);
const own = (start: number, length: number): PoseControl => ({kind: "pose", id: newId(), start, length, name: "own", base: [frame], mirrored: false, rule: null});

test("words are compared without case and marks", () => {
  assert.equal(plainWord(" “Here!” "), "here");
  assert.equal(plainWord("don't"), "don't");
});

test("a gesture is centred on each word that has a rule", () => {
  const {controls, put: count, noRoom} = put([], words("see", "the", "Big", "house"), [{word: "big", motions: ["a"]}]);
  assert.deepEqual([count, noRoom], [1, 0]);
  const [one] = controls;
  assert.equal(one!.name, "A");
  assert.ok(Math.abs(one!.start + one!.length / 2 - 15 * 2.3) <= 0.5, "its middle is the word's");
  assert.ok(isOfRules(one!));
});

test("the same seed draws the same gesture, and over words and seeds all are drawn about as often", () => {
  const rules = [{word: "x", motions: ["a", "b", "c"]}];
  const names = (seed: number) => put([], words(..."xxxxxxxxxx"), rules, seed).controls.map(one => one.name).join("");
  assert.equal(names(5), names(5));
  assert.notEqual(names(5), names(6));
  const counts = [0, 0, 0];
  for (let seed = 0; seed < 60; ++seed) for (let word = 0; word < 50; ++word) ++counts[drawn(seed, word) % 3]!;
  assert.ok(counts.every(one => Math.abs(one - 1000) < 110), counts.join());
});

test("what a person has put stays, and a word without room gets none", () => {
  const mine = own(15, 12);
  const {controls, put: count, noRoom} = put([mine], words("big", "big", "big"), [{word: "big", motions: ["a"]}]);
  assert.deepEqual([count, noRoom], [2, 1]);
  assert.ok(controls.includes(mine));
  const spans = [...controls].sort((a, b) => a.start - b.start);
  spans.forEach((one, k) => assert.ok(one.start + one.length <= (spans[k + 1]?.start ?? 45)));
  assert.deepEqual(put([], words("big"), [{word: "big", motions: ["a"]}], 1, 8).noRoom, 1, "nor in a speech that is shorter than it");
});

test("put again, rules take back what they have put, but not what was changed since", () => {
  const first = put([], words("big", "big", "big"), [{word: "big", motions: ["a"]}]).controls;
  assert.equal(first.length, 3);
  const changed = {...first[1]!, mirrored: true};
  const again = put([first[0]!, changed, first[2]!], words("big", "big", "big"), [{word: "big", motions: ["b"]}]);
  assert.deepEqual([...again.controls].sort((a, b) => a.start - b.start).map(one => one.name), ["B", "A", "B"]);
  assert.ok(again.controls.includes(changed));
});

test("a rule whose gestures are gone does nothing", () => {
  assert.deepEqual(put([], words("big"), [{word: "big", motions: ["gone"]}]), {controls: [], put: 0, noRoom: 0});
});
