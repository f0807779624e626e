// When a control is, in two fields.
import {setLength, setStart} from "../actions/editing.ts";
import type {Control} from "../model/document.ts";
import {totalFrames} from "../state/store.ts";
import {Seconds} from "./seconds.tsx";

export function Times({control}: {control: Control}) {
  const total = totalFrames.value;
  return <>
    <Seconds label="Start" frames={control.start} least={0} most={total - control.length} onChange={frames => setStart(control, frames)} />
    <Seconds label="Length" frames={control.length} least={1} most={total - control.start} onChange={frames => setLength(control, frames)} />
  </>;
}
