// The track of pose controls or of style controls: one stop of the Tab key, the arrows go from control to control.
import {useSignal} from "@preact/signals";
import {addGesture} from "../actions/editing.ts";
import {inOrder, controlsOf} from "../model/controls.ts";
import type {Control, TrackName} from "../model/document.ts";
import {secondsOf} from "../model/frames.ts";
import {snapped, snapPoints} from "../model/snapping.ts";
import {seek} from "../playback/player.ts";
import {addingSpeed, library, motionType} from "../state/library.ts";
import {playhead, select, selection, snapping, studioDocument} from "../state/store.ts";
import {ControlBlock} from "./control_block.tsx";
import {frameOfX} from "./scale.ts";

const words: Record<TrackName, {label: string; empty: string}> = {
  pose: {label: "Pose controls", empty: "Pose controls: add a gesture from the library, or keep what the avatar shows (P)"},
  style: {label: "Style controls", empty: "Style controls: add one with a preset, or press S"},
};

const focusOn = (control: Control | undefined) => {
  if (!control) return;
  select(control.id);
  document.getElementById(`control-${control.id}`)?.focus();
};

function go(event: KeyboardEvent, control: Control): void {
  const project = studioDocument.value;
  const here = inOrder(controlsOf(project, control.kind));
  const at = here.findIndex(one => one.id === control.id);
  const other = inOrder(controlsOf(project, control.kind === "pose" ? "style" : "pose"));
  const nearest = () => other.reduce<Control | undefined>((best, one) =>
      !best || Math.abs(one.start - control.start) < Math.abs(best.start - control.start) ? one : best, undefined);
  switch (event.key) {
    case "ArrowLeft": focusOn(here[at - 1]); break;
    case "ArrowRight": focusOn(here[at + 1]); break;
    case "Home": focusOn(here[0]); break;
    case "End": focusOn(here.at(-1)); break;
    case "ArrowUp": if (control.kind === "style") focusOn(nearest()); break;
    case "ArrowDown": if (control.kind === "pose") focusOn(nearest()); break;
    default: return;
  }
  event.preventDefault();
  event.stopPropagation();
}

export function ControlTrack({track}: {track: TrackName}) {
  const controls = inOrder(controlsOf(studioDocument.value, track));
  const stop = controls.find(control => selection.value.has(control.id)) ?? controls[0];
  const press = (event: PointerEvent) => {
    if (event.target !== event.currentTarget || event.button !== 0) return;
    select();
    seek(secondsOf(frameOfX(event.clientX - (event.currentTarget as Element).getBoundingClientRect().left)));
  };
  // A gesture of the library is let go here.
  const over = useSignal(false);
  const carries = (event: DragEvent) => track === "pose" && event.dataTransfer?.types.includes(motionType);
  const drop = (event: DragEvent) => {
    over.value = false;
    const motion = library.value?.find(one => one.id === event.dataTransfer?.getData(motionType));
    if (!motion) return;
    event.preventDefault();
    const x = event.clientX - (event.currentTarget as Element).getBoundingClientRect().left;
    const points = snapPoints(studioDocument.value, new Set(), playhead.value);
    addGesture(motion, addingSpeed.value, snapped(frameOfX(x), points, snapping.value ? frameOfX(7) : 0));
  };
  return <div class={`track ${track}-track${over.value ? " dropping" : ""}${studioDocument.value.bypass[track] ? " bypassed" : ""}`} role="group" aria-label={words[track].label} onPointerDown={press}
      onDragOver={event => {
        if (!carries(event)) return;
        event.preventDefault();
        over.value = true;
      }} onDragLeave={() => { over.value = false; }} onDrop={drop}>
    {controls.length === 0 && <p class="track-hint">{words[track].empty}</p>}
    {controls.map(control => <ControlBlock key={control.id} control={control} tabbable={control === stop} onKey={go} />)}
  </div>;
}
