// What is done to controls, the range and the text, each as one edit that can be undone. Where there is no room it says so.
import type {Draft} from "immer";
import type {LibraryMotion} from "../api/client.ts";
import {allControls, controlsOf, controlOf, endOf, gapAt, movedTogether, nearestStart, scaled, stretched} from "../model/controls.ts";
import {opposite} from "../model/curves.ts";
import {fps, styleNames, type Control, type Frame, type PoseControl, type StudioDocument, type StyleControl, type StyleName,
  type StyleValue, type StyleValues, type TrackName} from "../model/document.ts";
import {lengthAtSpeed, secondsOf} from "../model/frames.ts";
import {seek} from "../playback/player.ts";
import {complain, say} from "../state/messages.ts";
import {edit, newId, playheadFrame, playing, select, selected, selection, studioDocument, totalFrames} from "../state/store.ts";

type Changing = Draft<StudioDocument>;

const listOf = (draft: Changing, track: TrackName) => track === "pose" ? draft.poseControls : draft.styleControls;

function found(draft: Changing, id: string): Draft<Control> | undefined {
  return draft.poseControls.find(one => one.id === id) ?? draft.styleControls.find(one => one.id === id);
}

const noRoom = (track: TrackName, length: number) => complain(
    `There is no gap of ${(length / fps).toFixed(2)} s among the ${track} controls. Shorten, move or delete one, or add at higher speed.`);

// The nearest start at or about a frame, or null after having said that there is no room.
function roomFor(track: TrackName, length: number, wanted: number): number | null {
  const start = nearestStart(controlsOf(studioDocument.value, track), length, wanted, totalFrames.value);
  if (start === null) noRoom(track, length);
  return start;
}

// The playhead goes into a control that is chosen, so that its pose is seen.
export function show(control: Control): void {
  const frame = playheadFrame.value;
  if (!playing.value && control.kind === "pose" && (frame < control.start || frame >= endOf(control))) seek(secondsOf(control.start));
}

// One pose, or a movement, in the gap that is nearest to a frame.
export function addPose(label: string, name: string, base: readonly Frame[], length: number, wanted: number): void {
  const start = roomFor("pose", length, wanted);
  if (start === null) return;
  const id = newId();
  edit(label, draft => {
    draft.poseControls.push({kind: "pose", id, start, length, name, base: base as number[][], mirrored: false, rule: null});
  });
  select(id);
  show(controlOf(studioDocument.value, id)!);
  say(`${name} added at ${(start / fps).toFixed(2)} s.`);
}

export function addGesture(motion: LibraryMotion, speed: number, wanted = playheadFrame.value): void {
  addPose(`Add ${motion.name}`, motion.name, motion.frames, lengthAtSpeed(motion.frames.length, speed), wanted);
}

// What the avatar shows now, or does in the marked range, as a control: those frames stay when the rest is made anew.
export function addShown(): void {
  const {motion, range} = studioDocument.value;
  if (!motion) return;
  const from = range ? range.from : playheadFrame.value;
  const to = range ? range.to : from + 1;
  addPose(range ? "Keep the marked range" : "Keep this pose", range ? "Kept range" : "Kept pose", motion.frames.slice(from, to), to - from, from);
}

// In the marked range, else a second from the playhead on, or as much as there is room for.
export function addStyle(values: StyleValues): void {
  const {range, styleControls} = studioDocument.value;
  const gap = gapAt(styleControls, range ? range.from : playheadFrame.value, totalFrames.value);
  if (!gap) {
    noRoom("style", 1);
    return;
  }
  const wanted = range ? range.from : playheadFrame.value;
  const start = Math.min(Math.max(wanted, gap.from), gap.to - 1);
  const length = Math.min(range ? range.to - range.from : fps, gap.to - start);
  const id = newId();
  edit("Add style", draft => { draft.styleControls.push({kind: "style", id, start, length, ...values} as Draft<StyleControl>); });
  select(id);
  say(`Style added at ${(start / fps).toFixed(2)} s.`);
}

export function remove(): void {
  const gone = selection.value;
  if (gone.size === 0) return;
  edit(gone.size === 1 ? "Delete control" : `Delete ${gone.size} controls`, draft => {
    draft.poseControls = draft.poseControls.filter(one => !gone.has(one.id));
    draft.styleControls = draft.styleControls.filter(one => !gone.has(one.id));
  });
  say(gone.size === 1 ? "Control deleted." : `${gone.size} controls deleted.`);
}

// The selection, by frames; on each track as far as the others there allow.
export function move(by: number): void {
  const total = totalFrames.value;
  edit("Move", draft => {
    for (const track of ["pose", "style"] as const)
      for (const [id, start] of movedTogether(controlsOf(studioDocument.value, track), selection.value, by, total)) {
        const control = listOf(draft, track).find(one => one.id === id);
        if (control) control.start = start;
      }
  }, `move ${[...selection.value].join()}`);
}

