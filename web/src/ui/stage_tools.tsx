// What lies over the avatar's picture: the view, how joints are worked, the ball, and a pose that is tried.
import {toggleBall} from "../actions/pointing.ts";
import {dropTried, keepTried} from "../actions/trying.ts";
import {handling, inHand, trial} from "../state/posing.ts";
import {points} from "../state/server.ts";
import {ball, chosenCamera} from "../state/stage.ts";
import {cameras, type Camera} from "../view/cameras.ts";
import {IconButton} from "./icon_button.tsx";

export function StageTools() {
  const turns = handling.value === "turn";
  return <div class="views" role="group" aria-label="View and tools">
    {inHand.value && !ball.value && <IconButton icon="turn" name="Turn parts of the pose by rings" keys="R" pressed={turns} onClick={() => { handling.value = turns ? "move" : "turn"; }}>Turn</IconButton>}
    {points.value && <IconButton icon="target" name="A ball to point at" keys="B" pressed={ball.value !== null} onClick={toggleBall}>Point</IconButton>}
    <select class="quiet" aria-label="View" title="From where the avatar is seen (keys 1 to 6)" value={chosenCamera.value.camera}
        onChange={event => { chosenCamera.value = {camera: event.currentTarget.value as Camera}; }}>
      {cameras.slice(0, 4).map(([camera, name]) => <option key={camera} value={camera}>{name}</option>)}
      <optgroup label="As a participant">
        {cameras.slice(4).map(([camera, name]) => <option key={camera} value={camera}>{name}</option>)}
      </optgroup>
    </select>
  </div>;
}

export function TrialBar() {
  if (!trial.value) return null;
  const {control, at, frames} = trial.value;
  return <div class="trial" role="group" aria-label="The pose that is tried">
    <span title={control?.name}>Trying a pose{frames.length > 1 ? ` (${at} of ${frames.length - 1})` : ""}</span>
    <button type="button" class="button small" title="Keep it (K)" onClick={keepTried}>Keep</button>
    <button type="button" class="button small" title="Drop it (Esc)" onClick={dropTried}>Drop</button>
  </div>;
}
