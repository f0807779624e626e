// How wide a second is, and what lies where.
import {computed, signal} from "@preact/signals";
import {fps} from "../model/document.ts";
import {duration, zoom} from "../state/store.ts";

export const viewport = signal(800);  // px of the tracks that are in sight
const closest_px = 240;  // a second when it is seen from nearest


export const pixelsPerSecond = computed(() => duration.value > 0 ? viewport.value * zoom.value / duration.value : 0);
export const contentWidth = computed(() => Math.round(viewport.value * zoom.value));
export const xOfSeconds = (time_s: number): number => time_s * pixelsPerSecond.value;
// The last frame begins within the sound, and is drawn to its end only.
export const xOfFrame = (frame: number): number => xOfSeconds(Math.min(frame / fps, duration.value));
// Not rounded.
export const frameOfX = (x: number): number => pixelsPerSecond.value > 0 ? x / pixelsPerSecond.value * fps : 0;

export const zoomLimit = computed(() => Math.max(1, closest_px * duration.value / viewport.value));

// Seconds between the ruler's numbers: about 80 px, a round number.
export const rulerStep = computed(() => {
  const wanted = 80 / Math.max(1e-6, pixelsPerSecond.value);
  return [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60].find(step => step >= wanted) ?? 120;
});

export function zoomBy(factor: number): void {
  zoom.value = Math.min(zoomLimit.value, Math.max(1, zoom.value * factor));
}
