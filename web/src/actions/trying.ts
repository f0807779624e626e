// Poses that are tried on the avatar before they are kept.
import {reshaped} from "../model/posing.ts";
import {pause} from "../playback/player.ts";
import {say} from "../state/messages.ts";
import {beginTrial, endTrial, inHand, trial} from "../state/posing.ts";
import {edit, playheadFrame, studioDocument} from "../state/store.ts";
import {addPose} from "./editing.ts";

// The pose in hand, or what the avatar shows at the playhead.
export function tryShown(): void {
  if (trial.value) return;
  pause();
  const hand = inHand.value;
  const shown = studioDocument.value.motion?.frames[playheadFrame.value];
  if (hand?.control) beginTrial(hand.control, hand.frame);
  else if (shown) beginTrial(null, shown);
  else return;
  say("You are trying a pose. Keep it or drop it when you have seen enough.");
}

export function keepTried(): void {
  if (!trial.value) return;
  const {control, frames, at} = trial.value;
  endTrial();
  if (!control) {
    addPose("Keep the tried pose", "Tried pose", [frames[at]!], 1, playheadFrame.value);
    return;
  }
  const base = reshaped(control, frames[0]!, frames[at]!);
  edit("Keep the tried pose", draft => {
    const one = draft.poseControls.find(each => each.id === control.id);
    if (one) one.base = base as number[][];
  });
  say(`${control.name} has the tried pose.`);
}

export function dropTried(): void {
  if (!trial.value) return;
  endTrial();
  say("The tried pose is dropped.");
}
