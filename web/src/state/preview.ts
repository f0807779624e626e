// What the avatar shows instead of the motion: a gesture of the library that is looked at, or the pose control in hand.
import {computed, effect, signal, untracked} from "@preact/signals";
import {tracksOf, type LibraryMotion} from "../api/client.ts";
import {posesOf} from "../model/controls.ts";
import {fps, type Frame, type PoseControl, type Tracks} from "../model/document.ts";
import {calm} from "./screen.ts";
import {draftTracks, inHand} from "./posing.ts";
import {relaxes} from "./server.ts";
import {ball, pointedTracks} from "./stage.ts";
import {playhead, playing} from "./store.ts";

export interface Preview { readonly name: string; readonly tracks: Tracks; readonly time_s: number }

export const lookedAt = signal<LibraryMotion | null>(null);
const elapsed_s = signal(0);
const waits_ms = 200;
const rest_s = 0.6;  // between two times of a gesture

// Poses are frozen lists: the same list has the same poses.
const numbers = new WeakMap<readonly Frame[], number>();
let nextNumber = 0;
function fingerprintOf(control: PoseControl): string {
  if (!numbers.has(control.base)) numbers.set(control.base, nextNumber++);
  return `${numbers.get(control.base)} ${control.length} ${control.mirrored}`;
}

// By what they are made from. A failed one is not asked for again: the avatar then goes on with its motion.
const known = signal<ReadonlyMap<string, Tracks | null>>(new Map());

function wanted(what: string, frames: () => readonly Frame[]): Tracks | null {
  const relaxed = relaxes.value;
  const key = `${what}${relaxed === false ? " stretched" : ""}`;
  const tracks = known.value.get(key);
  if (tracks !== undefined) return tracks;
  untracked(() => {
    const put = (made: Tracks | null) => { known.value = new Map(known.value).set(key, made); };
    put(null);
    void tracksOf(frames(), relaxed).then(put, () => {});
  });
  return null;
}

export const preview = computed((): Preview | null => {
  const motion = lookedAt.value;
  if (motion && !playing.value) {
    const tracks = wanted(`library ${motion.id}`, () => motion.frames);
    if (tracks) return {name: motion.name, tracks, time_s: elapsed_s.value % (motion.frames.length / fps + rest_s)};
  }
  if (ball.value && pointedTracks.value && !playing.value) return {name: "Pointing at the ball", tracks: pointedTracks.value, time_s: 0};
  if (!inHand.value) return null;
  const {control} = inHand.value;
  if (draftTracks.value) return {name: control?.name ?? "Tried pose", tracks: draftTracks.value, time_s: 0};
  if (!control) return null;
  const tracks = wanted(`control ${fingerprintOf(control)}`, () => posesOf(control));
  return tracks && {name: control.name, tracks, time_s: (Math.floor(playhead.value * fps + 1e-6) - control.start) / fps};
});

// A gesture is shown once it has been looked at for a moment, again and again until it is left. Called once.
export function startPreviews(pointed: {value: LibraryMotion | null}): void {
  effect(() => {
    const motion = pointed.value;
    if (!motion) {
      lookedAt.value = null;
      return;
    }
    let frame = 0;
    const timer = setTimeout(() => {
      lookedAt.value = motion;
      if (calm()) {  // its middle, which does not move
        elapsed_s.value = motion.frames.length / fps / 2;
        return;
      }
      const begin = performance.now();
      frame = requestAnimationFrame(function follow() {
        elapsed_s.value = (performance.now() - begin) / 1000;
        frame = requestAnimationFrame(follow);
      });
    }, waits_ms);
    return () => {
      clearTimeout(timer);
      cancelAnimationFrame(frame);
    };
  });
}
