// The pose that is in hand: of the control that is selected, while the playhead stands in it and nothing plays; or one that
// is tried without being kept yet. A change to it is a draft until it is let go.
import {computed, signal} from "@preact/signals";
import {tracksOf} from "../api/client.ts";
import {endOf, posesOf} from "../model/controls.ts";
import {fps, type Frame, type PoseControl, type Tracks} from "../model/document.ts";
import {reshaped, type Part} from "../model/posing.ts";
import {latest} from "./latest.ts";
import {relaxes} from "./server.ts";
import {edit, playhead, playing, selected} from "./store.ts";

export interface InHand { readonly control: PoseControl | null; readonly frame: Frame }

// What is tried: the control that it would change, or none; each pose so far, and which of them is shown.
export interface Trial { readonly control: PoseControl | null; readonly frames: readonly Frame[]; readonly at: number; readonly merge: string | null }
export const trial = signal<Trial | null>(null);

const ofControl = computed((): InHand | null => {
  const [one, ...others] = selected.value;
  const at = Math.floor(playhead.value * fps + 1e-6);
  if (playing.value || others.length > 0 || one?.kind !== "pose" || at < one.start || at >= endOf(one)) return null;
  return {control: one, frame: posesOf(one)[at - one.start]!};
});

export const inHand = computed((): InHand | null => {
  if (!trial.value) return ofControl.value;
  return playing.value ? null : {control: trial.value.control, frame: trial.value.frames[trial.value.at]!};
});

// How joints are worked: moved to a place, or turned.
export const handling = signal<"move" | "turn">("move");
export const turning = signal<Part | null>(null);

export const draft = signal<Frame | null>(null);
export const draftTracks = signal<Tracks | null>(null);

const ask = latest((frame: Frame) => tracksOf([frame], relaxes.value), tracks => { if (draft.value) draftTracks.value = tracks; });

export function tryPose(frame: Frame): void {
  draft.value = frame;
  ask(frame);
}

export function dropPose(): void {
  if (trial.value) {
    tryPose(trial.value.frames[trial.value.at]!);
    return;
  }
  draft.value = null;
  draftTracks.value = null;
}

// A pose that was changed, from the one in hand: a draft of what is tried, else an edit of the control.
export function keepPose(hand: InHand, frame: Frame, label: string, merge: string | null): void {
  if (trial.value) {
    const {control, frames, at} = trial.value;
    const together = merge !== null && merge === trial.value.merge;
    trial.value = {control, frames: [...frames.slice(0, together ? at : at + 1), frame], at: together ? at : at + 1, merge};
    tryPose(frame);
    return;
  }
  if (!hand.control) return;
  const {id} = hand.control;
  const base = reshaped(hand.control, hand.frame, frame);
  edit(label, changing => {
    const control = changing.poseControls.find(one => one.id === id);
    if (control) control.base = base as number[][];
  }, merge === null ? null : `${merge} ${id}`);
}

export function beginTrial(control: PoseControl | null, frame: Frame): void {
  trial.value = {control, frames: [frame], at: 0, merge: null};
  tryPose(frame);
}

export function endTrial(): void {
  trial.value = null;
  dropPose();
}

// Whether there was a step of what is tried to go back or on.
export function stepTrial(way: 1 | -1): boolean {
  if (!trial.value) return false;
  const at = trial.value.at + way;
  if (at < 0 || at >= trial.value.frames.length) return false;
  trial.value = {...trial.value, at, merge: null};
  tryPose(trial.value.frames[at]!);
  return true;
}
