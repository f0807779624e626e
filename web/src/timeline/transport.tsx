// The row above the tracks: playing, times, marking, zoom.
import {useRef} from "preact/hooks";
import {addShown, mark, unmark} from "../actions/editing.ts";
import {dropTried, tryShown} from "../actions/trying.ts";
import {secondsOf} from "../model/frames.ts";
import {seek, toggle} from "../playback/player.ts";
import {trial} from "../state/posing.ts";
import {duration, looping, muted, playhead, playheadFrame, playing, snapping, studioDocument, totalFrames, zoom} from "../state/store.ts";
import {IconButton} from "../ui/icon_button.tsx";
import {useLiveEffect} from "../ui/live_effect.ts";
import {zoomBy, zoomLimit} from "./scale.ts";

// The playhead becomes the range's start or end.
export function markStart(): void {
  const {range} = studioDocument.value;
  mark(playheadFrame.value, range && range.to > playheadFrame.value ? range.to : totalFrames.value);
}
export function markEnd(): void {
  const {range} = studioDocument.value;
  mark(range && range.from <= playheadFrame.value ? range.from : 0, playheadFrame.value + 1);
}

function Clock() {
  const now = useRef<HTMLSpanElement>(null);
  useLiveEffect(() => { if (now.current) now.current.textContent = playhead.value.toFixed(2); });
  return <span class="clock" aria-hidden="true"><span class="now" ref={now} /><span class="of">/ {duration.value.toFixed(2)} s</span></span>;
}

export function Transport() {
  const none = duration.value === 0;
  const {motion, range} = studioDocument.value;
  return <div class="transport" role="toolbar" aria-label="Playing and marking">
    <IconButton icon="toStart" name="To the start" keys="Home" disabled={none} onClick={() => seek(0)} />
    <button type="button" class="button play" aria-label={playing.value ? "Pause" : "Play"} title={playing.value ? "Pause (Space)" : "Play (Space)"}
        disabled={none} onClick={toggle}>
      <svg class="icon solid" viewBox="0 0 20 20" aria-hidden="true">
        {playing.value ? <path d="M5.5 4.5h3v11h-3zM11.5 4.5h3v11h-3z" /> : <path d="M6.5 3.8v12.4L16 10z" />}
      </svg>
    </button>
    <IconButton icon="loop" name="Repeat" keys="L" pressed={looping.value} disabled={none} onClick={() => { looping.value = !looping.value; }} />
    <IconButton icon={muted.value ? "silent" : "sound"} name={muted.value ? "Sound on" : "Mute"} keys="M" disabled={none}
        onClick={() => { muted.value = !muted.value; }} />
    <Clock />
    <span class="divider" />
    <IconButton icon="range" name="Mark from the playhead on" keys="I" disabled={none} onClick={markStart}>Mark in</IconButton>
    <IconButton icon="range" name="Mark up to the playhead" keys="O" disabled={none} onClick={markEnd}>Mark out</IconButton>
    {range && <>
      <span class="range-words">{secondsOf(range.from).toFixed(2)}–{secondsOf(range.to).toFixed(2)} s</span>
      <IconButton icon="close" name="Clear the marked range" keys="Esc" onClick={unmark} />
    </>}
    <span class="divider" />
    <IconButton icon="pin" name={range ? "Keep the marked range's motion as a pose control" : "Keep the pose at the playhead as a pose control"} keys="P"
        disabled={!motion} onClick={addShown}>{range ? "Keep range" : "Keep pose"}</IconButton>
    <IconButton icon="hand" name="Try a pose without keeping it yet" keys="T" pressed={trial.value !== null} disabled={!motion}
        onClick={() => { if (trial.value) dropTried(); else tryShown(); }}>Try a pose</IconButton>
    <span class="spring" />
    <IconButton icon="magnet" name="Snap to words, accents and ends" keys="N" pressed={snapping.value} onClick={() => { snapping.value = !snapping.value; }} />
    <IconButton icon="minus" name="Zoom out" keys="-" disabled={none || zoom.value <= 1} onClick={() => zoomBy(1 / 1.5)} />
    <IconButton icon="plus" name="Zoom in" keys="+" disabled={none || zoom.value >= zoomLimit.value} onClick={() => zoomBy(1.5)} />
  </div>;
}
