// What is selected, in numbers and sliders; with nothing selected, what can be added.
import {addStyle, copy, flip, remove, setLength, setSpeed, setStart, setStyle, setStyles} from "../actions/editing.ts";
import {nameOf} from "../model/controls.ts";
import {fps, styleLimit, styleNames, type Control, type PoseControl, type StyleControl, type StyleName, type StyleValues} from "../model/document.ts";
import {lengthAtSpeed} from "../model/frames.ts";
import {edit, selected, settle, studioDocument, totalFrames} from "../state/store.ts";
import {IconButton} from "./icon_button.tsx";

// Speed, space, handedness, as SGToolkit's published program has them; the paper's first prototype had others, with an
// acceleration that its final one dropped.
const presets: readonly (readonly [name: string, values: StyleValues])[] = [
  ["Happy", {speed: 2, space: 1, handedness: 0}],
  ["Sad", {speed: -1, space: 0, handedness: 0}],
  ["Angry", {speed: 2.5, space: 2, handedness: 0}],
];
const free: StyleValues = {speed: null, space: null, handedness: null};
const blank: StyleValues = {speed: 0, space: null, handedness: null};

const meanings: Record<StyleName, {low: string; high: string; label: string}> = {
  speed: {low: "slow", high: "fast", label: "Speed"},
  space: {low: "close", high: "wide", label: "Space"},
  handedness: {low: "right", high: "left", label: "Handedness"},
};

function Seconds({label, frames, least, most, onChange}: {label: string; frames: number; least: number; most: number; onChange: (frames: number) => void}) {
  return <label class="field inline"><span>{label}</span>
    <span class="with-unit">
      <input type="number" min={(least / fps).toFixed(2)} max={(most / fps).toFixed(2)} step="any" value={(frames / fps).toFixed(2)}
          onChange={event => {
            const wanted = event.currentTarget.valueAsNumber;
            if (Number.isFinite(wanted)) onChange(Math.min(Math.max(least, Math.round(wanted * fps)), most));
            event.currentTarget.value = (frames / fps).toFixed(2);
          }}
          onKeyDown={event => {
            const way = {ArrowUp: 1, ArrowDown: -1}[event.key];
            if (way === undefined) return;
            event.preventDefault();
            onChange(Math.min(Math.max(least, frames + way), most));
          }} /><span class="unit">s</span>
    </span>
  </label>;
}

function Times({control}: {control: Control}) {
  const total = totalFrames.value;
  return <>
    <Seconds label="Start" frames={control.start} least={0} most={total - control.length} onChange={frames => setStart(control, frames)} />
    <Seconds label="Length" frames={control.length} least={1} most={total - control.start} onChange={frames => setLength(control, frames)} />
  </>;
}

function PoseCard({control}: {control: PoseControl}) {
  const speeds = control.base.length > 1 ? [1, 2, 3] : [];
  return <>
    <label class="field inline"><span>Name</span>
      <input value={control.name} maxLength={60} onInput={event => {
        const name = event.currentTarget.value;
        edit("Rename", draft => {
          const one = draft.poseControls.find(each => each.id === control.id);
          if (one && name.trim() !== "") one.name = name;
        }, `name ${control.id}`);
      }} onBlur={settle} />
    </label>
    <div class="fields"><Times control={control} /></div>
    <div class="fields line">
      {speeds.length > 0 && <div class="segments" role="group" aria-label="Speed">
        {speeds.map(speed => <button type="button" class="button small" key={speed} aria-pressed={control.length === lengthAtSpeed(control.base.length, speed)}
            onClick={() => setSpeed(control, speed)}>{speed}×</button>)}
      </div>}
      <IconButton icon="flip" name="Flip left and right" keys="F" pressed={control.mirrored} onClick={flip}>Flip</IconButton>
    </div>
    <label class="check"><input type="checkbox" checked={studioDocument.value.exact} onChange={event => {
      const exact = event.currentTarget.checked;
      edit(exact ? "Meet poses exactly" : "Meet poses about", draft => { draft.exact = exact; });
    }} />Meet all poses exactly</label>
  </>;
}

function StyleSlider({control, name}: {control: StyleControl; name: StyleName}) {
  const value = control[name];
  const {label, low, high} = meanings[name];
  return <div class={value === null ? "style-slider is-free" : "style-slider"}>
    <label for={`slider-${name}`}>{label}</label>
    <output>{value === null ? "free" : `${value > 0 ? "+" : ""}${value.toFixed(1)}`}</output>
    <input id={`slider-${name}`} type="range" min={-styleLimit} max={styleLimit} step={0.1} value={value ?? 0}
        aria-valuetext={value === null ? "free" : value.toFixed(1)} onInput={event => setStyle(control.id, name, event.currentTarget.valueAsNumber)}
        onPointerUp={settle} onBlur={settle} />
    <button type="button" class="button small" aria-pressed={value === null} aria-label={`${label} free`} title="Leave it to the model"
        onClick={() => setStyle(control.id, name, value === null ? 0 : null)}>Free</button>
    <span class="ends" aria-hidden="true"><span>{low}</span><span>{high}</span></span>
  </div>;
}

function StyleCard({control}: {control: StyleControl}) {
  return <>
    <div class="segments" role="group" aria-label="Presets">
      {presets.map(([name, values]) => <button type="button" class="button small" key={name}
          aria-pressed={styleNames.every(one => control[one] === values[one])} onClick={() => setStyles(control.id, values, name)}>{name}</button>)}
      <button type="button" class="button small" aria-pressed={styleNames.every(one => control[one] === null)}
          onClick={() => setStyles(control.id, free, "Leave the style free")}>All free</button>
    </div>
    {styleNames.map(name => <StyleSlider key={name} control={control} name={name} />)}
    <div class="fields"><Times control={control} /></div>
  </>;
}

export const addBlankStyle = (): void => addStyle(blank);

function Adding() {
  const none = studioDocument.value.speech === null;
  return <>
    <p class="note">{none ? "Generate first; then shape the result with poses and styles." :
      "Add a style at the playhead, or over the marked range:"}</p>
    {!none && <div class="segments" role="group" aria-label="Add a style">
      {presets.map(([name, values]) => <button type="button" class="button small" key={name} onClick={() => addStyle(values)}>{name}</button>)}
      <button type="button" class="button small" title="Add a style (S)" onClick={addBlankStyle}>Own style</button>
    </div>}
    {!none && <p class="note">Poses come from the library, or keep what the avatar shows.</p>}
  </>;
}

export function Inspector() {
  const [one, ...others] = selected.value;
  const title = !one ? "Style" : others.length > 0 ? `${others.length + 1} controls` : one.kind === "pose" ? "Pose control" : "Style control";
  return <section class="panel inspector" aria-labelledby="inspector-title">
    <div class="panel-head">
      <h2 id="inspector-title">{title}</h2>
      {one && <span class="panel-tools">
        <IconButton icon="copy" name={others.length > 0 ? "Copy controls" : `Copy ${nameOf(one)}`} keys="Ctrl+C" onClick={copy} />
        <IconButton icon="bin" name={others.length > 0 ? "Delete controls" : `Delete ${nameOf(one)}`} keys="Delete" onClick={remove} />
      </span>}
    </div>
    {!one ? <Adding /> : others.length > 0 ? <p class="note">They are moved, copied and deleted together.</p> :
      one.kind === "pose" ? <PoseCard key={one.id} control={one} /> : <StyleCard key={one.id} control={one} />}
  </section>;
}
