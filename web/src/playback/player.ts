// Plays the speech. The sound's clock is the only clock: everything that moves asks where the sound is.
import {effect, untracked} from "@preact/signals";
import {secondsOf} from "../model/frames.ts";
import {complain} from "../state/messages.ts";
import {duration, looping, muted, playhead, playing, studioDocument} from "../state/store.ts";
import {bytesOf} from "./base64.ts";

let context: AudioContext | null = null;
let gain: GainNode | null = null;
let sound: AudioBuffer | null = null;
let decoding: Promise<void> = Promise.resolve();
let source: AudioBufferSourceNode | null = null;
let startedAt = 0;  // the context's time at which the sound's start would have been heard
let span = {from: 0, to: 0};

// What is being heard now, in seconds of the sound; before the first sample is out, where it will begin.
export function heardAt(): number {
  if (!context || !source) return playhead.value;
  const at = context.currentTime - (context.outputLatency || 0) - startedAt;
  if (!looping.value) return Math.max(span.from, at);
  const length = span.to - span.from;
  return at < span.to ? Math.max(span.from, at) : span.from + (at - span.from) % length;
}

// The samples of the first channel, for those who draw it; null where there is no speech.
export async function samples(): Promise<AudioBuffer | null> {
  await decoding;
  return sound;
}

async function decode(wav: string): Promise<void> {
  try {
    const decoded = await new OfflineAudioContext(1, 1, 48000).decodeAudioData(bytesOf(wav).buffer as ArrayBuffer);
    if (studioDocument.value.speech?.wav === wav) sound = decoded;
  } catch {
    complain("The speech's sound cannot be played: it is not a WAV file that the browser reads.");
  }
}

function stopSource(): void {
  if (!source) return;
  source.onended = null;
  source.stop();
  source.disconnect();
  source = null;
}

// What is played: the marked range where the playhead stands in it, else all.
function spanToPlay(): {from: number; to: number} {
  const {range} = studioDocument.value;
  const end = duration.value;
  if (range && looping.value) return {from: secondsOf(range.from), to: Math.min(secondsOf(range.to), end)};
  return {from: 0, to: end};
}

// The sound device starts while something else is waited for. At a person's press only: browsers ask for one.
export function warmUp(): AudioContext {
  context ??= new AudioContext({latencyHint: "interactive"});
  if (!gain) {
    gain = context.createGain();
    gain.connect(context.destination);
  }
  void context.resume().catch(() => {});  // play() says so
  return context;
}

export async function play(): Promise<void> {
  await decoding;
  if (!sound) return;
  stopSource();
  const context = warmUp();
  const running = context.resume().then(() => true, () => false);
  if (!await Promise.race([running, new Promise<boolean>(resolve => setTimeout(() => resolve(context.state === "running"), 2000))])) {
    complain("The browser does not play sound. Is an audio device connected, and may this page play?");
    return;
  }
  span = spanToPlay();
  const from = playhead.value >= span.to - 0.02 || playhead.value < span.from ? span.from : playhead.value;
  source = context.createBufferSource();
  source.buffer = sound;
  source.loop = looping.value;
  source.loopStart = span.from;
  source.loopEnd = span.to;
  gain!.gain.value = muted.value ? 0 : 1;
  source.connect(gain!);
  const one = source;
  source.onended = () => {
    if (source !== one) return;
    source = null;
    playing.value = false;
    playhead.value = span.to;
  };
  const begin = context.currentTime + 0.03;
  startedAt = begin - from;
  if (looping.value) source.start(begin, from);
  else source.start(begin, from, span.to - from);
  if (!looping.value) span = {from, to: span.to};
  playhead.value = from;
  playing.value = true;
}

export function pause(): void {
  if (!playing.value) return;
  const at = heardAt();
  stopSource();
  playing.value = false;
  playhead.value = Math.min(at, duration.value);
}

export const toggle = (): void => { if (playing.value) pause(); else void play(); };

// Where the playhead is put; playing goes on from there.
export function seek(time_s: number): void {
  const at = Math.min(Math.max(0, time_s), duration.value);
  const was = playing.value;
  if (was) {
    stopSource();
    playing.value = false;
  }
  playhead.value = at;
  if (was) void play();
}

// Follows the document's sound and the switches. Called once.
export function startPlayer(): void {
  let known: string | null = null;
  effect(() => {
    const wav = studioDocument.value.speech?.wav ?? null;
    if (wav === known) return;
    known = wav;
    untracked(() => {
      stopSource();
      playing.value = false;
      sound = null;
      decoding = wav ? decode(wav) : Promise.resolve();
    });
  });
  effect(() => { if (gain) gain.gain.value = muted.value ? 0 : 1; else void muted.value; });
  let loop = looping.value;
  effect(() => {
    if (looping.value === loop) return;
    loop = looping.value;
    untracked(() => { if (playing.value) seek(heardAt()); });
  });
  // While it plays, the playhead follows what is heard, once a frame of the screen.
  effect(() => {
    if (!playing.value) return;
    let frame = requestAnimationFrame(function follow() {
      playhead.value = Math.min(heardAt(), duration.value);
      frame = requestAnimationFrame(follow);
    });
    return () => cancelAnimationFrame(frame);
  });
}
