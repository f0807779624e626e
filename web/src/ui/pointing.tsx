// The ball that the avatar points at: dragged in the picture, moved by keys and in numbers, and put on a word.
import {useRef} from "preact/hooks";
import {pointHere, toggleBall, wordHere} from "../actions/pointing.ts";
import {ball, ballRoom, pointed, pointingLength, pointingProblem, pointingSide, putBall} from "../state/stage.ts";
import {settle, totalFrames} from "../state/store.ts";
import type {PointingSide} from "../api/kept.ts";
import type {Point} from "../model/posing.ts";
import type {AvatarView} from "../view/avatar_view.ts";
import {IconButton} from "./icon_button.tsx";
import {pressToMove, steppedByKey} from "./moving.ts";
import {Seconds} from "./seconds.tsx";
import {useSpots} from "./spots.ts";
import {TypedNumber} from "./typed_number.tsx";

export function BallHandle({view}: {view: AvatarView}) {
  const place = useRef<HTMLDivElement>(null);
  useSpots(view, place, [() => ball.value]);
  return <div class="handles" ref={place}>
    <button type="button" class="handle ball" aria-label="Ball to point at" title="Drag, or arrow keys; Shift+↑↓ away and near"
        onPointerDown={event => {
          const before = ball.value;
          let kept = false;
          pressToMove(event, view, {from: () => ball.value, tried: putBall, kept: () => { kept = true; },
            dropped: () => { if (!kept && before && ball.value) putBall(before); }});
        }}
        onKeyDown={event => {
          const to = ball.value && steppedByKey(event, view, ball.value);
          if (to) putBall(to);
        }} onBlur={settle} />
  </div>;
}

const axes = ["Left", "Up", "Ahead"];

export function PointingPanel() {
  const at = ball.value!;
  const word = wordHere();
  const {value: found} = pointed;
  return <section class="panel inspector" aria-labelledby="pointing-title">
    <div class="panel-head"><h2 id="pointing-title">Point at the ball</h2><IconButton icon="close" name="Put the ball away" keys="B" onClick={toggleBall} /></div>
    <div class="triple">{axes.map((axis, k) => <label class="field" key={axis}><span>{axis} (m)</span>
      <TypedNumber step={0.05} min={ballRoom[k]![0]} max={ballRoom[k]![1]} value={at[k]!.toFixed(2)}
          onChange={wanted => putBall(at.map((one, i) => i === k ? wanted : one) as unknown as Point)} /></label>)}</div>
    <div class="fields">
      <label class="field inline"><span>Hand</span><select value={pointingSide.value} onChange={event => { pointingSide.value = event.currentTarget.value as PointingSide; }}>
        <option value="auto">nearer</option><option value="left">left</option><option value="right">right</option>
      </select></label>
      <Seconds label="Length" frames={pointingLength.value} least={1} most={Math.max(1, totalFrames.value)}
          onChange={frames => { pointingLength.value = frames; }} />
    </div>
    <p class={pointingProblem.value ? "problem-words" : "note"} role="status">{pointingProblem.value ||
      (found ? `${found.side === "left" ? "Left" : "Right"} hand, ${found.off_deg.toFixed(1)}° off.` : "…")}</p>
    <button type="button" class="button primary" disabled={!word || !found} onClick={pointHere}>{word ? `Point here at “${word.word}”` : "Generate first"}</button>
  </section>;
}
