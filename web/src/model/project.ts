// A project as one JSON file, with a version. What is read is checked as a stranger's: a message says what is wrong with it.
import {emptyDocument, fps, frameCountOf, fingerprint, numbersPerFrame, styleLimit, styleNames, type Finish, type PoseControl, type Range,
  type Recording, type Speech, type StudioDocument, type StyleControl, type StyleValue, type StyleValues} from "./document.ts";
import {endOf, inOrder} from "./controls.ts";
import {isFrame} from "./frames.ts";

const format = "deixis-studio";
const version = 2;  // 1 had no curves, systems, options and rules

export interface LogLine { readonly at: string; readonly kind: string; readonly label: string }

export class ProjectError extends Error {}

// As an object of JSON.
export function projectFile({home: _, ...document}: StudioDocument, log: readonly LogLine[]): object {
  return {format, version, fps, document, log};
}
export const writeProject = (document: StudioDocument, log: readonly LogLine[]): string => JSON.stringify(projectFile(document, log));

const wrong = (where: string, expected: string): never => {
  throw new ProjectError(`This project cannot be opened: ${where} should be ${expected}.`);
};
type Fields = Record<string, unknown>;
const fields = (value: unknown, where: string): Fields =>
    typeof value === "object" && value !== null && !Array.isArray(value) ? value as Fields : wrong(where, "an object");
const list = (value: unknown, where: string): unknown[] => Array.isArray(value) ? value : wrong(where, "a list");
const text = (value: unknown, where: string): string => typeof value === "string" ? value : wrong(where, "text");
const textOrNull = (value: unknown, where: string): string | null => value === null ? null : text(value, where);
const flag = (value: unknown, where: string): boolean => typeof value === "boolean" ? value : wrong(where, "true or false");
const number = (value: unknown, where: string, low = -Infinity, high = Infinity): number =>
    typeof value === "number" && Number.isFinite(value) && value >= low && value <= high ? value
        : wrong(where, Number.isFinite(low) ? `a number from ${low}${Number.isFinite(high) ? ` to ${high}` : ""}` : "a number");
const whole = (value: unknown, where: string, low: number, high = Number.MAX_SAFE_INTEGER): number =>
    Number.isInteger(number(value, where, low, high)) ? value as number : wrong(where, "a whole number");
const frames = (value: unknown, where: string) => list(value, where).map((frame, k) =>
    isFrame(frame) ? frame : wrong(`${where}, frame ${k + 1}`, `${numbersPerFrame} numbers`));

function speechOf(value: unknown): Speech | null {
  if (value === null) return null;
  const speech = fields(value, "speech");
  const duration_s = number(speech.duration_s, "the speech's duration", 0);
  const times = (one: Fields, where: string) => ({
    start_s: number(one.start_s, `${where}'s start`, 0, duration_s + 0.01), end_s: number(one.end_s, `${where}'s end`, 0, duration_s + 0.01)});
  const words = list(speech.words, "the words").map((word, k) => {
    const one = fields(word, `word ${k + 1}`);
    return {word: text(one.word, `word ${k + 1}`), ...times(one, `word ${k + 1}`)};
  });
  const accents = list(speech.accents, "the accents").map((accent, k) => {
    const one = fields(accent, `accent ${k + 1}`);
    return {...times(one, `accent ${k + 1}`), strength: number(one.strength, `accent ${k + 1}'s strength`, 0, 1),
      word: whole(one.word, `accent ${k + 1}'s word`, 0, words.length - 1)};
  });
  const pitch = list(speech.pitch, "the pitch").map(one => number(one, "the pitch", 0));
  return {text: text(speech.text, "the speech's text"), voice: textOrNull(speech.voice, "the speech's voice"),
    recording: textOrNull(speech.recording, "the speech's recording"), duration_s, words, accents, pitch,
    pitch_fps: number(speech.pitch_fps, "the pitch's rate", 1),
    wav: speech.wav === undefined || speech.wav === null ? "" : text(speech.wav, "the speech's sound")};
}

function motionOf(value: unknown): StudioDocument["motion"] {
  if (value === null) return null;
  const motion = fields(value, "motion");
  const tracks = fields(motion.tracks, "the motion's tracks");
  const bones = list(tracks.bones, "the motion's bones").map((bone, k) => text(bone, `bone ${k + 1}`));
  const rotations = list(tracks.rotations, "the motion's rotations").map((row, k) => {
    const numbers = list(row, `rotations of frame ${k + 1}`);
    if (numbers.length !== 4 * bones.length) wrong(`rotations of frame ${k + 1}`, `${4 * bones.length} numbers`);
    return numbers.map(one => number(one, `rotations of frame ${k + 1}`));
  });
  if (rotations.length === 0) wrong("the motion's rotations", "a list of frames");
  return {frames: frames(motion.frames, "the motion's frames"), tracks: {fps: number(tracks.fps, "the motion's rate", 1), bones, rotations},
    system: text(motion.system, "the motion's system"), synthetic: flag(motion.synthetic, "the motion's 'synthetic'"),
    madeFrom: text(motion.madeFrom, "the motion's origin")};
}

function spanOf(one: Fields, where: string, total: number) {
  const start = whole(one.start, `${where}'s start`, 0);
  return {id: text(one.id, `${where}'s id`), start, length: whole(one.length, `${where}'s length`, 1, Math.max(1, total - start))};
}

