// The pose control that is in hand: the one that is selected, while the playhead stands in it and nothing plays. A change to
// it is a draft until it is let go.
import {computed, signal} from "@preact/signals";
import {tracksOf} from "../api/client.ts";
import {endOf, posesOf} from "../model/controls.ts";
import {fps, type Frame, type PoseControl, type Tracks} from "../model/document.ts";
import {reshaped} from "../model/posing.ts";
import {edit, playhead, playing, selected} from "./store.ts";

export interface InHand { readonly control: PoseControl; readonly frame: Frame }

export const inHand = computed((): InHand | null => {
  const [one, ...others] = selected.value;
  const at = Math.floor(playhead.value * fps + 1e-6);
  if (playing.value || others.length > 0 || one?.kind !== "pose" || at < one.start || at >= endOf(one)) return null;
  return {control: one, frame: posesOf(one)[at - one.start]!};
});

export const draft = signal<Frame | null>(null);
export const draftTracks = signal<Tracks | null>(null);

let asking = false;

// One request at a time; what came meanwhile follows, the last of it only.
function ask(frame: Frame): void {
  asking = true;
  void tracksOf([frame]).then(tracks => {
    asking = false;
    const now = draft.value;
    if (!now) return;
    draftTracks.value = tracks;
    if (now !== frame) ask(now);
  }, () => { asking = false; });
}

export function tryPose(frame: Frame): void {
  draft.value = frame;
  if (!asking) ask(frame);
}

export function dropPose(): void {
  draft.value = null;
  draftTracks.value = null;
}

export function keepPose(hand: InHand, frame: Frame, label: string, merge: string | null): void {
  const base = reshaped(hand.control, hand.frame, frame);
  edit(label, changing => {
    const control = changing.poseControls.find(one => one.id === hand.control.id);
    if (control) control.base = base as number[][];
  }, merge);
}
