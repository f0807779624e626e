// How gestures are made and finished: only what the server says that it takes.
import {signal} from "@preact/signals";
import {offers} from "../state/mode.ts";
import {isManual, keyframes, keepsRules, served, system, takes} from "../state/server.ts";
import {edit, settle, studioDocument} from "../state/store.ts";
import type {Finish} from "../model/document.ts";
import {Dialog} from "./dialog.tsx";
import {Icon} from "./icons.tsx";

const open = signal(false);

const systems: Record<string, {readonly name: string; readonly short: string; readonly about: string}> = {
  model: {name: "Trained model", short: "By model", about: "Learned from a corpus; poses and styles steer it."},
  rules: {name: "Rules", short: "By rules", about: "Beats on accents and unit gestures on words, by rules."},
  [keyframes]: {name: "Keyframes (MANUAL)", short: "Keyframes", about: "Your poses alone, joined by smooth curves: no model, no style, no range."},
};
const wordsFor = (name: string) => systems[name] ?? {name, short: name, about: ""};

const finishes: readonly {readonly field: string; readonly name: keyof Finish; readonly label: string}[] = [
  {field: "fade", name: "fade", label: "Pass to the mean pose after the last word"},
  {field: "still", name: "still", label: "Stand quite still where nothing is gestured"},
  {field: "relaxed_fingers", name: "relaxedFingers", label: "Relaxed fingers"},
];

export function OptionsButton() {
  if (!system.value) return null;
  return <button type="button" class="button small options" title="How gestures are made" aria-haspopup="dialog" onClick={() => { open.value = true; }}>
    <Icon name="options" /><span>{offers("systems") ? wordsFor(system.value.system).short : "Options"}</span></button>;
}

function Switch({label, on, name, change}: {label: string; on: boolean; name: string; change: (on: boolean) => void}) {
  return <label class="check"><input type="checkbox" name={name} checked={on} onChange={event => change(event.currentTarget.checked)} />{label}</label>;
}

function Variety() {
  const {variety} = studioDocument.value;
  return <label class="field variety"><span>Variety: {variety.toFixed(1)}{variety === 0 ? " – each version number gives the same" : ""}</span>
    <input type="range" min={0} max={2} step={0.1} value={variety} aria-valuetext={variety.toFixed(1)} onInput={event => {
      const value = event.currentTarget.valueAsNumber;
      edit("Change the variety", draft => { draft.variety = value; }, "variety");
    }} onBlur={settle} onPointerUp={settle} />
    <span class="ends" aria-hidden="true"><span>the mean style</span><span>as in the corpus at 1, and beyond</span></span>
  </label>;
}

function Form() {
  const {finish, exact, byRules} = studioDocument.value;
  const all = served.value?.gestures ?? [];
  const shown = finishes.filter(one => takes(one.field));
  return <form onSubmit={event => {
    event.preventDefault();
    open.value = false;
  }}>
    {offers("systems") && <fieldset>
      <legend>Made by</legend>
      {all.map((one, k) => <label class="choice" key={one.system}><input type="radio" name="system" checked={system.value === one}
          onChange={() => edit(`Made by ${wordsFor(one.system).name}`, draft => { draft.system = k === 0 ? null : one.system; })} />
        <span><b>{wordsFor(one.system).name}</b><span class="note">{wordsFor(one.system).about}</span></span></label>)}
    </fieldset>}
    {isManual.value && <p class="note">The movement begins and ends in the mean pose; bones keep their lengths.{offers("systems") && " Style controls stay in the project, and are not used."}</p>}
    {takes("variety") && <Variety />}
    <fieldset>
      {(shown.length > 0 || takes("exact")) && <legend>Also</legend>}
      {takes("exact") && <Switch name="exact" label="Meet all poses exactly" on={exact} change={on =>
        edit(on ? "Meet poses exactly" : "Meet poses about", draft => { draft.exact = on; })} />}
      {shown.map(({name, label}) => <Switch key={name} name={name} label={label} on={finish[name]} change={on =>
        edit(`${on ? "Switch on" : "Switch off"}: ${label.toLowerCase()}`, draft => { draft.finish[name] = on; })} />)}
      {keepsRules.value && <Switch name="byRules" label="Put gestures by rules whenever all is generated" on={byRules} change={on =>
        edit(on ? "Put gestures by rules at each Generate" : "Put no gestures by rules", draft => { draft.byRules = on; })} />}
    </fieldset>
    <div class="ends-with"><p class="note">Undo takes each choice back.</p><button type="submit" class="button primary">Done</button></div>
  </form>;
}

export function OptionsDialog() {
  return <Dialog open={open} id="options" title="How gestures are made" narrow><Form /></Dialog>;
}
