// What is said, and the button that makes gestures for it.
import {computed, signal} from "@preact/signals";
import {useRef} from "preact/hooks";
import {chooseRecording, dropRecording} from "../actions/files.ts";
import {health, type Health} from "../api/client.ts";
import {generateGestures, sameSpeech} from "../actions/generate.ts";
import {isCurrent} from "../model/project.ts";
import {complain} from "../state/messages.ts";
import {busy, edit, settle, studioDocument} from "../state/store.ts";
import {IconButton} from "./icon_button.tsx";
import {Icon} from "./icons.tsx";

const served = signal<Health | null>(null);

export async function askHealth(): Promise<void> {
  try {
    served.value = await health();
  } catch (problem) {
    complain(problem instanceof Error ? problem.message : String(problem));
  }
}

const examples = [
  "Welcome, everybody. Over here on the left you find the entrance, and the big hall is right behind me.",
  "First we look at the small picture, and then we step back and see the whole thing.",
  "I really did not expect that. It was huge, much bigger than this room!",
  "On the one hand it is cheap and quick. On the other hand nobody knows how long it will last.",
];

const partly = computed(() => {
  const {motion, range} = studioDocument.value;
  return motion !== null && range !== null && sameSpeech(studioDocument.value);
});

const state = computed(() => {
  if (busy.value !== null) return `${busy.value} …`;
  const {motion, text} = studioDocument.value;
  if (text.trim() === "") return "Type a sentence or take an example.";
  if (!motion) return "Ready to generate.";
  if (!sameSpeech(studioDocument.value)) return "The text has changed since the gestures were generated.";
  return isCurrent(studioDocument.value) ? "The gestures are up to date." : "Controls have changed: generate again.";
});

const setText = (text: string) => edit("Change the text", draft => { draft.text = text; }, "text");
const setSeed = (seed: number) => {
  if (Number.isInteger(seed) && seed >= 0 && seed <= 4294967295) edit("Change the version", draft => { draft.seed = seed; }, "seed");
};

export function SpeechPanel() {
  const file = useRef<HTMLInputElement>(null);
  const {text, voice, seed, recording} = studioDocument.value;
  const voices = served.value?.voices ?? [];
  const stale = studioDocument.value.motion !== null && !isCurrent(studioDocument.value);
  return <section class="panel speech-panel" aria-labelledby="speech-title">
    <div class="panel-head">
      <h2 id="speech-title">Speech</h2>
      <span class="panel-tools">
        {recording && <span class="recording" title={recording.name}><span>{recording.name}</span>
          <IconButton icon="close" name="Leave the recording out: a voice speaks" onClick={dropRecording} /></span>}
        {!recording && voices.length > 1 && <select class="quiet" aria-label="Voice" title="Voice" value={voice ?? voices[0]} onChange={event => {
          const chosen = event.currentTarget.value;
          edit("Change the voice", draft => { draft.voice = chosen === voices[0] ? null : chosen; });
        }}>{voices.map(one => <option key={one}>{one}</option>)}</select>}
        <select class="quiet" aria-label="Take an example" value="" onChange={event => {
          const chosen = examples[Number(event.currentTarget.value)];
          event.currentTarget.value = "";
          if (!chosen) return;
          settle();
          setText(chosen);
          settle();
        }}>
          <option value="" disabled>Examples</option>
          {examples.map((one, k) => <option key={k} value={k}>{one}</option>)}
        </select>
        <IconButton icon="microphone" name="Take a recorded speech (WAV)" onClick={() => file.current?.click()} />
        <input ref={file} id="recording-file" type="file" accept=".wav,audio/wav" hidden aria-label="Recorded speech" onChange={() => {
          const chosen = file.current?.files?.[0];
          if (chosen) void chooseRecording(chosen);
          if (file.current) file.current.value = "";
        }} />
      </span>
    </div>
    <textarea id="text" aria-label="What is said" rows={3} maxLength={20000} spellcheck placeholder="What does the avatar say?" value={text}
        onInput={event => setText(event.currentTarget.value)} onBlur={settle} />
    <div class="generate">
      <button type="button" class={stale || !studioDocument.value.motion ? "button primary calling" : "button primary"} aria-busy={busy.value !== null}
          title="Generate (Ctrl+Enter)" disabled={text.trim() === ""} onClick={() => void generateGestures("all")}>
        <Icon name="spark" /><span>Generate</span>
      </button>
      <button type="button" class="button" title="Generate only the marked range again (Ctrl+Shift+Enter)" disabled={!partly.value}
          onClick={() => void generateGestures("range")}>Range only</button>
      <label class="version" title="Another version makes other gestures for the same speech"><span>Version</span>
        <input type="number" min={0} max={4294967295} step={1} value={seed} onInput={event => setSeed(event.currentTarget.valueAsNumber)} onBlur={settle} />
      </label>
    </div>
    <p class="state">{state.value}</p>
  </section>;
}
