// Where edges stop when they are dragged: borders of words, accents, the playhead, the marked range, other controls' ends.
import {fps, type StudioDocument} from "./document.ts";
import {allControls, endOf} from "./controls.ts";

// In frames, not rounded, in order. `moving`: the ids of what is dragged, whose own ends do not count.
export function snapPoints(document: StudioDocument, moving: ReadonlySet<string>, playhead_s: number): number[] {
  const points = [0, playhead_s * fps];
  for (const word of document.speech?.words ?? []) points.push(word.start_s * fps, word.end_s * fps);
  for (const accent of document.speech?.accents ?? []) points.push(accent.start_s * fps);
  if (document.range) points.push(document.range.from, document.range.to);
  for (const control of allControls(document))
    if (!moving.has(control.id)) points.push(control.start, endOf(control));
  if (document.speech) points.push(document.speech.duration_s * fps);
  return points.sort((a, b) => a - b);
}

// The nearest point within reach.
function near(frame: number, points: readonly number[], reach: number): number | null {
  let best: number | null = null;
  for (const point of points)
    if (Math.abs(point - frame) < (best === null ? reach : Math.abs(best - frame))) best = point;
  return best;
}

// The whole frame nearest to the nearest point within reach, else the nearest whole frame.
export const snapped = (frame: number, points: readonly number[], reach: number): number => Math.round(near(frame, points, reach) ?? frame);

// For something with two ends that moves: the shift that brings an end to a point, the one that is nearer to one.
export function snappedShift(start: number, length: number, by: number, points: readonly number[], reach: number): number {
  const shifts = [start, start + length].flatMap(end => {
    const point = near(end + by, points, reach);
    return point === null ? [] : [{shift: Math.round(point) - end, distance: Math.abs(point - end - by)}];
  });
  return shifts.sort((a, b) => a.distance - b.distance)[0]?.shift ?? Math.round(by);
}

// The next word's border before or behind a frame, as a frame; the speech's ends where there is none.
export function nextBorder(document: StudioDocument, frame: number, way: 1 | -1): number {
  const borders = (document.speech?.words ?? []).flatMap(word => [Math.round(word.start_s * fps), Math.round(word.end_s * fps)]);
  const end = Math.floor((document.speech?.duration_s ?? 0) * fps);
  const ahead = [0, ...borders, end].filter(border => way === 1 ? border > frame : border < frame);
  if (ahead.length === 0) return frame;
  return way === 1 ? Math.min(...ahead) : Math.max(...ahead);
}
