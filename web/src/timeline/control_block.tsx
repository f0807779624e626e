// One control on its track: a button that is dragged, stretched at its ends, and worked by keyboard.
import {nameOf, posesOf, spanWords, styleWords} from "../model/controls.ts";
import {styleLimit, styleNames, type Control, type StyleControl} from "../model/document.ts";
import {isCurve} from "../model/curves.ts";
import {nextBorder} from "../model/snapping.ts";
import {move, show, stretch} from "../actions/editing.ts";
import {select, selection, studioDocument} from "../state/store.ts";
import {curveLine} from "../ui/curve_editor.tsx";
import {Figure} from "../ui/figure.tsx";
import {dragControl, dragged} from "./dragging.ts";
import {xOfFrame} from "./scale.ts";

const figureWidth = 34;

function StyleBars({control}: {control: StyleControl}) {
  return <span class="style-bars" aria-hidden="true">
    {styleNames.map(name => {
      const value = control[name];
      return <span class={value === null ? "bar free" : "bar"} key={name}>
        <span class="bar-name">{name === "handedness" ? "hand" : name}</span>
        {isCurve(value) ? <svg class="bar-curve" viewBox="0 0 100 100" preserveAspectRatio="none"><polyline points={curveLine(value)} /></svg> :
          <span class="bar-value">{value === null ? "–" : (value > 0 ? "+" : "") + value.toFixed(1)}</span>}
        {typeof value === "number" && <span class="bar-fill" style={{width: `${50 * Math.abs(value) / styleLimit}%`,
          left: value < 0 ? `${50 - 50 * Math.abs(value) / styleLimit}%` : "50%"}} />}
      </span>;
    })}
  </span>;
}

function PoseStrip({control, width}: {control: Control & {kind: "pose"}; width: number}) {
  const count = Math.min(control.length, Math.max(1, Math.floor((width - 12) / figureWidth)), 8);
  const poses = posesOf(control);
  const chosen = Array.from({length: count}, (_, k) => poses[Math.round((k + 0.5) / count * poses.length - 0.5)]!);
  return <span class="pose-strip" aria-hidden="true">{chosen.map((frame, k) => <Figure key={k} frame={frame} />)}</span>;
}

export function ControlBlock({control, tabbable, onKey}: {control: Control; tabbable: boolean;
    onKey: (event: KeyboardEvent, control: Control) => void}) {
  const span = dragged.value.get(control.id) ?? control;
  const shown = {...control, ...span} as Control;
  const isSelected = selection.value.has(control.id);
  const width = xOfFrame(span.start + span.length) - xOfFrame(span.start);
  const press = (event: PointerEvent) => {
    const content = (event.currentTarget as Element).closest(".tracks")!;
    const {left, right} = (event.currentTarget as Element).getBoundingClientRect();
    const edge = Math.min(8, (right - left) / 4);
    dragControl(event, content, control, event.clientX < left + edge ? "start" : event.clientX > right - edge ? "end" : "middle");
  };
  const key = (event: KeyboardEvent) => {
    const way = event.key === "ArrowLeft" ? -1 : event.key === "ArrowRight" ? 1 : 0;
    const command = event.ctrlKey || event.metaKey;
    if (way !== 0 && (command || event.shiftKey)) {
      if (!selection.value.has(control.id)) select(control.id);
      if (command && event.shiftKey) move(nextBorder(studioDocument.value, control.start, way as 1 | -1) - control.start);
      else if (command) move(way);
      else stretch(control.id, "end", control.start + control.length + way);
    } else if (event.key === "Enter" || event.key === " " && event.shiftKey) {
      if (event.shiftKey) select(...selection.value, control.id);
      else {
        select(control.id);
        show(control);
      }
    } else {
      onKey(event, control);
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  };
  return <button type="button" id={`control-${control.id}`} class={`control ${control.kind}${isSelected ? " selected" : ""}${dragged.value.has(control.id) ? " dragging" : ""}`}
      style={{left: `${xOfFrame(span.start)}px`, width: `${Math.max(6, width - 2)}px`}} tabIndex={tabbable ? 0 : -1} aria-pressed={isSelected}
      title={`${nameOf(control)}, ${spanWords(shown)}`} onPointerDown={press} onKeyDown={key}>
    <span class="hidden">{nameOf(control)}, {spanWords(shown)}{control.kind === "style" ? `: ${styleWords(control)}` : control.mirrored ? ", flipped" : ""}</span>
    {shown.kind === "pose" ? <>
      <PoseStrip control={shown} width={width} />
      <span class="control-name" aria-hidden="true">{shown.name}</span>
    </> : <StyleBars control={shown} />}
    <span class="grip start" aria-hidden="true" /><span class="grip end" aria-hidden="true" />
  </button>;
}
