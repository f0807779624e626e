// What the page leaves to the person: everything in the studio; in a session what its task is about. What is not offered is
// neither shown nor done by keys.
import {signal} from "@preact/signals";

export type Offer =
  "files" |    // projects as files, exports, films
  "kept" |     // what the server keeps: projects, rules, gestures of one's own, which others would find there
  "speech" |   // what is said, and by whom
  "systems" |  // what makes the gestures
  "sketch";    // what a model makes by itself: versions, variety, how a motion ends

export type Mode = ReadonlySet<Offer>;

export const studioMode: Mode = new Set<Offer>(["files", "kept", "speech", "systems", "sketch"]);
export const modelTask: Mode = new Set<Offer>(["sketch"]);
export const keyframesTask: Mode = new Set<Offer>();

export const mode = signal<Mode>(studioMode);
export const offers = (what: Offer): boolean => mode.value.has(what);

export const atWork = signal(true);  // whether the studio is in front: its keys work then
