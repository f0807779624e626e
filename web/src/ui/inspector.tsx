// What is selected, in numbers and sliders; with nothing selected, what can be added, and what is done to all.
import {useSignal} from "@preact/signals";
import {copy, flip, move, remove, scaleTimes, setSpeed} from "../actions/editing.ts";
import {putByRules} from "../actions/rule_gestures.ts";
import {allControls, nameOf} from "../model/controls.ts";
import type {PoseControl} from "../model/document.ts";
import {lengthAtSpeed} from "../model/frames.ts";
import {isManual, keepsRules, takes} from "../state/server.ts";
import {ball} from "../state/stage.ts";
import {edit, select, selected, settle, studioDocument} from "../state/store.ts";
import {IconButton} from "./icon_button.tsx";
import {PointingPanel} from "./pointing.tsx";
import {StyleButtons, StyleCard} from "./style_card.tsx";
import {Times} from "./times.tsx";

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
      <IconButton icon="flip" name="Flip left and right" keys="F" pressed={control.mirrored} onClick={() => flip()}>Flip</IconButton>
    </div>
    {takes("exact") && <label class="check"><input type="checkbox" checked={studioDocument.value.exact} onChange={event => {
      const exact = event.currentTarget.checked;
      edit(exact ? "Meet poses exactly" : "Meet poses about", draft => { draft.exact = exact; });
    }} />Meet all poses exactly</label>}
  </>;
}

// Of the selected controls, about the first one's start; of all, about the speech's.
function Scaling() {
  const percent = useSignal(100);
  return <form class="fields scaling" onSubmit={event => {
    event.preventDefault();
    scaleTimes(percent.value / 100);
  }}>
    <label class="field inline"><span>Times to</span>
      <span class="with-unit"><input type="number" min={10} max={1000} step="any" required value={percent.value}
          onInput={event => { percent.value = event.currentTarget.valueAsNumber; }} /><span class="unit">%</span></span>
    </label>
    <button type="submit" class="button small" title="Move and stretch the controls: 200 % is twice as late and twice as long"
        disabled={!(percent.value >= 10 && percent.value <= 1000) || percent.value === 100}>Scale</button>
  </form>;
}

function Several() {
  return <>
    <p class="note">They are moved, copied and deleted together.</p>
    <div class="segments" role="group" aria-label="Nudge">
      <button type="button" class="button small" title="A frame earlier (Ctrl+←)" onClick={() => move(-1)}>Earlier</button>
      <button type="button" class="button small" title="A frame later (Ctrl+→)" onClick={() => move(1)}>Later</button>
      <button type="button" class="button small" title="Left and right change sides (F)" onClick={() => flip()}>Flip</button>
    </div>
    <Scaling />
  </>;
}

function Adding() {
  const none = studioDocument.value.speech === null;
  const all = allControls(studioDocument.value);
  if (none) return <p class="note">Generate first; then shape the result with poses and styles.</p>;
  return <>
    {!isManual.value && <>
      <p class="note">Add a style at the playhead, or over the marked range:</p>
      <StyleButtons />
    </>}
    {(all.length === 0 || isManual.value) && <p class="note">Poses come from the library, or keep what the avatar shows.</p>}
    {(all.length > 0 || keepsRules.value) && <div class="segments" role="group" aria-label="All controls">
      {all.length > 0 && <>
        <button type="button" class="button small" title="Select all controls (Ctrl+A)" onClick={() => select(...all.map(control => control.id))}>Select all</button>
        <button type="button" class="button small" title="Left and right change sides, in poses and styles" onClick={() => flip("all")}>Mirror all</button>
      </>}
      {keepsRules.value && <button type="button" class="button small" title="Put a gesture on each word that has a rule, where there is room"
          onClick={() => void putByRules()}>Put by rules</button>}
    </div>}
    {all.length > 0 && <Scaling />}
  </>;
}

export function Inspector() {
  if (ball.value) return <PointingPanel />;
  const [one, ...others] = selected.value;
  const title = !one ? isManual.value ? "Keyframes" : "Style" : others.length > 0 ? `${others.length + 1} controls` : one.kind === "pose" ? "Pose control" : "Style control";
  return <section class="panel inspector" aria-labelledby="inspector-title">
    <div class="panel-head">
      <h2 id="inspector-title">{title}</h2>
      {one && <span class="panel-tools">
        <IconButton icon="copy" name={others.length > 0 ? "Copy controls" : `Copy ${nameOf(one)}`} keys="Ctrl+C" onClick={copy} />
        <IconButton icon="bin" name={others.length > 0 ? "Delete controls" : `Delete ${nameOf(one)}`} keys="Delete" onClick={remove} />
      </span>}
    </div>
    {!one ? <Adding /> : others.length > 0 ? <Several /> :
      one.kind === "pose" ? <PoseCard key={one.id} control={one} /> : <StyleCard key={one.id} control={one} />}
  </section>;
}