function clear<T extends PoseControl | StyleControl>(controls: T[], where: string): T[] {
  const ordered = inOrder(controls);
  ordered.forEach((control, k) => {
    const next = ordered[k + 1];
    if (next && next.start < endOf(control)) wrong(where, "controls that do not overlap");
  });
  if (new Set(controls.map(control => control.id)).size < controls.length) wrong(where, "controls with ids of their own");
  return controls;
}

function poseControlsOf(value: unknown, total: number): PoseControl[] {
  return clear(list(value, "the pose controls").map((control, k) => {
    const where = `pose control ${k + 1}`;
    const one = fields(control, where);
    const base = frames(one.base, `${where}'s frames`);
    if (base.length === 0) wrong(`${where}'s frames`, "one frame at least");
    return {kind: "pose" as const, ...spanOf(one, where, total), name: text(one.name, `${where}'s name`), base,
      mirrored: flag(one.mirrored, `${where}'s 'mirrored'`), rule: one.rule === undefined ? null : textOrNull(one.rule, `${where}'s rule`)};
  }), "the pose controls");
}

function styleValueOf(value: unknown, where: string): StyleValue {
  if (value === null || !Array.isArray(value)) return value === null ? null : number(value, where, -styleLimit, styleLimit);
  const points = value.map((point, k) => {
    const one = fields(point, `${where}, point ${k + 1}`);
    return {at: number(one.at, `${where}, point ${k + 1}'s place`, 0, 1), value: number(one.value, `${where}, point ${k + 1}`, -styleLimit, styleLimit)};
  });
  if (points.length < 2 || points.some((point, k) => k > 0 && point.at <= points[k - 1]!.at)) wrong(where, "a number, null, or points in order");
  return points;
}

function styleControlsOf(value: unknown, total: number): StyleControl[] {
  return clear(list(value, "the style controls").map((control, k) => {
    const where = `style control ${k + 1}`;
    const one = fields(control, where);
    const values = Object.fromEntries(styleNames.map(name =>
        [name, styleValueOf(one[name], `${where}'s ${name}`)])) as unknown as StyleValues;
    return {kind: "style" as const, ...spanOf(one, where, total), ...values};
  }), "the style controls");
}

function rangeOf(value: unknown, total: number): Range | null {
  if (value === null) return null;
  const range = fields(value, "the marked range");
  const from = whole(range.from, "the marked range's start", 0);
  return {from, to: whole(range.to, "the marked range's end", from + 1, Math.max(from + 1, total))};
}

function recordingOf(value: unknown): Recording | null {
  if (value === null) return null;
  const one = fields(value, "the recording");
  return {id: text(one.id, "the recording's id"), name: text(one.name, "the recording's name"), wav: text(one.wav, "the recording's sound")};
}

function finishOf(value: unknown): Finish {
  const one = fields(value, "the options");
  return {fade: flag(one.fade, "whether it fades"), still: flag(one.still, "whether it is still"),
    relaxedFingers: flag(one.relaxedFingers, "whether fingers are relaxed")};
}

// Throws a ProjectError.
export function readProject(json: string): StudioDocument {
  let parsed: unknown;
  try {
    parsed = JSON.parse(json);
  } catch {
    throw new ProjectError("This file is not a project of the studio: it is not JSON.");
  }
  return projectOf(parsed);
}

// Of JSON that is read already. Throws a ProjectError.
export function projectOf(parsed: unknown): StudioDocument {
  const file = typeof parsed === "object" && parsed !== null ? parsed as Fields : {};
  if (file.format !== format) throw new ProjectError("This file is not a project of the studio.");
  if (typeof file.version !== "number" || file.version > version)
    throw new ProjectError(`This project is of version ${String(file.version)}; this studio reads versions up to ${version}. A newer studio opens it.`);
  const one = fields(file.document, "the document");
  const bypass = fields(one.bypass, "the bypass");
  const speech = speechOf(one.speech);
  const total = speech ? frameCountOf(speech.duration_s) : Infinity;  // which is not known before it is spoken
  const motion = motionOf(one.motion);
  if (motion && (!speech || motion.frames.length !== total || motion.tracks.rotations.length !== total))
    wrong("the motion", `${total} frames long, as the speech is`);
  return {...emptyDocument, name: text(one.name, "the name"), text: text(one.text, "the text"), voice: textOrNull(one.voice, "the voice"),
    recording: recordingOf(one.recording), seed: whole(one.seed, "the seed", 0), speech, motion, poseControls: poseControlsOf(one.poseControls, total),
    styleControls: styleControlsOf(one.styleControls, total), range: rangeOf(one.range, total),
    bypass: {pose: flag(bypass.pose, "the poses' bypass"), style: flag(bypass.style, "the styles' bypass")},
    exact: flag(one.exact, "whether poses are met exactly"),
    ...(file.version >= 2 && {system: textOrNull(one.system, "the system"), variety: number(one.variety, "the variety", 0, 2),
      finish: finishOf(one.finish), byRules: flag(one.byRules, "whether rules put gestures")})};
}

// A name that any file system takes.
export const fileNameOf = (document: StudioDocument, ending: string): string =>
    `${document.name.trim().replace(/[^\p{L}\p{N} _-]+/gu, "").trim().replace(/\s+/g, "-").slice(0, 60) || "untitled"}.${ending}`;

export const isCurrent = (document: StudioDocument): boolean => document.motion?.madeFrom === fingerprint(document);
