// The timeline: ruler, sound, words, pose controls and style controls under one another, in one scale.
import {useSignalEffect} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {controlsOf} from "../model/controls.ts";
import type {TrackName} from "../model/document.ts";
import {isManual} from "../state/server.ts";
import {duration, edit, playhead, playing, studioDocument, zoom} from "../state/store.ts";
import {ControlTrack} from "./control_track.tsx";
import {Cursor, RangeBand, Ruler} from "./ruler.tsx";
import {contentWidth, viewport, xOfSeconds, zoomBy} from "./scale.ts";
import {SoundRow, WordsRow} from "./speech_rows.tsx";
import {IconButton} from "../ui/icon_button.tsx";
import {Transport} from "./transport.tsx";

// Controls of a track are left out for once, to compare.
function Bypass({track, name}: {track: TrackName; name: string}) {
  const off = studioDocument.value.bypass[track];
  const count = controlsOf(studioDocument.value, track).length;
  return <span class="lane-name"><span aria-hidden="true">{name}</span>
    {count > 0 && <IconButton icon={off ? "noEye" : "eye"} name={`Generate without ${track} controls, to compare`} pressed={off}
        onClick={() => edit(off ? `Use ${track} controls` : `Bypass ${track} controls`, draft => { draft.bypass[track] = !off; })} />}
  </span>;
}

const readable_px = 64;  // a second

function Tracks() {
  const scroller = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const place = scroller.current!;
    const watch = new ResizeObserver(() => { viewport.value = Math.max(100, place.clientWidth); });
    watch.observe(place);
    // Ctrl and the wheel zoom about the pointer.
    const wheel = (event: WheelEvent) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      const before = zoom.value;
      const at = event.clientX - place.getBoundingClientRect().left;
      zoomBy(event.deltaY < 0 ? 1.2 : 1 / 1.2);
      const factor = zoom.value / before;
      requestAnimationFrame(() => { place.scrollLeft = (place.scrollLeft + at) * factor - at; });
    };
    place.addEventListener("wheel", wheel, {passive: false});
    return () => {
      watch.disconnect();
      place.removeEventListener("wheel", wheel);
    };
  }, []);
  // A long speech begins as large as its words can be read.
  useSignalEffect(() => { zoom.value = Math.max(1, readable_px * duration.value / viewport.peek()); });
  // The playhead stays in sight.
  useSignalEffect(() => {
    const place = scroller.current;
    const x = xOfSeconds(playhead.value);
    if (!place || zoom.value === 1) return;
    if (x < place.scrollLeft || x > place.scrollLeft + place.clientWidth - 24)
      place.scrollLeft = playing.value ? x - 24 : x - place.clientWidth / 2;
  });
  return <div class="scroller" ref={scroller}>
    <div class="tracks" style={{width: `${contentWidth.value}px`}}>
      <Ruler />
      <SoundRow />
      <WordsRow />
      <ControlTrack track="pose" />
      {!isManual.value && <ControlTrack track="style" />}
      <RangeBand />
      <Cursor />
    </div>
  </div>;
}

export function Timeline() {
  const none = studioDocument.value.speech === null;
  return <section class="timeline" aria-label="Timeline">
    <Transport />
    {none ? <p class="timeline-empty">The speech, its words and your controls appear here once you press Generate.</p> :
      <div class={isManual.value ? "lanes manual" : "lanes"}>
        <div class="lane-names">
          {["", "Sound", "Words"].map(name => <span class="lane-name" key={name} aria-hidden="true">{name}</span>)}
          <Bypass track="pose" name="Poses" />{!isManual.value && <Bypass track="style" name="Style" />}
        </div>
        <Tracks />
      </div>}
  </section>;
}
