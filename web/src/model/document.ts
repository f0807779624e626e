// What a project is: everything that is saved, undone and sent to the server. Times of controls are whole frames, 15 a
// second; of speech seconds.

export const fps = 15;
export const numbersPerFrame = 27;

// Nine unit directions, x y z each: neck, nose, head top, left shoulder, upper arm, forearm, right shoulder, upper arm,
// forearm. y is up, the figure faces +z, its left is +x.
export type Frame = readonly number[];

export interface Word { readonly word: string; readonly start_s: number; readonly end_s: number }
export interface Accent { readonly start_s: number; readonly end_s: number; readonly strength: number; readonly word: number }

export interface Speech {
  readonly text: string;
  readonly voice: string | null;
  readonly recording: string | null;  // the id of the recording that it is
  readonly duration_s: number;
  readonly words: readonly Word[];
  readonly accents: readonly Accent[];
  readonly pitch: readonly number[];  // Hz, 0 where there is none; evenly over the speech
  readonly pitch_fps: number;
  readonly wav: string;  // the sound's file in base64: a project is whole without a server; empty: its voice says it anew
}

// What the avatar's bones do: one flat row of x y z w per bone for each frame.
export interface Tracks {
  readonly fps: number;
  readonly bones: readonly string[];
  readonly rotations: readonly (readonly number[])[];
}

export interface Motion {
  readonly frames: readonly Frame[];
  readonly tracks: Tracks;
  readonly system: string;
  readonly synthetic: boolean;
  readonly madeFrom: string;  // fingerprint() of what it was generated with
}

// A stretch of frames that belongs to a track.
export interface Span { readonly id: string; readonly start: number; readonly length: number }

export interface PoseControl extends Span {
  readonly kind: "pose";
  readonly name: string;
  readonly base: readonly Frame[];  // as it was taken; shown at its own length, resampled
  readonly mirrored: boolean;
  readonly rule: string | null;  // put by a rule; markOf() says whether it was changed since
}

export const styleNames = ["speed", "space", "handedness"] as const;
export type StyleName = typeof styleNames[number];
export const styleLimit = 3;

// `at`: a share of the control, 0 to 1. In order; straight lines between.
export interface CurvePoint { readonly at: number; readonly value: number }

// null leaves a style to the model; 0 is a value.
export type StyleValue = number | null | readonly CurvePoint[];
export type StyleValues = { readonly [name in StyleName]: StyleValue };

export interface StyleControl extends Span, StyleValues { readonly kind: "style" }

export type Control = PoseControl | StyleControl;
export type TrackName = "pose" | "style";

// Frames from `from` to before `to`.
export interface Range { readonly from: number; readonly to: number }

// A speech that somebody recorded: a WAV file in base64, as it was chosen.
export interface Recording { readonly id: string; readonly name: string; readonly wav: string }

// How a motion is finished, by whatever system makes it.
export interface Finish {
  readonly fade: boolean;  // to the mean pose behind the last word
  readonly still: boolean;  // quite still where nothing is gestured
  readonly relaxedFingers: boolean;
}

export interface StudioDocument {
  readonly name: string;
  readonly text: string;
  readonly voice: string | null;  // null: the server's first
  readonly recording: Recording | null;  // in place of a voice
  readonly seed: number;
  readonly speech: Speech | null;
  readonly motion: Motion | null;
  readonly poseControls: readonly PoseControl[];
  readonly styleControls: readonly StyleControl[];
  readonly range: Range | null;
  readonly bypass: {readonly [track in TrackName]: boolean};  // controls that are there, but not generated with
  readonly exact: boolean;  // posed frames are met exactly
  readonly system: string | null;  // what makes the gestures; null: the server's first
  readonly variety: number;  // 0 to 2
  readonly finish: Finish;
  readonly byRules: boolean;  // gestures are put by rules whenever all is generated
  readonly home: string | null;  // the server's project that this is kept as; not in files
}

export const emptyDocument: StudioDocument = {
  name: "Untitled", text: "", voice: null, recording: null, seed: 1, speech: null, motion: null, poseControls: [], styleControls: [],
  range: null, bypass: {pose: false, style: false}, exact: false,
  system: null, variety: 0, finish: {fade: false, still: false, relaxedFingers: true}, byRules: false, home: null,
};

// The last frame lasts to the end of the sound. Answers round durations to a millionth of a second.
export const frameCountOf = (duration_s: number): number => Math.max(1, Math.ceil(duration_s * fps - 5e-5));
export const frameCount = (document: StudioDocument): number => document.speech ? frameCountOf(document.speech.duration_s) : 0;

// As projects of before there was a choice.
const isUsual = (choice: unknown): boolean =>
    JSON.stringify(choice) === JSON.stringify([emptyDocument.system, emptyDocument.variety, emptyDocument.finish]);

// Whether the motion is of these controls: a short word that differs (almost certainly) where they do.
export function fingerprint(document: StudioDocument): string {
  const bare = (control: Control) => ({...control, id: "", name: "", rule: undefined});
  const {text, voice, recording, seed, exact, system, variety, finish, bypass, poseControls, styleControls} = document;
  const made = JSON.stringify([text.trim(), voice, recording?.id ?? null, seed, exact, bypass.pose ? [] : poseControls.map(bare),
    bypass.style ? [] : styleControls.map(bare), ...isUsual([system, variety, finish]) ? [] : [system, variety, finish]]);
  let hash = 0x811c9dc5;
  for (let k = 0; k < made.length; ++k) hash = Math.imul(hash ^ made.charCodeAt(k), 0x01000193);
  return `${(hash >>> 0).toString(16)}-${made.length}`;
}
