// From where the avatar is seen, and the ball that it is asked to point at.
import {effect, signal, untracked} from "@preact/signals";
import {ServerError, wordsOf} from "../api/ask.ts";
import {tracksOf} from "../api/client.ts";
import {point, type Pointed, type PointingSide} from "../api/kept.ts";
import type {Tracks} from "../model/document.ts";
import type {Point} from "../model/posing.ts";
import type {Camera} from "../view/cameras.ts";
import {latest} from "./latest.ts";
import {relaxes} from "./server.ts";
import {playheadFrame, playing, studioDocument} from "./store.ts";

// A new object each time: choosing the same one again leads back there.
export const chosenCamera = signal<{readonly camera: Camera}>({camera: "front"});

// Metres; x to the avatar's left, y up, z ahead of it.
export const ballRoom: readonly (readonly [least: number, most: number])[] = [[-3, 3], [0, 3], [-3, 3]];
export const firstBall: Point = [-0.5, 1.4, 0.7];
export const ball = signal<Point | null>(null);
export const pointingSide = signal<PointingSide>("auto");
export const pointingLength = signal(12);  // frames
export const pointed = signal<Pointed | null>(null);
export const pointedTracks = signal<Tracks | null>(null);
export const pointingProblem = signal("");

export const putBall = (at: Point): void => {
  ball.value = at.map((one, k) => Math.round(1000 * Math.min(ballRoom[k]![1], Math.max(ballRoom[k]![0], one))) / 1000) as unknown as Point;
};

type Wanted = Parameters<typeof point>[0];
const ask = latest(async (wanted: Wanted) => {
  const made = await point(wanted);
  return {made, tracks: await tracksOf([made.frame], relaxes.value)};
}, ({made, tracks}) => {
  pointed.value = made;
  pointedTracks.value = tracks;
  pointingProblem.value = "";
}, problem => {
  pointed.value = null;
  pointedTracks.value = null;
  pointingProblem.value = problem instanceof ServerError && problem.field === "target_m" ? "Too near: keep the ball 0.3 m from the shoulder." : wordsOf(problem);
});

// Follows the ball. Called once.
export function startPointing(): void {
  effect(() => {
    const at = ball.value;
    if (!at || playing.value) return;
    const side = pointingSide.value;
    const pose = studioDocument.value.motion?.frames[playheadFrame.value];
    untracked(() => ask({target_m: at, side, ...(pose && {pose})}));
  });
}
