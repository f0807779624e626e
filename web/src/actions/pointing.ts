// The avatar points at the ball, at a word.
import {fps} from "../model/document.ts";
import {complain} from "../state/messages.ts";
import {ball, firstBall, pointed, pointingLength} from "../state/stage.ts";
import {playhead, studioDocument} from "../state/store.ts";
import {addPose} from "./editing.ts";

// The word at the playhead, or the one before it.
export function wordHere(): {readonly word: string; readonly middle_s: number} | null {
  const words = studioDocument.value.speech?.words ?? [];
  const word = words.findLast(one => one.start_s <= playhead.value + 1e-6) ?? words[0];
  return word ? {word: word.word, middle_s: (word.start_s + word.end_s) / 2} : null;
}

export function pointHere(): void {
  const word = wordHere();
  const pose = pointed.value;
  if (!word || !pose) {
    complain(word ? "The avatar does not reach there: move the ball." : "Generate first: the avatar points at a word of its speech.");
    return;
  }
  const length = pointingLength.value;
  addPose(`Point at “${word.word}”`, `Point: ${word.word}`, [pose.frame], length, Math.max(0, Math.round(word.middle_s * fps - length / 2)));
}

export function toggleBall(): void {
  ball.value = ball.value ? null : firstBall;
}
