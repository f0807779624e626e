import assert from "node:assert/strict";
import {test} from "node:test";
import {endOf, fitting, gapAt, gapsOf, movedTogether, nearestStart, posesOf, stretched} from "../../../web/src/model/controls.ts";
import type {PoseControl, Span, StyleControl} from "../../../web/src/model/document.ts";

const span = (id: string, start: number, length: number): Span => ({id, start, length});
const track = [span("a", 10, 5), span("b", 20, 10), span("c", 40, 5)];
const ids = (...all: string[]) => new Set(all);

test("gaps are what controls leave", () => {
  assert.deepEqual(gapsOf(track, 50), [{from: 0, to: 10}, {from: 15, to: 20}, {from: 30, to: 40}, {from: 45, to: 50}]);
  assert.deepEqual(gapsOf([span("a", 0, 50)], 50), []);
  assert.deepEqual(gapAt(track, 16, 50), {from: 15, to: 20});
  assert.deepEqual(gapAt(track, 48, 48), {from: 45, to: 48});
});

test("what is added goes into the nearest gap that has room", () => {
  assert.equal(nearestStart(track, 5, 12, 50), 15);
  assert.equal(nearestStart(track, 5, 8, 50), 5);
  assert.equal(nearestStart(track, 10, 22, 50), 30);
  assert.equal(nearestStart(track, 11, 22, 50), null);
});

test("a control that is moved jumps over others only where it fits behind them", () => {
  assert.equal(movedTogether(track, ids("a"), 3, 50).get("a"), 13);
  assert.equal(movedTogether(track, ids("a"), 6, 50).get("a"), 15);  // not into b
  assert.equal(movedTogether(track, ids("a"), 20, 50).get("a"), 30);  // behind b
  assert.equal(movedTogether(track, ids("a"), 1000, 50).get("a"), 45);
});

test("several that are moved keep their distances, and go as far as there is room for all of them", () => {
  assert.deepEqual([...movedTogether(track, ids("a", "b"), 30, 50)], [["a", 20], ["b", 30]]);
  assert.deepEqual([...movedTogether(track, ids("b", "c"), -30, 50)], [["b", 0], ["c", 20]]);
  assert.deepEqual([...movedTogether(track, ids("b", "c"), -12, 50)], [["b", 15], ["c", 35]]);
});

test("no seed of random moves makes controls overlap or leave the track", () => {
  let state = 12345;
  const random = (below: number) => {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    return Math.floor(state / 2 ** 32 * below);
  };
  let spans: Span[] = track;
  for (let round = 0; round < 3000; ++round) {
    const some = new Set(spans.filter(() => random(2) === 0).map(one => one.id));
    const one = spans[random(spans.length)]!;
    if (random(2) === 0 && some.size > 0) {
      const starts = movedTogether(spans, some, random(81) - 40, 60);
      spans = spans.map(each => ({...each, start: starts.get(each.id) ?? each.start}));
    } else {
      const changed = stretched(spans, one.id, random(2) === 0 ? "start" : "end", random(80) - 10, 60);
      spans = spans.map(each => each.id === one.id ? changed : each);
    }
    const ordered = [...spans].sort((a, b) => a.start - b.start);
    ordered.forEach((each, k) => {
      assert.ok(each.length >= 1 && each.start >= (k > 0 ? endOf(ordered[k - 1]!) : 0) && endOf(each) <= 60, JSON.stringify(ordered));
    });
  }
});

test("ends are stretched up to neighbours, and a frame is left", () => {
  assert.deepEqual(stretched(track, "a", "end", 30, 50), span("a", 10, 10));
  assert.deepEqual(stretched(track, "b", "start", 0, 50), span("b", 15, 15));
  assert.deepEqual(stretched(track, "b", "start", 90, 50), span("b", 29, 1));
  assert.deepEqual(stretched(track, "c", "end", 90, 50), span("c", 40, 10));
});

const frame = (x: number) => Array.from({length: 9}, () => [x, Math.sqrt(1 - x * x), 0]).flat();
const pose = (start: number, length: number): PoseControl =>
    ({kind: "pose", id: "p", start, length, name: "p", base: [frame(-0.5), frame(0.5)], mirrored: false});
const style = (start: number, length: number): StyleControl => ({kind: "style", id: "s", start, length, speed: 0, space: null, handedness: 1});

test("a shorter speech drops gestures that would be cut, and cuts styles", () => {
  assert.deepEqual(fitting([pose(0, 10), pose(15, 10)], 20), [pose(0, 10)]);
  assert.deepEqual(fitting([style(0, 10), style(15, 10), style(20, 5)], 20), [style(0, 10), style(15, 5)]);
});

test("a gesture's poses are as many as it is long, its own at the ends", () => {
  const poses = posesOf(pose(0, 5));
  assert.equal(poses.length, 5);
  assert.deepEqual(poses[0], frame(-0.5));
  assert.deepEqual(poses[4], frame(0.5));
  assert.ok(Math.abs(poses[2]![0]!) < 1e-12 && Math.abs(poses[2]![1]! - 1) < 1e-12, "half-way lies on the arc");
  const flipped = posesOf({...pose(0, 2), mirrored: true});
  assert.ok(Math.abs(flipped[0]![0]! - 0.5) < 1e-12);
});
