// A style in the inspector: presets, and each of its values as a number, a curve, or left free.
import {addStyle, setStyle, setStyles} from "../actions/editing.ts";
import {constantOf, curveOf, isCurve} from "../model/curves.ts";
import {styleLimit, styleNames, type StyleControl, type StyleName, type StyleValue, type StyleValues} from "../model/document.ts";
import {settle} from "../state/store.ts";
import {CurveEditor} from "./curve_editor.tsx";
import {Times} from "./times.tsx";

// Speed, space, handedness, as SGToolkit's published program has them.
const presets: readonly (readonly [name: string, values: StyleValues, about: string])[] = [
  ["Happy", {speed: 2, space: 1, handedness: 0}, "speed 2, space 1, handedness 0. The paper's first prototype: speed 2.5, acceleration 2.0"],
  ["Sad", {speed: -1, space: 0, handedness: 0}, "speed −1, space 0, handedness 0. The paper's first prototype: speed −2.5"],
  ["Angry", {speed: 2.5, space: 2, handedness: 0}, "speed 2.5, space 2, handedness 0. The paper's first prototype names none"],
];
const free: StyleValues = {speed: null, space: null, handedness: null};
const blank: StyleValues = {speed: 0, space: null, handedness: null};

const meanings: Record<StyleName, {low: string; high: string; label: string}> = {
  speed: {low: "slow", high: "fast", label: "Speed"},
  space: {low: "close", high: "wide", label: "Space"},
  handedness: {low: "right", high: "left", label: "Handedness"},
};

type Kind = "value" | "curve" | "free";
const kindOf = (value: StyleValue): Kind => value === null ? "free" : isCurve(value) ? "curve" : "value";

function StyleSlider({control, name}: {control: StyleControl; name: StyleName}) {
  const value = control[name];
  const {label, low, high} = meanings[name];
  const kind = kindOf(value);
  return <div class={`style-slider ${name} is-${kind}`}>
    {kind === "curve" ? <span class="style-name">{label}</span> : <label class="style-name" for={`slider-${name}`}>{label}</label>}
    {isCurve(value) ? <CurveEditor control={control} name={name} label={label} curve={value} /> : <>
      <output>{value === null ? "free" : `${value > 0 ? "+" : ""}${value.toFixed(1)}`}</output>
      <input id={`slider-${name}`} type="range" min={-styleLimit} max={styleLimit} step={0.1} value={value ?? 0}
          aria-valuetext={value === null ? "free" : value.toFixed(1)} onInput={event => setStyle(control.id, name, event.currentTarget.valueAsNumber)}
          onPointerUp={settle} onBlur={settle} />
      <span class="ends" aria-hidden="true"><span>{low}</span><span>{high}</span></span>
    </>}
    <select class="quiet" aria-label={`${label}: value, curve or free`} title="A value, a curve over time, or left free" value={kind} onChange={event => {
      const wanted = event.currentTarget.value as Kind;
      settle();
      setStyle(control.id, name, wanted === "free" ? null : wanted === "curve" ? curveOf(value) : constantOf(value));
      settle();
      if (wanted === "curve") requestAnimationFrame(() => document.querySelector(`.style-slider.${name} .curve`)?.scrollIntoView({block: "nearest"}));
    }}>
      <option value="value">value</option><option value="curve">curve</option><option value="free">free</option>
    </select>
  </div>;
}

export function StyleCard({control}: {control: StyleControl}) {
  return <>
    <div class="segments" role="group" aria-label="Presets">
      {presets.map(([name, values, about]) => <button type="button" class="button small" key={name} title={`${name}: ${about}`}
          aria-pressed={styleNames.every(one => control[one] === values[one])} onClick={() => setStyles(control.id, values, name)}>{name}</button>)}
      <button type="button" class="button small" aria-pressed={styleNames.every(one => control[one] === null)}
          onClick={() => setStyles(control.id, free, "Leave the style free")}>All free</button>
    </div>
    {styleNames.map(name => <StyleSlider key={name} control={control} name={name} />)}
    <div class="fields"><Times control={control} /></div>
  </>;
}

export const addBlankStyle = (): void => addStyle(blank);

export function StyleButtons() {
  return <div class="segments" role="group" aria-label="Add a style">
    {presets.map(([name, values, about]) => <button type="button" class="button small" key={name} title={`${name}: ${about}`}
        onClick={() => addStyle(values)}>{name}</button>)}
    <button type="button" class="button small" title="Add a style (S)" onClick={addBlankStyle}>Own style</button>
  </div>;
}
