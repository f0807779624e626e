import assert from "node:assert/strict";
import {test} from "node:test";
import {interpolated, isFrame, jointsOf, lengthAtSpeed, mirrored, resampled} from "../../../web/src/model/frames.ts";
import {posed, reach, reshaped, turnAbout, turned, turnedPart, type Arm, type Point} from "../../../web/src/model/posing.ts";

const unit = (v: number[]) => v.map(one => one / Math.hypot(...v));
let state = 7;
const random = () => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return state / 2 ** 31 - 1;
};
const direction = () => unit([random(), random(), random() + 1e-3]);
const randomFrame = () => Array.from({length: 9}, direction).flat();
const minus = (a: readonly number[], b: readonly number[]) => a.map((one, k) => one - b[k]!);
const size = (a: readonly number[]) => Math.hypot(...a);

test("mirrored twice is the same, and the sides change", () => {
  const frame = randomFrame();
  assert.deepEqual(mirrored(mirrored(frame)), frame);
  const [joints, other] = [jointsOf(frame), jointsOf(mirrored(frame))];
  for (const [a, b] of [[4, 7], [5, 8], [6, 9], [3, 3]] as const)
    assert.ok(size(minus([-joints[a]![0], joints[a]![1], joints[a]![2]], other[b]!)) < 1e-12);
});

test("between poses directions stay unit and turn evenly", () => {
  const [a, b] = [randomFrame(), randomFrame()];
  for (const t of [0, 0.25, 0.5, 1]) {
    const frame = interpolated(a, b, t);
    for (let k = 0; k < 9; ++k) {
      const at = frame.slice(3 * k, 3 * k + 3);
      assert.ok(Math.abs(size(at) - 1) < 1e-9);
      const angle = (p: readonly number[], q: readonly number[]) => Math.acos(Math.min(1, p.reduce((sum, one, i) => sum + one * q[i]!, 0)));
      assert.ok(Math.abs(angle(a.slice(3 * k, 3 * k + 3), at) - t * angle(a.slice(3 * k, 3 * k + 3), b.slice(3 * k, 3 * k + 3))) < 1e-6);
    }
  }
});

test("speeds are lengths, and resampling keeps the ends", () => {
  assert.deepEqual([1, 2, 3].map(speed => lengthAtSpeed(21, speed)), [21, 11, 7]);
  assert.equal(lengthAtSpeed(1, 3), 1);
  const frames = [randomFrame(), randomFrame(), randomFrame()];
  const more = resampled(frames, 9);
  assert.deepEqual([more[0], more[4], more[8]], frames);
  assert.deepEqual(resampled([frames[0]!], 3), [frames[0], frames[0], frames[0]]);
});

test("frames are 27 finite numbers", () => {
  assert.ok(isFrame(randomFrame()));
  assert.ok(!isFrame(randomFrame().slice(1)) && !isFrame([...randomFrame().slice(1), NaN]) && !isFrame("x"));
});

test("a wrist reaches what the arm can reach, with the bones' lengths, the elbow on its side", () => {
  for (let round = 0; round < 500; ++round) {
    const [a, b] = [0.29, 0.25];
    const shoulder: Point = [0.17, 1.4, 0];
    const elbow = shoulder.map((one, k) => one + a * direction()[k]!) as unknown as Point;
    const up = minus(elbow, shoulder).map(one => one * a / size(minus(elbow, shoulder)));
    const at = shoulder.map((one, k) => one + up[k]!) as unknown as Point;
    const fore = direction();
    const arm: Arm = {shoulder, elbow: at, wrist: at.map((one, k) => one + b * fore[k]!) as unknown as Point};
    const target = shoulder.map((one, k) => one + (0.06 + 0.46 * Math.abs(random())) * direction()[k]!) as unknown as Point;
    const {upper, fore: lower} = reach(arm, target);
    assert.ok(Math.abs(size(upper) - 1) < 1e-9 && Math.abs(size(lower) - 1) < 1e-9);
    const wrist = shoulder.map((one, k) => one + a * upper[k]! + b * lower[k]!);
    const distance = size(minus(target, shoulder));
    if (distance > Math.abs(a - b) + 0.02 && distance < 0.9995 * (a + b)) assert.ok(size(minus(wrist, target)) < 1e-9);
    else assert.ok(Math.abs(size(minus(wrist, shoulder)) - Math.min(Math.max(distance, Math.abs(a - b) + 0.02), 0.9995 * (a + b))) < 1e-9);
  }
});

