// Rules from words to gestures, and the gestures that they put on a speech.
import {fps, type Frame, type PoseControl, type StudioDocument, type Word} from "./document.ts";
import {nearestStart} from "./controls.ts";

export interface Rule { readonly word: string; readonly motions: readonly string[] }

interface Gesture { readonly id: string; readonly name: string; readonly frames: readonly Frame[] }

const most_frames = 3;  // a gesture may stand that far beside its word's middle

export const plainWord = (word: string): string => word.trim().toLowerCase().replace(/^[^\p{L}\p{N}]+|[^\p{L}\p{N}]+$/gu, "");

// A whole number from both, evenly spread: the same draw each time, another for each word of a speech and each seed.
export function drawn(seed: number, word: number): number {
  let x = (seed ^ Math.imul(word + 1, 0x9e3779b9)) >>> 0;
  x = Math.imul(x ^ x >>> 16, 0x85ebca6b);
  x = Math.imul(x ^ x >>> 13, 0xc2b2ae35);
  return (x ^ x >>> 16) >>> 0;
}

// What a control that a rule has put looks like as long as nobody has changed it.
export function markOf({start, length, name, mirrored, base}: Pick<PoseControl, "start" | "length" | "name" | "mirrored" | "base">): string {
  let hash = 0x811c9dc5;
  for (const letter of JSON.stringify([start, length, name, mirrored, base])) hash = Math.imul(hash ^ letter.codePointAt(0)!, 0x01000193);
  return (hash >>> 0).toString(16);
}

// Whether a rule has put it and nobody has changed it since: rules may take it away again.
export const isOfRules = (control: PoseControl): boolean => control.rule !== null && control.rule === markOf(control);

export interface Placed { readonly controls: readonly PoseControl[]; readonly put: number; readonly noRoom: number }

// The pose controls with a gesture centred on each word that has a rule, where there is room. What rules have put before
// goes; what a person has put or changed stays.
export function byRules(document: Pick<StudioDocument, "poseControls" | "seed">, words: readonly Word[], total: number, rules: readonly Rule[],
    gestures: readonly Gesture[], newId: () => string): Placed {
  const controls: PoseControl[] = document.poseControls.filter(control => !isOfRules(control));
  const known = new Map(gestures.map(one => [one.id, one]));
  const rulesOf = new Map(rules.map(rule => [plainWord(rule.word), rule]));
  const before = controls.length;
  let noRoom = 0;
  words.forEach((word, k) => {
    const choice = (rulesOf.get(plainWord(word.word))?.motions ?? []).flatMap(id => known.get(id) ?? []);
    if (choice.length === 0) return;
    const {name, frames} = choice[drawn(document.seed, k) % choice.length]!;
    const length = frames.length;
    const wanted = Math.min(Math.max(0, Math.round((word.start_s + word.end_s) / 2 * fps - length / 2)), total - length);
    const start = length > total ? null : nearestStart(controls, length, wanted, total);
    if (start === null || Math.abs(start - wanted) > most_frames) {
      ++noRoom;
      return;
    }
    const made = {start, length, name, mirrored: false, base: frames};
    controls.push({kind: "pose", id: newId(), ...made, rule: markOf(made)});
  });
  return {controls, put: controls.length - before, noRoom};
}
