// A style's value over its control: one number, or points with straight lines between them.
import {styleLimit, styleNames, type CurvePoint, type StyleControl, type StyleName, type StyleValue} from "./document.ts";

export const isCurve = (value: StyleValue): value is readonly CurvePoint[] => value !== null && typeof value !== "number";

const tenth = (value: number): number => Math.round(10 * Math.min(styleLimit, Math.max(-styleLimit, value))) / 10;

// At a share of the control, 0 to 1; before the first point and behind the last, those.
export function valueAt(value: StyleValue, share: number): number | null {
  if (!isCurve(value)) return value;
  const next = value.findIndex(point => point.at > share);
  if (next === 0) return value[0]!.value;
  if (next < 0) return value.at(-1)!.value;
  const [a, b] = [value[next - 1]!, value[next]!];
  return a.value + (b.value - a.value) * (share - a.at) / (b.at - a.at);
}

// Of a number: flat, from end to end.
export const curveOf = (value: StyleValue): readonly CurvePoint[] =>
    isCurve(value) ? value : [{at: 0, value: value ?? 0}, {at: 1, value: value ?? 0}];

// Of a curve: its middle's value.
export const constantOf = (value: StyleValue): number => tenth(valueAt(value, 0.5) ?? 0);

// Of the other side.
export const opposite = (value: StyleValue): StyleValue => value === null ? null
    : isCurve(value) ? value.map(point => ({at: point.at, value: 0 - point.value})) : 0 - value;

// A point put, moved or taken away; the others stay, in order, a step apart at least. Two points are the fewest.
export function moved(curve: readonly CurvePoint[], k: number, at: number, value: number, step: number): readonly CurvePoint[] {
  const [low, high] = [k === 0 ? 0 : curve[k - 1]!.at + step, k === curve.length - 1 ? 1 : curve[k + 1]!.at - step];
  const point = {at: Math.min(Math.max(at, low), Math.max(low, high)), value: tenth(value)};
  return curve.map((one, i) => i === k ? point : one);
}

// Where there is no room for it beside its neighbours: the curve as it was.
export function withPoint(curve: readonly CurvePoint[], at: number, value: number, step: number): readonly CurvePoint[] {
  if (at < 0 || at > 1 || curve.some(point => Math.abs(point.at - at) < step - 1e-9)) return curve;
  return [...curve, {at, value: tenth(value)}].sort((a, b) => a.at - b.at);
}

export const withoutPoint = (curve: readonly CurvePoint[], k: number): readonly CurvePoint[] =>
    curve.length <= 2 ? curve : curve.filter((_, i) => i !== k);

export interface StylePiece { start_frame: number; frame_count: number; speed?: number; space?: number; handedness?: number }

function piecesOf(control: StyleControl, stride: number): StylePiece[] {
  if (styleNames.every(name => control[name] === null)) return [];
  const pieces: StylePiece[] = [];
  const curved = styleNames.some(name => isCurve(control[name]));
  const step = curved ? stride : control.length;
  for (let from = 0; from < control.length; from += step) {
    const count = Math.min(step, control.length - from);
    const share = control.length === 1 ? 0.5 : (from + (count - 1) / 2) / (control.length - 1);
    const values = Object.fromEntries(styleNames.flatMap((name: StyleName) => {
      const value = valueAt(control[name], share);
      return value === null ? [] : [[name, Math.round(1000 * value) / 1000]];
    }));
    const last = pieces.at(-1);
    if (last && styleNames.every(name => last[name] === values[name])) last.frame_count += count;
    else pieces.push({start_frame: control.start + from, frame_count: count, ...values});
  }
  return pieces;
}

// As the server takes styles: constant over stretches. Curves are cut frame by frame, into longer steps only where those
// would be more than `most`.
export function stylePieces(controls: readonly StyleControl[], most = 1000): StylePiece[] {
  let pieces: StylePiece[] = [];
  for (let stride = 1; ; stride *= 2) {
    pieces = controls.flatMap(control => piecesOf(control, stride));
    if (pieces.length <= most || controls.every(control => control.length <= stride)) return pieces;
  }
}
