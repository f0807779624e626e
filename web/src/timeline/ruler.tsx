// Times, the playhead as a slider, and the marked range with its two ends.
import {useRef} from "preact/hooks";
import {fps} from "../model/document.ts";
import {nextBorder} from "../model/snapping.ts";
import {secondsOf} from "../model/frames.ts";
import {seek} from "../playback/player.ts";
import {duration, playhead, studioDocument} from "../state/store.ts";
import {useLiveEffect} from "../ui/live_effect.ts";
import {draggedRange, dragPlayhead, dragRange} from "./dragging.ts";
import {contentWidth, rulerStep, xOfFrame, xOfSeconds} from "./scale.ts";

const contentOf = (event: PointerEvent) => (event.currentTarget as Element).closest(".tracks")!;

function Ticks() {
  const step = rulerStep.value;
  const small = step / 5;
  const count = Math.floor(duration.value / small + 1e-9);
  const digits = step < 1 ? 1 : 0;
  return <svg class="ticks" width={contentWidth.value} height={24} aria-hidden="true">
    {Array.from({length: count + 1}, (_, k) => {
      const x = Math.round(xOfSeconds(k * small)) + 0.5;
      const whole = k % 5 === 0;
      return <g key={k}>
        <line x1={x} x2={x} y1={whole ? 13 : 19} y2={24} />
        {whole && x < contentWidth.value - 20 && <text x={x + 4} y={14}>{(k * small).toFixed(digits)}</text>}
      </g>;
    })}
  </svg>;
}

export function Ruler() {
  const slider = useRef<HTMLDivElement>(null);
  useLiveEffect(() => {
    const at = playhead.value;
    const word = studioDocument.value.speech?.words.find(one => at >= one.start_s && at < one.end_s);
    slider.current?.setAttribute("aria-valuenow", at.toFixed(2));
    slider.current?.setAttribute("aria-valuetext", `${at.toFixed(2)} seconds${word ? `, “${word.word}”` : ""}`);
  });
  const key = (event: KeyboardEvent) => {
    const way = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1}[event.key];
    const frame = playhead.value * fps;
    if (way !== undefined) {
      if (event.ctrlKey || event.metaKey) seek(secondsOf(nextBorder(studioDocument.value, Math.round(frame), way as 1 | -1)));
      else seek(secondsOf(Math.round(frame) + way * (event.shiftKey ? fps : 1)));
    } else if (event.key === "Home") seek(0);
    else if (event.key === "End") seek(duration.value);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return <div class="ruler" ref={slider} role="slider" tabIndex={0} aria-label="Playhead" aria-valuemin={0}
      aria-valuemax={Number(duration.value.toFixed(2))} aria-valuenow={0} onKeyDown={key}
      onPointerDown={event => dragPlayhead(event, contentOf(event))}>
    <Ticks />
  </div>;
}

export function RangeBand() {
  const range = draggedRange.value ?? studioDocument.value.range;
  if (!range) return null;
  return <div class="range" style={{left: `${xOfFrame(range.from)}px`, width: `${xOfFrame(range.to) - xOfFrame(range.from)}px`}}>
    <span class="range-end start" title="Drag the range's start" onPointerDown={event => dragRange(event, contentOf(event), range.to)} />
    <span class="range-end end" title="Drag the range's end" onPointerDown={event => dragRange(event, contentOf(event), range.from)} />
  </div>;
}

export function Cursor() {
  const line = useRef<HTMLDivElement>(null);
  useLiveEffect(() => { line.current?.style.setProperty("transform", `translateX(${xOfSeconds(playhead.value)}px)`); });
  return <div class="cursor" ref={line} aria-hidden="true" />;
}