export function stretch(id: string, end: "start" | "end", frame: number): void {
  const control = controlOf(studioDocument.value, id);
  if (!control) return;
  const span = stretched(controlsOf(studioDocument.value, control.kind), id, end, frame, totalFrames.value);
  edit("Stretch", draft => {
    const changed = found(draft, id)!;
    changed.start = span.start;
    changed.length = span.length;
  }, `stretch ${id}`);
}

export function setLength(control: Control, length: number): void {
  stretch(control.id, "end", control.start + Math.round(length));
  const now = controlOf(studioDocument.value, control.id);
  if (now && now.length < Math.round(length)) say(`Only ${now.length} frames have room here.`);
}

export function setStart(control: Control, start: number): void {
  const others = controlsOf(studioDocument.value, control.kind).filter(one => one.id !== control.id);
  const at = nearestStart(others, control.length, Math.round(start), totalFrames.value);
  if (at !== null) edit("Move", draft => { found(draft, control.id)!.start = at; }, `move ${control.id}`);
}

export const setSpeed = (control: PoseControl, speed: number): void => setLength(control, lengthAtSpeed(control.base.length, speed));

// Left and right change sides: of what is selected, or of all; in styles the handedness.
export function flip(what: "selected" | "all" = "selected"): void {
  const all = what === "all";
  const controls = all ? allControls(studioDocument.value) : selected.value;
  const ids = new Set(controls.map(control => control.id));
  if (ids.size === 0) return;
  edit(all ? "Mirror all controls" : "Flip left and right", draft => {
    for (const control of draft.poseControls) if (ids.has(control.id)) control.mirrored = !control.mirrored;
    for (const control of draft.styleControls) if (ids.has(control.id)) control.handedness = opposite(control.handedness) as Draft<StyleValue>;
  });
  if (all) say(`${ids.size} controls mirrored.`);
}

// Times of what is selected, or of all controls, by a factor: about the first one's start, or the speech's.
export function scaleTimes(factor: number): void {
  const project = studioDocument.value;
  const chosen = selected.value.length > 0 ? selected.value : allControls(project);
  const ids = new Set(chosen.map(control => control.id));
  const from = selected.value.length > 0 ? Math.min(...chosen.map(control => control.start)) : 0;
  const [poses, styles] = [scaled(project.poseControls, ids, factor, from, totalFrames.value), scaled(project.styleControls, ids, factor, from, totalFrames.value)];
  if (!poses || !styles) {
    complain(`At ${Math.round(100 * factor)} % they would meet other controls or the speech's end.`);
    return;
  }
  edit(`Scale times to ${Math.round(100 * factor)} %`, draft => {
    for (const control of [...draft.poseControls, ...draft.styleControls]) Object.assign(control, poses.get(control.id) ?? styles.get(control.id));
  });
  say(`Times scaled to ${Math.round(100 * factor)} %.`);
}

export function setStyle(id: string, name: StyleName, value: StyleValue): void {
  edit(`Change ${name}`, draft => {
    const control = draft.styleControls.find(one => one.id === id);
    if (control) control[name] = value as Draft<StyleValue>;
  }, value === null ? null : `style ${id} ${name}`);
}

export function setStyles(id: string, values: StyleValues, label: string): void {
  edit(label, draft => {
    const control = draft.styleControls.find(one => one.id === id);
    if (control) for (const name of styleNames) control[name] = values[name] as Draft<StyleValue>;
  });
}

// Frames of the marked range; nothing where it would be empty.
export function mark(from: number, to: number, merge: string | null = null): void {
  const total = totalFrames.value;
  const [low, high] = [Math.max(0, Math.min(from, to)), Math.min(total, Math.max(from, to))];
  if (high > low) edit("Mark a range", draft => { draft.range = {from: low, to: high}; }, merge);
}

export function unmark(): void {
  if (studioDocument.value.range) edit("Clear the marked range", draft => { draft.range = null; });
}

let copied: readonly Control[] = [];
export const forgetCopied = (): void => { copied = []; };

export function copy(): void {
  if (selected.value.length === 0) return;
  copied = selected.value;
  say(copied.length === 1 ? "Copied." : `${copied.length} controls copied.`);
}

export function cut(): void {
  copy();
  remove();
}

// The first of what was copied at the playhead, the others as far behind it as they were; each in the nearest gap.
export function paste(): void {
  if (copied.length === 0 || totalFrames.value === 0) return;
  const first = Math.min(...copied.map(control => control.start));
  const placed: Control[] = [];
  for (const control of copied) {
    const others = [...controlsOf(studioDocument.value, control.kind), ...placed.filter(one => one.kind === control.kind)];
    const start = nearestStart(others, control.length, playheadFrame.value + control.start - first, totalFrames.value);
    if (start === null) {
      noRoom(control.kind, control.length);
      return;
    }
    placed.push({...control, id: newId(), start});
  }
  edit(placed.length === 1 ? "Paste" : `Paste ${placed.length} controls`, draft => {
    for (const control of placed)
      if (control.kind === "pose") draft.poseControls.push(control as Draft<PoseControl>);
      else draft.styleControls.push(control as Draft<StyleControl>);
  });
  select(...placed.map(control => control.id));
  say(placed.length === 1 ? "Pasted." : `${placed.length} controls pasted.`);
}
