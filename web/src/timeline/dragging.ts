// Dragging on the timeline: controls by their middle or an end, the marked range, the playhead. While it goes on only the
// picture changes; letting go is one edit, Escape none.
import {signal} from "@preact/signals";
import {endOf, controlsOf, movedTogether, stretched} from "../model/controls.ts";
import {secondsOf} from "../model/frames.ts";
import type {Control, Range} from "../model/document.ts";
import {snapped, snappedShift, snapPoints} from "../model/snapping.ts";
import {mark, move, show, stretch} from "../actions/editing.ts";
import {seek} from "../playback/player.ts";
import {playhead, select, selection, settle, snapping, studioDocument, totalFrames} from "../state/store.ts";
import {followPointer} from "../ui/follow_pointer.ts";
import {frameOfX} from "./scale.ts";

export type Part = "middle" | "start" | "end";

const reach_px = 7;
const slack_px = 3;  // a click may tremble

// Where controls are drawn while they are dragged.
export const dragged = signal<ReadonlyMap<string, {start: number; length: number}>>(new Map());
export const draggedRange = signal<Range | null>(null);

interface Drag { moved(dx: number, x: number, free: boolean): void; dropped(): void; cancelled(): void; clicked?(): void }

// Follows one pointer from its press on. x is in pixels of the tracks' content.
function follow(event: PointerEvent, content: Element, drag: Drag): void {
  if (event.button !== 0) return;
  const left = () => content.getBoundingClientRect().left;
  const begin = event.clientX - left();
  let far = false;
  followPointer(event, {
    moved(next) {
      const x = next.clientX - left();
      far ||= Math.abs(x - begin) > slack_px;
      if (far) drag.moved(x - begin, x, next.altKey || !snapping.value);
    },
    ended(kept) {
      if (!kept) drag.cancelled();
      else if (far) drag.dropped();
      else drag.clicked?.();
    }});
}

const reach = (free: boolean) => free ? 0 : frameOfX(reach_px);

export function dragControl(event: PointerEvent, content: Element, control: Control, part: Part): void {
  const adding = event.shiftKey || event.ctrlKey || event.metaKey;
  if (!selection.value.has(control.id)) select(...(adding ? [...selection.value] : []), control.id);
  const moving = part === "middle" ? selection.value : new Set([control.id]);
  const project = studioDocument.value;
  const points = snapPoints(project, moving, playhead.value);
  const forget = () => { dragged.value = new Map(); };
  let drop = () => {};
  follow(event, content, {
    moved(dx, _x, free) {
      if (part === "middle") {
        const by = snappedShift(control.start, control.length, frameOfX(dx), points, reach(free));
        dragged.value = new Map((["pose", "style"] as const).flatMap(track => {
          const controls = controlsOf(project, track);
          return [...movedTogether(controls, moving, by, totalFrames.value)].map(([id, start]) =>
              [id, {start, length: controls.find(one => one.id === id)!.length}] as const);
        }));
        drop = () => move(by);
      } else {
        const frame = snapped((part === "start" ? control.start : endOf(control)) + frameOfX(dx), points, reach(free));
        const {start, length} = stretched(controlsOf(project, control.kind), control.id, part, frame, totalFrames.value);
        dragged.value = new Map([[control.id, {start, length}]]);
        drop = () => stretch(control.id, part, frame);
      }
    },
    dropped() {
      settle();  // each drag is an edit of its own
      drop();
      settle();
      forget();
    },
    cancelled: forget,
    clicked() {
      if (adding) return;
      select(control.id);
      show(control);
    },
  });
}

// Marks a range; a click puts the playhead there.
export function dragRange(event: PointerEvent, content: Element, from: number | null = null): void {
  const points = snapPoints(studioDocument.value, new Set(), playhead.value);
  const begin = event.clientX - content.getBoundingClientRect().left;
  const forget = () => { draggedRange.value = null; };
  follow(event, content, {
    moved(_dx, x, free) {
      const fixed = from ?? snapped(frameOfX(begin), points, reach(free));
      const frame = Math.min(Math.max(0, snapped(frameOfX(x), points, reach(free))), totalFrames.value);
      draggedRange.value = {from: Math.min(fixed, frame), to: Math.max(fixed, frame)};
    },
    dropped() {
      if (draggedRange.value) mark(draggedRange.value.from, draggedRange.value.to);
      forget();
    },
    cancelled: forget,
    clicked() {
      if (from !== null) return;
      select();
      seek(secondsOf(frameOfX(begin)));
    },
  });
}

export function dragPlayhead(event: PointerEvent, content: Element): void {
  const at = (x: number) => seek(secondsOf(frameOfX(x)));
  const before = playhead.value;
  at(event.clientX - content.getBoundingClientRect().left);
  follow(event, content, {moved: (_dx, x) => at(x), dropped: () => {}, cancelled: () => seek(before)});
}
