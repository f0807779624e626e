// A film of the motion with its sound, as the stage is turned.
import {signal} from "@preact/signals";
import {wordsOf} from "../api/ask.ts";
import {download} from "../actions/files.ts";
import {fileNameOf} from "../model/project.ts";
import {pause, samples} from "../playback/player.ts";
import {say} from "../state/messages.ts";
import {colour} from "../state/screen.ts";
import {studioDocument} from "../state/store.ts";
import {Dialog} from "./dialog.tsx";
import {stageView} from "./stage.tsx";

const open = signal(false);
const size = signal(1);
const done = signal<number | null>(null);  // a share, while it is made
const problem = signal("");
const sizes = [[640, 360], [1280, 720], [1920, 1080]] as const;
let stopping: AbortController | null = null;

export function openFilm(): void {
  pause();
  problem.value = "";
  open.value = true;
}

async function make(stop: AbortSignal): Promise<void> {
  const {motion, speech} = studioDocument.value;
  const [sound, {film, canFilm}, {AvatarView}] = await Promise.all([samples(), import("../view/film.ts"), import("../view/avatar_view.ts")]);
  const [width, height] = sizes[size.value]!;
  if (!motion || !speech || !sound) throw new Error("Generate first: a film is of a motion with its sound.");
  if (!await canFilm(width, height))
    throw new Error("This browser cannot write the film: it lacks WebCodecs with VP9 and Opus. Chromium, Chrome and Edge have them.");
  const canvas = document.createElement("canvas");
  const view = new AvatarView(canvas);
  try {
    await view.load("/avatar.glb");
    view.setSize(width, height, 1);
    view.setColours(colour("--wall"), colour("--ground"));
    if (stageView.value) view.lookAs(stageView.value);
    const bytes = await film({canvas, sound, duration_s: speech.duration_s, stop, draw: time_s => view.show(motion.tracks, time_s, true),
      progress: share => { done.value = share; }});
    if (!bytes) return;
    const name = fileNameOf(studioDocument.value, "webm");
    download(bytes, "video/webm", name);
    open.value = false;
    say(`Film saved as ${name}.`);
  } finally {
    view.dispose();
  }
}

async function begin(): Promise<void> {
  stopping = new AbortController();
  done.value = 0;
  problem.value = "";
  try {
    await make(stopping.signal);
    if (stopping.signal.aborted) problem.value = "The film was cancelled; nothing was saved.";
  } catch (wrong) {
    problem.value = wordsOf(wrong);
  } finally {
    stopping = null;
    done.value = null;
  }
}

function mayClose(): boolean {
  stopping?.abort();
  return stopping === null;
}

export function FilmDialog() {
  const percent = done.value === null ? null : Math.round(100 * done.value);
  return <Dialog open={open} id="film" title="A film of the motion" narrow mayClose={mayClose}>
    <form onSubmit={event => {
      event.preventDefault();
      if (percent === null) void begin();
    }}>
      <p class="note">WebM, 30 frames a second, seen as the stage is turned now, with the speech's sound.</p>
      <fieldset disabled={percent !== null}>
        <legend>Size</legend>
        {sizes.map(([width, height], k) => <label class="check" key={width}><input type="radio" name="size" checked={size.value === k}
            onChange={() => { size.value = k; }} />{width} × {height}</label>)}
      </fieldset>
      {percent !== null && <label class="field"><span>{percent} % done</span><progress max={100} value={percent}>{percent} %</progress></label>}
      <p class="problem-words" role="alert">{problem.value}</p>
      <div class="ends-with"><span class="spring" />
        <button type="button" class="button small" onClick={() => { if (mayClose()) open.value = false; }}>Cancel</button>
        <button type="submit" class="button primary" disabled={percent !== null}>Make the film</button>
      </div>
    </form>
  </Dialog>;
}
