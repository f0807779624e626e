import assert from "node:assert/strict";
import {test} from "node:test";
import {following, sameWords, timesInto} from "../../../web/src/model/following.ts";
import type {PoseControl, StyleControl} from "../../../web/src/model/document.ts";

// Each word lasts a number of frames, without pauses.
const speech = (text: string, frames = 6) => {
  const words = text.split(" ").map((word, k) => ({word, start_s: k * frames / 15, end_s: (k + 1) * frames / 15}));
  return {words, duration_s: words.length * frames / 15};
};
const frame = Array.from({length: 9}, () => [0, 1, 0]).flat();
const pose = (id: string, start: number, length: number): PoseControl =>
    ({kind: "pose", id, start, length, name: id, base: [frame], mirrored: false});
const style = (start: number, length: number): StyleControl => ({kind: "style", id: "s", start, length, speed: 1, space: null, handedness: null});

test("the same words are found again, in order", () => {
  const pairs = (a: string, b: string) => sameWords(speech(a).words, speech(b).words);
  assert.deepEqual(pairs("a b c", "A b c"), [[0, 0], [1, 1], [2, 2]]);
  assert.deepEqual(pairs("a b c d", "a x c d"), [[0, 0], [2, 2], [3, 3]]);
  assert.deepEqual(pairs("one big red house", "a red and big house"), [[2, 1], [3, 4]]);
  assert.deepEqual(pairs("a", "b"), []);
});

test("no pair of texts has pairs that cross, or fewer than the longest common run of a plain search", () => {
  let state = 3;
  const random = (below: number) => { state = (Math.imul(state, 1103515245) + 12345) >>> 0; return Math.floor(state / 2 ** 32 * below); };
  const longest = (a: string[], b: string[]): number => a.length === 0 || b.length === 0 ? 0
      : a[0] === b[0] ? 1 + longest(a.slice(1), b.slice(1)) : Math.max(longest(a.slice(1), b), longest(a, b.slice(1)));
  for (let round = 0; round < 200; ++round) {
    const [a, b] = [0, 1].map(() => Array.from({length: 1 + random(7)}, () => "abc"[random(3)]!)) as [string[], string[]];
    const pairs = sameWords(speech(a.join(" ")).words, speech(b.join(" ")).words);
    assert.equal(pairs.length, longest(a, b), `${a} / ${b}`);
    pairs.forEach(([i, j], k) => assert.ok(a[i] === b[j] && (k === 0 || i > pairs[k - 1]![0] && j > pairs[k - 1]![1])));
  }
});

test("times of words fall on the same words", () => {
  const [before, after] = [speech("see the red house", 6), speech("see now the red house", 9)];
  const into = timesInto(before, after)!;
  for (const word of before.words) {
    const other = after.words.find(one => one.word === word.word)!;
    // A word begins where the one before it ends, and what comes between is new.
    assert.ok(Math.abs(into(word.start_s + 1e-6) - other.start_s) < 1e-3, word.word);
    assert.ok(Math.abs(into((word.start_s + word.end_s) / 2) - (other.start_s + other.end_s) / 2) < 1e-6);
  }
  assert.equal(into(before.duration_s), after.duration_s);
  assert.equal(timesInto(before, speech("quite another text entirely")), null);
});

test("controls follow their words: gestures as long as they were, styles from word to word", () => {
  const [before, after] = [speech("see the red house", 6), speech("oh see the red house", 9)];
  const moved = following([pose("p", 12, 5)], before, after, 45);
  assert.deepEqual(moved, [pose("p", 27, 5)]);
  assert.deepEqual(following([style(12, 6)], before, after, 45), [style(27, 9)]);
});

test("in a faster speech controls keep clear of each other, and what has no room goes", () => {
  const [before, after] = [speech("see the red house", 8), speech("see the red house", 4)];
  const placed = following([pose("a", 0, 8), pose("b", 8, 8), pose("c", 16, 8)], before, after, 16);
  assert.deepEqual(placed.map(one => [one.id, one.start]), [["a", 0], ["b", 8]]);
});

test("another speech takes what fits into it", () => {
  assert.deepEqual(following([pose("a", 2, 4), pose("b", 20, 8)], speech("see the red house"), speech("never mind that"), 18), [pose("a", 2, 4)]);
});
