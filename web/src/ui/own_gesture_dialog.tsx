// Adds a gesture of one's own to the library: the marked range, the shown pose, or a part of a clip that a file has.
import {useSignal} from "@preact/signals";
import {useRef} from "preact/hooks";
import {signal} from "@preact/signals";
import {wordsOf} from "../api/ask.ts";
import {addOwn, clipIn} from "../actions/own_gestures.ts";
import {mostFrames, type Clip} from "../model/clip_file.ts";
import {fps, type Frame} from "../model/document.ts";
import {secondsOf} from "../model/frames.ts";
import {ownOnly} from "../state/library.ts";
import {readsClips} from "../state/server.ts";
import {playheadFrame, studioDocument} from "../state/store.ts";
import {Dialog} from "./dialog.tsx";
import {Figure} from "./figure.tsx";
import {Seconds} from "./seconds.tsx";

export const addingOwn = signal(false);

const clipFiles = ".json,.bvh,.glb,.gltf,.vrm,.vrma,.csv,.gz";

type Source = "range" | "frame" | "file";
const seconds = (frames: number) => `${secondsOf(frames).toFixed(2)} s`;

function Choice({name, value, chosen, disabled, words, onChoose}: {name: string; value: Source; chosen: Source; disabled: boolean; words: string;
    onChoose: (value: Source) => void}) {
  return <label class="check"><input type="radio" name={name} checked={chosen === value} disabled={disabled}
      onChange={() => onChoose(value)} />{words}</label>;
}

function Form() {
  const {motion, range} = studioDocument.value;
  const source = useSignal<Source>(motion && range ? "range" : motion ? "frame" : "file");
  const [name, meaning, problem, busy] = [useSignal(""), useSignal(""), useSignal(""), useSignal(false)];
  const clip = useSignal<Clip & {name: string; remarks: readonly string[]} | null>(null);
  const reading = useSignal<string | null>(null);
  const file = useRef<HTMLInputElement>(null);
  const at = playheadFrame.value;
  const frames = (): readonly Frame[] => source.value === "range" && motion && range ? motion.frames.slice(range.from, range.to)
      : source.value === "frame" && motion ? motion.frames.slice(at, at + 1)
      : source.value === "file" && clip.value ? clip.value.frames.slice(clip.value.from, clip.value.to) : [];
  const chosen = frames();
  const tooLong = chosen.length > mostFrames;
  const read = async (one: File) => {
    [clip.value, problem.value, reading.value] = [null, "", one.name];
    try {
      const found = await clipIn(one);
      if (reading.value === one.name) clip.value = {...found, name: one.name};
    } catch (wrong) {
      problem.value = wordsOf(wrong);
    } finally {
      reading.value = null;
    }
  };
  const submit = async (event: Event) => {
    event.preventDefault();
    if (busy.value || chosen.length === 0 || tooLong) return;
    busy.value = true;
    try {
      await addOwn({name: name.value.trim(), ...(meaning.value.trim() !== "" && {meaning: meaning.value.trim()}), frames: chosen});
      ownOnly.value = true;
      addingOwn.value = false;
    } catch (wrong) {
      problem.value = wordsOf(wrong);
    } finally {
      busy.value = false;
    }
  };
  return <form onSubmit={event => void submit(event)}>
    <label class="field"><span>Name</span><input autofocus required maxLength={80} value={name.value} placeholder="Wave with both hands"
        onInput={event => { name.value = event.currentTarget.value; }} /></label>
    <label class="field"><span>What it means (not needed)</span><input maxLength={200} value={meaning.value}
        onInput={event => { meaning.value = event.currentTarget.value; }} /></label>
    <div class="beside">
      <fieldset>
        <legend>Made of</legend>
        <Choice name="source" value="range" chosen={source.value} disabled={!motion || !range} onChoose={one => { source.value = one; }}
            words={motion && range ? `The marked range, ${seconds(range.from)} to ${seconds(range.to)}` : "The marked range (there is none)"} />
        <Choice name="source" value="frame" chosen={source.value} disabled={!motion} onChoose={one => { source.value = one; }}
            words={motion ? `The shown frame, at ${seconds(at)}` : "The shown frame (there is no motion yet)"} />
        <Choice name="source" value="file" chosen={source.value} disabled={false} onChoose={one => { source.value = one; }} words="A clip in a file" />
        {source.value === "file" && <>
          <span class="fields"><button type="button" class="button small" onClick={() => file.current?.click()}>Choose a file</button>
            <span class="note" role="status">{reading.value !== null ? `${reading.value} is read …` : clip.value?.name ?? (readsClips.value ? "a project, BVH, GLB, VRMA, CSV" : "a project, or frames as JSON")}</span></span>
          <input ref={file} id="clip-file" type="file" accept={readsClips.value ? clipFiles : ".json,application/json"} hidden aria-label="Clip file" onChange={() => {
            const one = file.current?.files?.[0];
            if (one) void read(one);
            if (file.current) file.current.value = "";
          }} />
          {clip.value?.remarks.map(remark => <p class="note" key={remark}>{remark}</p>)}
          {clip.value && <div class="fields">
            <Seconds label="From" frames={clip.value.from} least={0} most={clip.value.to - 1} onChange={from => { clip.value = {...clip.value!, from}; }} />
            <Seconds label="To" frames={clip.value.to} least={clip.value.from + 1} most={clip.value.frames.length} onChange={to => { clip.value = {...clip.value!, to}; }} />
          </div>}
        </>}
      </fieldset>
      {chosen.length > 0 && <Figure frame={chosen[Math.floor(chosen.length / 2)]!} />}
    </div>
    <p class="problem-words" role="alert">{tooLong ? `A gesture has at most ${mostFrames / fps} seconds: mark less.` : problem.value}</p>
    <div class="ends-with">
      <p class="note">{chosen.length > 0 ? `${chosen.length} ${chosen.length === 1 ? "frame" : "frames"}, ${seconds(chosen.length)}` : ""}</p>
      <button type="button" class="button small" onClick={() => { addingOwn.value = false; }}>Cancel</button>
      <button type="submit" class="button primary" disabled={name.value.trim() === "" || chosen.length === 0 || tooLong}>Add to the library</button>
    </div>
  </form>;
}

export function OwnGestureDialog() {
  return <Dialog open={addingOwn} id="own-gesture" title="A gesture of your own" narrow><Form /></Dialog>;
}
