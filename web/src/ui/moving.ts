// Something on the avatar's picture that is moved in space: dragged over the picture, or by the arrow keys.
import type {Point} from "../model/posing.ts";
import type {AvatarView} from "../view/avatar_view.ts";
import {followPointer} from "./follow_pointer.ts";

export interface Moving {
  from(): Point | null;
  tried(to: Point): void;
  kept(to: Point): void;
  dropped(): void;
}

export function pressToMove(event: PointerEvent, view: AvatarView, moving: Moving): void {
  const from = moving.from();
  if (event.button !== 0 || !from) return;
  const {clientX, clientY} = event;
  let last: Point | null = null;
  followPointer(event, {
    moved(next) {
      last = view.shifted(from, next.clientX - clientX, clientY - next.clientY);
      moving.tried(last);
    },
    ended(kept) {
      if (kept && last) moving.kept(last);
      moving.dropped();
    }});
}

const step_px = 6;
const step_m = 0.02;

// Where an arrow key leads: over the picture, with Shift up and down away and near. null for other keys.
export function steppedByKey(event: KeyboardEvent, view: AvatarView, from: Point): Point | null {
  const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
  if (!step || event.ctrlKey) return null;
  event.preventDefault();
  event.stopPropagation();
  return event.shiftKey && step[1] !== 0 ? view.shifted(from, 0, 0, -step_m * step[1]!) : view.shifted(from, step_px * step[0]!, step_px * step[1]!);
}
