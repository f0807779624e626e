// A style's curve: points that are dragged or worked by keys, with straight lines between them.
import {useSignal} from "@preact/signals";
import {useRef} from "preact/hooks";
import {moved, valueAt, withoutPoint, withPoint} from "../model/curves.ts";
import {styleLimit, type CurvePoint, type StyleControl, type StyleName} from "../model/document.ts";
import {secondsOf} from "../model/frames.ts";
import {setStyle} from "../actions/editing.ts";
import {settle} from "../state/store.ts";
import {followPointer} from "./follow_pointer.ts";

type Curve = readonly CurvePoint[];

const topOf = (value: number) => 50 - 50 * value / styleLimit;  // percent
const fine = 0.1;

export const curveLine = (curve: Curve): string => [{at: 0, value: curve[0]!.value}, ...curve, {at: 1, value: curve.at(-1)!.value}]
    .map(({at, value}) => `${(100 * at).toFixed(2)},${topOf(value).toFixed(2)}`).join(" ");

interface Props { control: StyleControl; name: StyleName; label: string; curve: Curve }

export function CurveEditor({control, name, label, curve}: Props) {
  const place = useRef<HTMLDivElement>(null);
  const dragged = useSignal<Curve | null>(null);
  const shown = dragged.value ?? curve;
  const step = 1 / Math.max(1, control.length - 1);  // a frame
  const put = (next: Curve, merge = false) => {
    if (!merge) settle();
    setStyle(control.id, name, next);
    if (!merge) settle();
  };
  const focusOn = (k: number) => requestAnimationFrame(() => (place.current?.querySelectorAll("button")[k] as HTMLElement | undefined)?.focus());
  const at = (event: MouseEvent) => {
    const {left, top, width, height} = place.current!.getBoundingClientRect();
    const share = Math.min(1, Math.max(0, (event.clientX - left) / width));
    return {at: Math.round(share / step) * step, value: styleLimit * (1 - 2 * (event.clientY - top) / height)};
  };
  const press = (event: PointerEvent, k: number) => {
    if (event.button !== 0) return;
    followPointer(event, {
      moved(next) {
        const to = at(next);
        dragged.value = moved(curve, k, to.at, to.value, step);
      },
      ended(kept) {
        if (kept && dragged.value) put(dragged.value);
        dragged.value = null;
      }});
  };
  const add = (share: number, value: number) => {
    const next = withPoint(curve, share, value, step);
    if (next === curve) return;
    put(next);
    focusOn(next.findIndex(point => point.at === share));
  };
  const key = (event: KeyboardEvent, k: number) => {
    const point = curve[k]!;
    const by = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, fine], ArrowDown: [0, -fine], PageUp: [0, 1], PageDown: [0, -1]}[event.key];
    if (event.ctrlKey || event.metaKey) return;
    if (by) {
      put(moved(curve, k, point.at + by[0]!, point.value + by[1]!, step), true);
    } else if (event.key === "Enter" || event.key === "+") {
      const next = curve[k + 1] ?? {at: 1};
      const share = Math.round((point.at + next.at) / 2 / step) * step;
      add(share, valueAt(curve, share)!);
    } else if (event.key === "Delete" || event.key === "Backspace" || event.key === "d") {
      put(withoutPoint(curve, k));
      focusOn(Math.max(0, k - 1));
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  };
  return <div class="curve" role="group" aria-label={`${label} curve: arrows move a point, Enter adds one, Delete takes it away`} ref={place}
      title="Drag the points; a double click adds one, Delete takes one away" onDblClick={event => {
        const to = at(event);
        add(to.at, to.value);
      }}>
    <svg viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
      <line x1={0} x2={100} y1={50} y2={50} />
      <polyline points={curveLine(shown)} />
    </svg>
    {shown.map((point, k) => <button type="button" class="curve-point" key={k} role="slider" aria-orientation="vertical"
        aria-label={`${label}, point ${k + 1} of ${shown.length}`} aria-valuemin={-styleLimit} aria-valuemax={styleLimit} aria-valuenow={Number(point.value.toFixed(1))}
        aria-valuetext={`${point.value.toFixed(1)} at ${secondsOf(control.start + point.at * (control.length - 1)).toFixed(2)} s`}
        style={{left: `${100 * point.at}%`, top: `${topOf(point.value)}%`}} onPointerDown={event => press(event, k)} onKeyDown={event => key(event, k)} onBlur={settle} />)}
  </div>;
}
