// A field for a number of frames, in seconds: arrows go by frames.
import {fps} from "../model/document.ts";
import {TypedNumber} from "./typed_number.tsx";

interface Props { label: string; frames: number; least: number; most: number; onChange: (frames: number) => void }

export function Seconds({label, frames, least, most, onChange}: Props) {
  const put = (wanted: number) => onChange(Math.min(Math.max(least, wanted), most));
  return <label class="field inline"><span>{label}</span>
    <span class="with-unit">
      <TypedNumber min={(least / fps).toFixed(2)} max={(most / fps).toFixed(2)} step="any" value={(frames / fps).toFixed(2)}
          onChange={wanted => put(Math.round(wanted * fps))} onKeyDown={event => {
            const way = {ArrowUp: 1, ArrowDown: -1}[event.key];
            if (way === undefined) return;
            event.preventDefault();
            put(frames + way);
          }} /><span class="unit">s</span>
    </span>
  </label>;
}
