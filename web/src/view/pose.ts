// Puts the bones of a figure where tracks have them at a time.
import {Quaternion, type Object3D} from "three";
import type {Tracks} from "../model/document.ts";

const a = new Quaternion();
const b = new Quaternion();

// Between frames by the shorter arc; before the first and behind the last, those.
export function pose(bones: ReadonlyMap<string, Object3D>, tracks: Tracks, time_s: number): void {
  const last = tracks.rotations.length - 1;
  const at = Math.min(Math.max(0, time_s * tracks.fps), last);
  const low = Math.floor(at);
  const [before, after] = [tracks.rotations[low]!, tracks.rotations[Math.min(low + 1, last)]!];
  tracks.bones.forEach((name, k) => {
    const bone = bones.get(name);
    if (!bone) return;
    a.fromArray(before, 4 * k);
    b.fromArray(after, 4 * k);
    bone.quaternion.slerpQuaternions(a, b, at - low);
  });
}

// Every bone by its node's name, and its rotation at rest.
export function bonesOf(figure: Object3D): Map<string, Object3D> {
  const bones = new Map<string, Object3D>();
  figure.traverse(object => { if (object.name) bones.set(object.name, object); });
  return bones;
}
