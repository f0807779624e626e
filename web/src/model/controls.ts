// Controls on a track, as pure functions of lists. The rule for overlaps: there are none. What is moved, stretched or added
// keeps clear of the others: it stops at them, or goes into the nearest gap that has room.
import {fps, frameCount, type Control, type PoseControl, type Span, type StudioDocument, type StyleControl, type StyleValue, type TrackName} from "./document.ts";
import {isCurve} from "./curves.ts";
import {mirrored, resampled} from "./frames.ts";

interface Gap { readonly from: number; readonly to: number }

export const endOf = (span: Span): number => span.start + span.length;
export const inOrder = <T extends Span>(spans: readonly T[]): T[] => [...spans].sort((a, b) => a.start - b.start);

export const controlsOf = (document: StudioDocument, track: TrackName): readonly Control[] =>
    track === "pose" ? document.poseControls : document.styleControls;
export const allControls = (document: StudioDocument): readonly Control[] => [...document.poseControls, ...document.styleControls];
export const controlOf = (document: StudioDocument, id: string): Control | undefined =>
    allControls(document).find(control => control.id === id);

export function gapsOf(spans: readonly Span[], total: number): Gap[] {
  const gaps: Gap[] = [];
  let from = 0;
  for (const span of inOrder(spans)) {
    if (span.start > from) gaps.push({from, to: span.start});
    from = Math.max(from, endOf(span));
  }
  if (from < total) gaps.push({from, to: total});
  return gaps;
}

// Where something of that length can start that is nearest to where it is wanted; null where no gap has room.
export function nearestStart(others: readonly Span[], length: number, wanted: number, total: number): number | null {
  let best: number | null = null;
  for (const gap of gapsOf(others, total)) {
    if (gap.to - gap.from < length) continue;
    const start = Math.min(Math.max(wanted, gap.from), gap.to - length);
    if (best === null || Math.abs(start - wanted) < Math.abs(best - wanted)) best = start;
  }
  return best;
}

// The gap at or behind a frame, else the last one before it.
export function gapAt(spans: readonly Span[], frame: number, total: number): Gap | null {
  const gaps = gapsOf(spans, total);
  return gaps.find(gap => gap.to > frame) ?? gaps.at(-1) ?? null;
}

// All of them by the same number of frames: as many as the ends and the others allow, none where that leads nowhere.
export function movedTogether(spans: readonly Span[], ids: ReadonlySet<string>, by: number, total: number): Map<string, number> {
  const moving = spans.filter(span => ids.has(span.id));
  const others = spans.filter(span => !ids.has(span.id));
  const starts = new Map(moving.map(span => [span.id, span.start]));
  if (moving.length === 1) {
    const [one] = moving as [Span];
    const start = nearestStart(others, one.length, one.start + by, total);
    if (start !== null) starts.set(one.id, start);
    return starts;
  }
  const fits = (shift: number) => moving.every(span => span.start + shift >= 0 && endOf(span) + shift <= total &&
      others.every(other => endOf(span) + shift <= other.start || span.start + shift >= endOf(other)));
  let shift = by;
  while (shift !== 0 && !fits(shift)) shift -= Math.sign(shift);
  for (const span of moving) starts.set(span.id, span.start + shift);
  return starts;
}

// One end of a control is pulled to a frame; the other stays, neighbours and the track's ends stop it.
export function stretched(spans: readonly Span[], id: string, end: "start" | "end", frame: number, total: number): Span {
  const span = spans.find(one => one.id === id)!;
  const others = spans.filter(one => one.id !== id);
  if (end === "end") {
    const limit = Math.min(total, ...others.filter(one => one.start >= endOf(span)).map(one => one.start));
    return {...span, length: Math.max(1, Math.min(frame, limit) - span.start)};
  }
  const limit = Math.max(0, ...others.filter(one => endOf(one) <= span.start).map(endOf));
  const start = Math.min(Math.max(frame, limit), endOf(span) - 1);
  return {...span, start, length: endOf(span) - start};
}

// The poses of a control, frame by frame as they stand on the track.
export function posesOf(control: PoseControl): readonly (readonly number[])[] {
  const frames = control.mirrored ? control.base.map(mirrored) : control.base;
  return frames.length === control.length ? frames : resampled(frames, control.length);
}

// Those that do not fit into a shorter speech are left out, the last one that reaches over its end is cut there if it is a
// style; a gesture that is cut would be another one.
export function fitting<T extends Control>(controls: readonly T[], total: number): T[] {
  return controls.flatMap(control => {
    if (endOf(control) <= total) return [control];
    if (control.kind === "style" && control.start < total) return [{...control, length: total - control.start}];
    return [];
  });
}

const value = (one: StyleValue) => one === null ? "free" : isCurve(one) ? `a curve from ${one[0]!.value.toFixed(1)} to ${one.at(-1)!.value.toFixed(1)}` : one.toFixed(1);
export const styleWords = (control: StyleControl): string =>
    `speed ${value(control.speed)}, space ${value(control.space)}, handedness ${value(control.handedness)}`;

export const nameOf = (control: Control): string => control.kind === "pose" ? control.name : "Style";

export const spanWords = (span: Span): string =>
    `${(span.start / fps).toFixed(2)} to ${(endOf(span) / fps).toFixed(2)} s`;

// All of them, or those chosen, farther from or nearer to a frame, longer or shorter alike; null where they would meet
// others or the speech's end. None becomes shorter than a frame.
export function scaled(spans: readonly Span[], ids: ReadonlySet<string>, factor: number, from: number, total: number): Map<string, Span> | null {
  const to = (frame: number) => Math.round(from + (frame - from) * factor);
  const changed = spans.map(span => ids.has(span.id) ? {...span, start: to(span.start), length: Math.max(1, to(endOf(span)) - to(span.start))} : span);
  const ordered = inOrder(changed);
  const clear = ordered.every((span, k) => span.start >= 0 && endOf(span) <= (ordered[k + 1]?.start ?? total));
  return clear ? new Map(changed.filter(span => ids.has(span.id)).map(span => [span.id, {id: span.id, start: span.start, length: span.length}])) : null;
}

// Whether there is a gap for something of that length.
export const hasRoom = (document: StudioDocument, track: TrackName, length: number): boolean =>
    gapsOf(controlsOf(document, track), frameCount(document)).some(gap => gap.to - gap.from >= length);
