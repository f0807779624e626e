// Gestures that rules put on the words of the speech.
import type {Draft} from "immer";
import {wordsOf} from "../api/ask.ts";
import {frameCountOf, type PoseControl, type StudioDocument, type Word} from "../model/document.ts";
import {byRules, type Placed} from "../model/rules.ts";
import {library} from "../state/library.ts";
import {complain, say} from "../state/messages.ts";
import {loadRules, rules} from "../state/rules.ts";
import {edit, newId, studioDocument} from "../state/store.ts";

export function placedByRules(document: Pick<StudioDocument, "poseControls" | "seed">, {words, duration_s}: {words: readonly Word[]; duration_s: number}): Placed {
  return byRules(document, words, frameCountOf(duration_s), rules.value?.rules ?? [], library.value ?? [], newId);
}

const plural = (count: number, one: string, many: string) => count === 1 ? `1 ${one}` : `${count} ${many}`;

export async function putByRules(): Promise<void> {
  try {
    if (!rules.value) await loadRules();
  } catch (problem) {
    complain(wordsOf(problem));
    return;
  }
  const {speech} = studioDocument.value;
  if (!speech) {
    complain("Generate first: rules put gestures on the words of a speech.");
    return;
  }
  const {controls, put, noRoom} = placedByRules(studioDocument.value, speech);
  const changed = put > 0 || controls.length !== studioDocument.value.poseControls.length;
  if (changed) edit("Put gestures by rules", draft => { draft.poseControls = controls as Draft<PoseControl>[]; });
  const rest = noRoom > 0 ? ` ${plural(noRoom, "word had", "words had")} no room.` : "";
  say(put > 0 ? `${plural(put, "gesture", "gestures")} put by rules.${rest}` : noRoom > 0 ? `None put by rules:${rest.toLowerCase()}` : "No word of this speech has a rule.");
}
