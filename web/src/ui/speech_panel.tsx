// What is said, and the button that makes gestures for it.
import {computed} from "@preact/signals";
import {useRef} from "preact/hooks";
import {chooseRecording, dropRecording} from "../actions/files.ts";
import {generateGestures, sameSpeech} from "../actions/generate.ts";
import {isCurrent} from "../model/project.ts";
import {offers} from "../state/mode.ts";
import {isManual, served} from "../state/server.ts";
import type {Voice} from "../api/client.ts";
import {busy, edit, settle, studioDocument} from "../state/store.ts";
import {IconButton} from "./icon_button.tsx";
import {Icon} from "./icons.tsx";
import {OptionsButton} from "./options_dialog.tsx";

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
  if (isManual.value && studioDocument.value.poseControls.length === 0 && motion) return "No poses yet: add some.";
  if (text.trim() === "") return "Type a sentence or take an example.";
  if (!motion) return "Ready to generate.";
  if (!sameSpeech(studioDocument.value)) return "New text: generate again.";
  return isCurrent(studioDocument.value) ? "Gestures are up to date." : "Changed: generate again.";
});

const isEnglish = (language: string | null) => language === null || language.startsWith("en");

// Whether the voice speaks a language whose words are not understood.
const foreign = computed(() => {
  const {voice, recording} = studioDocument.value;
  const voices = served.value?.voices ?? [];
  return !recording && !isEnglish((voices.find(one => one.name === voice) ?? voices[0])?.language ?? null);
});

const languages = new Intl.DisplayNames("en", {type: "language", fallback: "code"});
const wordsFor = (language: string) => {
  try {
    return languages.of(language) ?? language;
  } catch {
    return language;
  }
};

// English voices by their names, as the server has them; others by their languages.
function byLanguage(voices: readonly Voice[]): {name: string; words: string}[] {
  const named = voices.map(({name, language}) => ({name, isEnglish: isEnglish(language), words: isEnglish(language) ? name : wordsFor(language!)}));
  return [...named.filter(one => one.isEnglish), ...named.filter(one => !one.isEnglish).sort((a, b) => a.words.localeCompare(b.words))];
}

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
      {offers("speech") && <span class="panel-tools">
        {recording && <span class="recording" title={recording.name}><span>{recording.name}</span>
          <IconButton icon="close" name="Leave the recording out: a voice speaks" onClick={dropRecording} /></span>}
        {!recording && voices.length > 1 && <select class="quiet" aria-label="Voice" title="Voice" value={voice ?? voices[0]!.name} onChange={event => {
          const chosen = event.currentTarget.value;
          edit("Change the voice", draft => { draft.voice = chosen === voices[0]!.name ? null : chosen; });
        }}>{byLanguage(voices).map(({name, words}) => <option key={name} value={name}>{words}</option>)}</select>}
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
      </span>}
    </div>
    <textarea id="text" aria-label="What is said" rows={3} maxLength={20000} spellcheck placeholder="What does the avatar say?" value={text} readOnly={!offers("speech")}
        onInput={event => setText(event.currentTarget.value)} onBlur={settle} />
    {foreign.value && !isManual.value && <p class="note">Not English: gestures follow this voice's sound alone, not its words.</p>}
    <div class="generate">
      <button type="button" class={stale || !studioDocument.value.motion ? "button primary calling" : "button primary"} aria-busy={busy.value !== null}
          title="Generate (Ctrl+Enter)" disabled={text.trim() === ""} onClick={() => void generateGestures("all")}>
        <Icon name="spark" /><span>Generate</span>
      </button>
      {!isManual.value && <button type="button" class="button" title="Generate only the marked range again (Ctrl+Shift+Enter)" disabled={!partly.value}
          onClick={() => void generateGestures("range")}>Range only</button>}
      {offers("sketch") && <label class="version" title="Another version makes other gestures for the same speech"><span>Version</span>
        <input type="number" min={0} max={4294967295} step={1} value={seed} onInput={event => setSeed(event.currentTarget.valueAsNumber)} onBlur={settle} />
      </label>}
    </div>
    <div class="state-line"><p class="state">{state.value}</p><OptionsButton /></div>
  </section>;
}
