// What is heard: the sound's picture with its accents, and the words.
import {computed, useSignalEffect} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {fps, type Speech} from "../model/document.ts";
import {secondsOf} from "../model/frames.ts";
import {mark} from "../actions/editing.ts";
import {samples, seek} from "../playback/player.ts";
import {playhead, studioDocument} from "../state/store.ts";
import {colour, scheme} from "../state/screen.ts";
import {dragRange} from "./dragging.ts";
import {frameOfX, xOfSeconds} from "./scale.ts";
import {makeWaveform, type Waveform} from "./waveform.ts";

const soundHeight = 48;

const press = (event: PointerEvent) => dragRange(event, (event.currentTarget as Element).closest(".tracks")!);

export function SoundRow() {
  const place = useRef<HTMLDivElement>(null);
  const waveform = useRef<Waveform | null>(null);
  useEffect(() => {
    waveform.current = makeWaveform(place.current!, soundHeight, colour("--wave"));
    return () => waveform.current?.destroy();
  }, []);
  useSignalEffect(() => {
    void studioDocument.value.speech?.wav;
    void samples().then(sound => waveform.current?.show(sound));
  });
  useSignalEffect(() => {
    void scheme.value;
    waveform.current?.setColour(colour("--wave"));
  });
  const {speech} = studioDocument.value;
  const accents = speech?.accents ?? [];
  const words = speech?.words ?? [];
  return <div class="track sound-track" role="img" onPointerDown={press}
      aria-label={`Sound and pitch with ${accents.length} accents${accents.length ? `: ${accents.map(one => words[one.word]?.word).join(", ")}` : ""}`}>
    <div class="waveform" ref={place} />
    {speech && <Pitch {...speech} />}
    {accents.map((accent, k) => <span key={k} class="accent" title={`Accent on “${words[accent.word]?.word}”`}
        style={{left: `${xOfSeconds(accent.start_s)}px`, width: `${Math.max(3, xOfSeconds(accent.end_s - accent.start_s))}px`,
          "--strength": String(0.35 + 0.65 * accent.strength)}} />)}
  </div>;
}

// From the voice's lowest to its highest, an octave at least, evenly by octaves; voiceless stretches are gaps.
function Pitch({pitch, pitch_fps, duration_s}: Pick<Speech, "pitch" | "pitch_fps" | "duration_s">) {
  const voiced = pitch.filter(hz => hz > 0);
  const lowest_hz = voiced.reduce((low, hz) => Math.min(low, hz), Infinity);
  const highest_hz = Math.max(2 * lowest_hz, voiced.reduce((high, hz) => Math.max(high, hz), 0));
  let drawing = false;
  const path = pitch.map((hz, k) => {
    const was = drawing;
    drawing = hz > 0;
    if (!drawing) return "";
    const height = Math.min(1, Math.max(0, Math.log(hz / lowest_hz) / Math.log(highest_hz / lowest_hz)));
    return `${was ? "L" : "M"}${(k / pitch_fps).toFixed(3)} ${(1 - height).toFixed(3)}`;
  }).join("");
  return <svg class="pitch" viewBox={`0 0 ${duration_s} 1`} preserveAspectRatio="none" aria-hidden="true"><path d={path} /></svg>;
}

// The word at the playhead, and else the one behind it: they change less often than the playhead.
const next = computed(() => {
  const words = studioDocument.value.speech?.words ?? [];
  const at = words.findIndex(word => playhead.value < word.end_s);
  return at < 0 ? words.length - 1 : at;
});
const spokenNow = computed(() => {
  const word = studioDocument.value.speech?.words[next.value];
  return word && playhead.value >= word.start_s && playhead.value < word.end_s ? next.value : -1;
});

// One stop of the Tab key; arrows go from word to word, Enter plays from there, Shift+Enter marks (on to there).
export function WordsRow() {
  const words = studioDocument.value.speech?.words ?? [];
  const stop = next.value;
  const key = (event: KeyboardEvent, k: number) => {
    const other = {ArrowLeft: k - 1, ArrowRight: k + 1, Home: 0, End: words.length - 1}[event.key];
    if (other !== undefined) {
      const word = words[Math.min(Math.max(0, other), words.length - 1)]!;
      seek(word.start_s + 1e-3);
      document.getElementById(`word-${words.indexOf(word)}`)?.focus();
    } else if (event.key === "Enter") {
      const word = words[k]!;
      const {range} = studioDocument.value;
      const [from, to] = [Math.floor(word.start_s * fps), Math.ceil(word.end_s * fps)];
      if (event.shiftKey) mark(range ? Math.min(range.from, from) : from, range ? Math.max(range.to, to) : to);
      else seek(word.start_s + 1e-3);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  };
  const markAt = (event: MouseEvent) => {
    const time_s = secondsOf(frameOfX(event.clientX - (event.currentTarget as Element).getBoundingClientRect().left));
    const word = words.find(one => time_s >= one.start_s && time_s < one.end_s);
    if (word) mark(Math.floor(word.start_s * fps), Math.ceil(word.end_s * fps));
  };
  return <div class="track words-track" role="group" aria-label="Words" onPointerDown={press} onDblClick={markAt}>
    {words.map((word, k) => <button type="button" key={k} id={`word-${k}`} tabIndex={k === stop ? 0 : -1}
        class={k === spokenNow.value ? "word current" : "word"}
        style={{left: `${xOfSeconds(word.start_s)}px`, width: `${Math.max(4, xOfSeconds(word.end_s - word.start_s) - 1)}px`}}
        title={`${word.word}, ${word.start_s.toFixed(2)} to ${word.end_s.toFixed(2)} s`}
        onKeyDown={event => key(event, k)}>{word.word}</button>)}
  </div>;
}
