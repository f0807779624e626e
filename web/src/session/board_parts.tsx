// Texts, buttons, sliders and fields of a board, at their places.
import type {CSSProperties} from "preact";
import type {Board, BoardButton, BoardField, BoardSlider, BoardText, Box} from "../api/session.ts";
import {present} from "./state.ts";
import {pressButton, pressed, set, setHere} from "./answering.ts";
import {describedBy} from "./board_layout.ts";

// How a board's metres become the page's pixels.
export interface Drawn { readonly board: Board; readonly px: number; readonly head: string | null; readonly mayPress: (event: MouseEvent) => boolean }

const letter = 1 / 1.36;  // of a line's height, in the fonts that boards are laid out for
const button_m = 0.05;
const caption_m = 0.036;
const fieldLine_m = 0.046;
const mostLetters = 500;  // that the server takes
const thumb_m = 0.06;
const underTrack_m = 0.028;  // the thumb's

const placeOf = ([x, y, width, height]: Box, {board, px}: Drawn): CSSProperties => ({left: `${px * x}px`, top: `${px * (board.height_m - y - height)}px`,
  width: `${px * width}px`, height: `${px * height}px`});
const lines = (size_m: number, {px}: Drawn): CSSProperties => ({fontSize: `${px * size_m * letter}px`, lineHeight: `${px * size_m}px`});

export function Text({id, text, drawn}: {id: string; text: BoardText; drawn: Drawn}) {
  const {bold, centred, faint, level} = text;
  const kinds = ["board-text", bold && "bold", centred && "centred", faint && "faint", level && "level"].filter(Boolean).join(" ");
  const shared = {id, class: kinds, style: placeOf(text.box, drawn)};
  const words = <span data-fit={`${text.size_m} ${bold}`} style={lines(text.size_m, drawn)}>{text.text}</span>;
  return id === drawn.head ? <h1 {...shared} tabIndex={-1}>{words}</h1> : <p {...shared}>{words}</p>;
}

// One stop of the Tab key among options; the arrows go on from there.
function goAmong(event: KeyboardEvent): void {
  const way = {ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1}[event.key];
  const at = event.currentTarget as HTMLElement;
  const all = [...at.closest("[role=group]")?.querySelectorAll<HTMLElement>("button:not(:disabled)") ?? []];
  const to = way === undefined ? {Home: all[0], End: all.at(-1)}[event.key] : all[(all.indexOf(at) + way + all.length) % all.length];
  if (!to) return;
  event.preventDefault();
  to.focus();
}

export function Button({id, button, stop, drawn}: {id: string; button: BoardButton; stop: boolean; drawn: Drawn}) {
  const {label, caption, chosen, role, enabled, box} = button;
  const isOption = role === "option";
  const size_m = Math.min((caption ? 0.42 : 0.5) * box[3], button_m);
  return <button type="button" id={id} class={`board-button ${role}${chosen ? " chosen" : ""}`} style={placeOf(box, drawn)}
      disabled={!enabled || present.value?.over} tabIndex={stop ? 0 : -1} aria-pressed={isOption ? chosen : undefined} aria-busy={pressed.value.has(button.id)}
      aria-describedby={describedBy(drawn.board, button).join(" ") || undefined} onKeyDown={isOption ? goAmong : undefined}
      onClick={event => { if (drawn.mayPress(event)) pressButton(button.id); }}>
    <span data-fit={isOption ? "option" : "button"} style={lines(size_m, drawn)}>{label}</span>
    {caption && <span class="caption" data-fit="caption" style={lines(caption_m, drawn)}>{caption}</span>}
  </button>;
}

export function Slider({id, slider, labelledBy, drawn}: {id: string; slider: BoardSlider; labelledBy: string | null; drawn: Drawn}) {
  const {low, high, enabled, labels, track, box} = slider;
  const value = (setHere(slider.id) as number | undefined) ?? slider.value;
  const middle = Math.round((low + high) / 2);
  const touch = (event: Event) => set(slider.id, (event.currentTarget as HTMLInputElement).valueAsNumber);
  const pitch = track[2] / Math.max(1, labels.length - 1);
  return <>
    <input type="range" id={id} class={value === null ? "board-slider untouched" : "board-slider"} style={placeOf([track[0], track[1] + (track[3] - thumb_m) / 2, track[2], thumb_m], drawn)}
        min={low} max={high} step={1} value={value ?? middle} disabled={!enabled || present.value?.over} aria-labelledby={labelledBy ?? undefined}
        aria-label={labelledBy === null ? "Answer" : undefined} aria-describedby={labels.length > 0 ? `${id}-labels` : undefined}
        aria-valuetext={value === null ? "no answer yet" : String(value)} onInput={touch} onClick={event => {
          if (value === null) touch(event);  // where the middle is pressed, nothing has moved
        }} onKeyDown={event => { if (value === null && (event.key === "Enter" || event.key === " ")) touch(event); }} />
    {labels.length > 0 && <div id={`${id}-labels`}>{labels.map((words, k) => {
      const tick = track[0] + k * pitch;
      const left = k === 0 ? tick : tick - 0.48 * pitch;
      const right = k === labels.length - 1 ? tick : tick + 0.48 * pitch;
      return <p class={`board-text${k === 0 ? "" : k === labels.length - 1 ? " at-end" : " centred"}`} key={k}
          style={placeOf([left, box[1], right - left, track[1] - underTrack_m - box[1]], drawn)}>
        <span data-fit="label" style={lines(slider.label_size_m, drawn)}>{words}</span></p>;
    })}</div>}
  </>;
}

export function Field({id, field, labelledBy, drawn}: {id: string; field: BoardField; labelledBy: string | null; drawn: Drawn}) {
  const text = (setHere(field.id) as string | undefined) ?? field.text;
  return <input type="text" id={id} class="board-field" style={{...placeOf(field.box, drawn), ...lines(Math.min(0.6 * field.box[3], fieldLine_m), drawn)}} value={text} placeholder={field.hint}
      autocomplete="off" maxLength={mostLetters} disabled={!field.enabled || present.value?.over} aria-labelledby={labelledBy ?? undefined}
      aria-label={labelledBy === null ? field.hint || "Answer" : undefined} onInput={event => set(field.id, event.currentTarget.value)} />;
}