test("a wrist left where it is leaves the arm as it is", () => {
  const arm: Arm = {shoulder: [0.17, 1.4, 0], elbow: [0.17, 1.4 - 0.29, 0], wrist: [0.17, 1.11, 0.25]};
  const {upper, fore} = reach(arm, arm.wrist);
  assert.ok(size(minus(upper, [0, -1, 0])) < 1e-9 && size(minus(fore, [0, 0, 1])) < 1e-9);
});

test("a turn takes one direction to the other and keeps angles", () => {
  for (let round = 0; round < 100; ++round) {
    const [from, to, v] = [direction(), direction(), direction()] as unknown as Point[];
    assert.ok(size(minus(turned(from!, from!, to!), to!)) < 1e-9);
    assert.ok(Math.abs(size(turned(v!, from!, to!)) - 1) < 1e-9);
    const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, one, k) => sum + one * b[k]!, 0);
    assert.ok(Math.abs(dot(turned(v!, from!, to!), to!) - dot(v!, from!)) < 1e-9);
  }
});

test("only the arm that is moved changes, in all of the gesture's poses", () => {
  const base = [randomFrame(), randomFrame()];
  const control = {kind: "pose" as const, id: "p", start: 0, length: 2, name: "p", base, mirrored: false};
  const arm: Arm = {shoulder: [0.17, 1.4, 0], elbow: [0.2, 1.11, 0], wrist: [0.2, 1.11, 0.25]};
  const after = posed(base[0]!, "leftWrist", [0.4, 1.3, 0.3], arm, [0, 1.5, 0]);
  const changed = reshaped(control, base[0]!, after);
  assert.ok(size(minus(changed[0]!, after)) < 1e-9, "the pose that was moved is as it was left");
  for (const [k, frame] of changed.entries())
    for (let number = 0; number < 27; ++number)
      if (number < 12 || number >= 18) assert.equal(frame[number], base[k]![number]);
  const mirror = reshaped({...control, base: base.map(mirrored), mirrored: true}, base[0]!, after);
  assert.ok(size(minus(mirrored(mirror[0]!), after)) < 1e-9, "a flipped gesture is changed as it is seen");
});

test("a turned part keeps its bones' lengths and their angles to each other; the rest stays", () => {
  for (let round = 0; round < 50; ++round) {
    const frame = randomFrame();
    const turn = turnAbout(direction() as unknown as Point, 2 * random());
    const after = turnedPart(frame, "leftUpperArm", turn);
    const at = (of: readonly number[], k: number) => of.slice(3 * k, 3 * k + 3);
    const dot = (p: readonly number[], q: readonly number[]) => p.reduce((sum, one, i) => sum + one * q[i]!, 0);
    for (const k of [4, 5]) assert.ok(Math.abs(size(at(after, k)) - 1) < 1e-9);
    assert.ok(Math.abs(dot(at(frame, 4), at(frame, 5)) - dot(at(after, 4), at(after, 5))) < 1e-9, "the elbow is bent as before");
    for (let number = 0; number < 27; ++number) if (number < 12 || number >= 18) assert.equal(after[number], frame[number]);
  }
});

test("a quarter turn about the vertical takes ahead to the left, and back", () => {
  const ahead = Array.from({length: 9}, () => [0, 0, 1]).flat();
  const left = turnedPart(ahead, "body", turnAbout([0, 2, 0], Math.PI / 2));
  for (let k = 0; k < 9; ++k) assert.ok(size(minus(left.slice(3 * k, 3 * k + 3), [1, 0, 0])) < 1e-12);
  const back = turnedPart(left, "body", turnAbout([0, 1, 0], -Math.PI / 2));
  assert.ok(size(minus(back, ahead)) < 1e-12);
});
