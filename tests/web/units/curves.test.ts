import assert from "node:assert/strict";
import {test} from "node:test";
import {constantOf, curveOf, isCurve, moved, opposite, stylePieces, valueAt, withoutPoint, withPoint} from "../../../web/src/model/curves.ts";
import type {StyleControl, StyleValue} from "../../../web/src/model/document.ts";

const style = (start: number, length: number, speed: StyleValue, space: StyleValue = null): StyleControl =>
    ({kind: "style", id: `${start}`, start, length, speed, space, handedness: null});
const curve = [{at: 0, value: -1}, {at: 0.5, value: 2}, {at: 1, value: 0}];

test("between points a curve is straight, beside them flat", () => {
  assert.equal(valueAt(1.5, 0.3), 1.5);
  assert.equal(valueAt(null, 0.3), null);
  assert.deepEqual([0, 0.25, 0.5, 0.75, 1].map(share => valueAt(curve, share)), [-1, 0.5, 2, 1, 0]);
  assert.deepEqual([0, 1].map(share => valueAt([{at: 0.2, value: 1}, {at: 0.4, value: 3}], share)), [1, 3]);
});

test("a value becomes a flat curve, and a curve its middle's value", () => {
  assert.deepEqual(curveOf(2), [{at: 0, value: 2}, {at: 1, value: 2}]);
  assert.deepEqual(curveOf(null), [{at: 0, value: 0}, {at: 1, value: 0}]);
  assert.equal(curveOf(curve), curve);
  assert.equal(constantOf(curve), 2);
  assert.equal(constantOf(null), 0);
});

test("points stay in order, in the track and in what styles take", () => {
  assert.deepEqual(moved(curve, 1, 2, 9, 0.1)[1], {at: 0.9, value: 3});
  assert.deepEqual(moved(curve, 1, -1, -9, 0.1)[1], {at: 0.1, value: -3});
  assert.deepEqual(moved(curve, 0, -1, 0.123, 0.1)[0], {at: 0, value: 0.1});
  assert.deepEqual(withPoint(curve, 0.25, 0.5, 0.1)[1], {at: 0.25, value: 0.5});
  assert.equal(withPoint(curve, 0.45, 0.5, 0.1), curve, "too near to another");
  assert.equal(withoutPoint(curve, 1).length, 2);
  assert.equal(withoutPoint(withoutPoint(curve, 1), 0).length, 2, "two are the fewest");
});

test("left and right change sides in curves, too", () => {
  assert.deepEqual([opposite(1.5), opposite(null)], [-1.5, null]);
  assert.deepEqual(opposite(curve), [{at: 0, value: 1}, {at: 0.5, value: -2}, {at: 1, value: 0}]);
});

test("the server gets stretches of one value: a number one, a curve one for each frame, what is free nothing", () => {
  assert.deepEqual(stylePieces([style(3, 10, 0)]), [{start_frame: 3, frame_count: 10, speed: 0}]);
  assert.deepEqual(stylePieces([style(3, 10, null)]), []);
  const pieces = stylePieces([style(4, 5, curve, 1)]);
  assert.deepEqual(pieces.map(one => [one.start_frame, one.frame_count, one.speed, one.space]),
      [[4, 1, -1, 1], [5, 1, 0.5, 1], [6, 1, 2, 1], [7, 1, 1, 1], [8, 1, 0, 1]]);
  assert.ok(pieces.every(one => !("handedness" in one)));
  assert.deepEqual(stylePieces([style(0, 6, [{at: 0, value: 1}, {at: 1, value: 1}])]), [{start_frame: 0, frame_count: 6, speed: 1}], "a flat one is one");
});

test("long curves are cut into so many stretches that the server takes them, without gaps", () => {
  const long = [style(0, 900, [{at: 0, value: 1}, {at: 0.3, value: 1}, {at: 1, value: -2}]), style(900, 901, curve)];
  const pieces = stylePieces(long);
  assert.ok(pieces.length <= 1000 && pieces.length > 400, `${pieces.length}`);
  let at = 0;
  for (const piece of pieces) {
    assert.equal(piece.start_frame, at);
    at += piece.frame_count;
    assert.ok(Math.abs(piece.speed!) <= 3);
  }
  assert.equal(at, 1801);
  assert.ok(isCurve(long[0]!.speed));
});
