// The time that is left of a trial: as the server said it last, and counted down from there while it is worked on.
import {signal} from "@preact/signals";
import {atWork} from "../state/mode.ts";

const tick_ms = 200;

export const left_s = signal<number | null>(null);

// What is said of it, once each, to those who do not watch the clock.
const announcements: readonly (readonly [left_s: number, words: string])[] = [[10, "10 seconds left."], [60, "1 minute left."]];
export const announced = signal("");

export function setLeft(seconds: number | null): void {
  const before = left_s.value;
  left_s.value = seconds === null ? null : Math.max(0, seconds);
  if (before === null || seconds === null || seconds > before + 1) announced.value = "";
  else announced.value = announcements.find(([at]) => before > at && seconds <= at)?.[1] ?? announced.value;
}

// Called once; `each` with every tick.
export function startClock(each: () => void): void {
  let before = performance.now();
  setInterval(() => {
    const at = performance.now();
    if (atWork.value && left_s.value !== null) setLeft(left_s.value - (at - before) / 1000);
    before = at;
    each();
  }, tick_ms);
}
