// Poses changed by a joint that is moved: the bones keep their lengths, the elbow keeps its side.
import type {Frame, PoseControl} from "./document.ts";
import {mirrored} from "./frames.ts";

export type Point = readonly [number, number, number];
export type Handle = "leftWrist" | "rightWrist" | "leftElbow" | "rightElbow" | "head";

// Where an arm's joints are, in metres of the avatar.
export interface Arm { readonly shoulder: Point; readonly elbow: Point; readonly wrist: Point }

// What is turned as one, with all that hangs on it.
export const parts = ["body", "head", "rightShoulder", "rightUpperArm", "rightForearm", "leftShoulder", "leftUpperArm", "leftForearm"] as const;
export type Part = typeof parts[number];
const bonesOfPart: Record<Part, readonly number[]> = {body: [0, 1, 2, 3, 4, 5, 6, 7, 8], head: [1, 2], leftShoulder: [3, 4, 5], leftUpperArm: [4, 5],
  leftForearm: [5], rightShoulder: [6, 7, 8], rightUpperArm: [7, 8], rightForearm: [8]};

// A unit quaternion.
export type Turn = readonly [x: number, y: number, z: number, w: number];

const plus = (a: Point, b: Point, t = 1): Point => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
const minus = (a: Point, b: Point): Point => plus(a, b, -1);
const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Point, b: Point): Point => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a: Point): number => Math.sqrt(dot(a, a));
const unit = (a: Point, otherwise: Point = [0, -1, 0]): Point => {
  const size = length(a);
  return size > 1e-9 ? [a[0] / size, a[1] / size, a[2] / size] : otherwise;
};

// The directions of upper arm and forearm that bring the wrist to a point, or as near as the arm reaches.
export function reach(arm: Arm, target: Point): {upper: Point; fore: Point} {
  const [a, b] = [length(minus(arm.elbow, arm.shoulder)), length(minus(arm.wrist, arm.elbow))];
  const along = unit(minus(target, arm.shoulder), unit(minus(arm.wrist, arm.shoulder)));
  const distance = Math.min(Math.max(length(minus(target, arm.shoulder)), Math.abs(a - b) + 0.02), 0.9995 * (a + b));
  const at = (a * a - b * b + distance * distance) / (2 * distance);
  const out = minus(arm.elbow, arm.shoulder);
  const side = unit(plus(out, along, -dot(out, along)), unit(cross(along, [1, 0, 0]), [0, 0, -1]));
  const elbow = plus(plus([0, 0, 0], along, at), side, Math.sqrt(Math.max(0, a * a - at * at)));
  return {upper: unit(elbow), fore: unit(minus(plus([0, 0, 0], along, distance), elbow))};
}

// The turn that takes one direction to another, of a third one.
export function turned(v: Point, from: Point, to: Point): Point {
  const axis = cross(from, to);
  const cosine = dot(from, to);
  if (cosine < -1 + 1e-9) return [-v[0], -v[1], -v[2]];
  return plus(plus(plus([0, 0, 0], v, cosine), cross(axis, v)), axis, dot(axis, v) / (1 + cosine));
}

const rotated = (v: Point, [x, y, z, w]: Turn): Point => {
  const q: Point = [x, y, z];
  const t = cross(q, v);
  return plus(plus(v, t, 2 * w), cross(q, t), 2);
};

export const turnAbout = (axis: Point, angle: number): Turn => {
  const [x, y, z] = unit(axis);
  const half = Math.sin(angle / 2);
  return [half * x, half * y, half * z, Math.cos(angle / 2)];
};

const bone = (frame: Frame, k: number): Point => [frame[3 * k]!, frame[3 * k + 1]!, frame[3 * k + 2]!];

function withBones(frame: Frame, bones: Readonly<Record<number, Point>>): Frame {
  const out = [...frame];
  for (const [k, direction] of Object.entries(bones)) out.splice(3 * Number(k), 3, ...direction);
  return out;
}

// The pose after a handle is brought to a point. `neck`: where the head turns about.
export function posed(frame: Frame, handle: Handle, target: Point, arm: Arm | null, neck: Point): Frame {
  if (handle === "head") {
    const from = unit(plus(bone(frame, 1), bone(frame, 2)));
    const to = unit(minus(target, neck), from);
    return withBones(frame, {1: unit(turned(bone(frame, 1), from, to)), 2: unit(turned(bone(frame, 2), from, to))});
  }
  if (!arm) return frame;
  const upper = handle.startsWith("left") ? 4 : 7;
  if (handle.endsWith("Elbow")) return withBones(frame, {[upper]: unit(minus(target, arm.shoulder), bone(frame, upper))});
  const {upper: first, fore} = reach(arm, target);
  return withBones(frame, {[upper]: first, [upper + 1]: fore});
}

// The pose after a part is turned about its joint: the bones keep their lengths, and their places to each other.
export const turnedPart = (frame: Frame, part: Part, turn: Turn): Frame =>
    withBones(frame, Object.fromEntries(bonesOfPart[part].map(k => [k, unit(rotated(bone(frame, k), turn), bone(frame, k))])));

// A gesture changed at one of its poses: what turned there turns alike in all of them, so that it stays one movement.
export function reshaped(control: PoseControl, before: Frame, after: Frame): readonly Frame[] {
  const shown = control.mirrored ? control.base.map(mirrored) : control.base;
  const changed = shown.map(frame => {
    const bones: Record<number, Point> = {};
    for (let k = 0; k < 9; ++k) {
      const [from, to] = [bone(before, k), bone(after, k)];
      if (length(minus(from, to)) > 1e-9) bones[k] = unit(turned(bone(frame, k), unit(from), unit(to)));
    }
    return withBones(frame, bones);
  });
  return control.mirrored ? changed.map(mirrored) : changed;
}
