// What of the pose can be turned about its joint: chosen by a press, turned by rings or by the arrow keys.
import {useEffect, useRef} from "preact/hooks";
import {turnAbout, turnedPart, type Part, type Point, type Turn} from "../model/posing.ts";
import {dropPose, inHand, keepPose, tryPose, turning, type InHand} from "../state/posing.ts";
import {settle} from "../state/store.ts";
import type {AvatarView} from "../view/avatar_view.ts";
import {useSpots} from "./spots.ts";

const spots: readonly {readonly part: Part; readonly bone: string; readonly name: string}[] = [
  {part: "body", bone: "spine", name: "Upper body"}, {part: "head", bone: "neck", name: "Head"},
  {part: "rightShoulder", bone: "rightShoulder", name: "Right shoulder"}, {part: "rightUpperArm", bone: "rightUpperArm", name: "Right upper arm"},
  {part: "rightForearm", bone: "rightLowerArm", name: "Right forearm"}, {part: "leftShoulder", bone: "leftShoulder", name: "Left shoulder"},
  {part: "leftUpperArm", bone: "leftUpperArm", name: "Left upper arm"}, {part: "leftForearm", bone: "leftLowerArm", name: "Left forearm"},
];
const step = Math.PI / 36;

// Shoulders begin at the neck: they are taken hold of halfway to the arm.
function placeOf(view: AvatarView, bone: string): Point | null {
  const at = view.place(bone);
  const arm = bone.endsWith("Shoulder") ? view.place(bone.replace("Shoulder", "UpperArm")) : null;
  return at && arm ? [(at[0] + arm[0]) / 2, (at[1] + arm[1]) / 2, (at[2] + arm[2]) / 2] : at;
}

// About which axis a key turns: across, up, and with Shift ahead.
function turnOf(event: KeyboardEvent): Turn | null {
  const way = {ArrowLeft: -1, ArrowRight: 1, ArrowUp: -1, ArrowDown: 1}[event.key];
  if (way === undefined || event.ctrlKey) return null;
  const sideways = event.key === "ArrowLeft" || event.key === "ArrowRight";
  const axis: Point = sideways ? event.shiftKey ? [0, 0, -1] : [0, 1, 0] : [1, 0, 0];
  return turnAbout(axis, way * step);
}

export function TurnHandles({view}: {view: AvatarView}) {
  const place = useRef<HTMLDivElement>(null);
  useSpots(view, place, spots.map(({bone}) => () => placeOf(view, bone)));
  const chosen = spots.find(spot => spot.part === turning.value);
  useEffect(() => {
    if (!chosen) return;
    const label = `Turn the ${chosen.name.toLowerCase()}`;
    let hand: InHand | null = null;  // since the press
    let last: Turn | null = null;
    let stood = "";
    const follow = () => {
      const at = view.place(chosen.bone);
      const now = at?.map(one => one.toFixed(4)).join() ?? "";
      if (hand || now === stood) return;
      stood = now;
      view.showTurner(at, {
        part: chosen.part,
        turned(turn) {
          hand ??= inHand.value;
          last = turn;
          if (hand) tryPose(turnedPart(hand.frame, chosen.part, turn));
        },
        ended(kept) {
          if (kept && hand && last) keepPose(hand, turnedPart(hand.frame, chosen.part, last), label, null);
          dropPose();
          hand = last = null;
        },
      });
    };
    view.drawn.add(follow);
    follow();
    return () => {
      view.drawn.delete(follow);
      view.showTurner(null, null);
    };
  }, [view, chosen]);
  const key = (event: KeyboardEvent, part: Part, name: string) => {
    const turn = turnOf(event);
    const hand = inHand.value;
    if (!turn || !hand) return;
    event.preventDefault();
    event.stopPropagation();
    const label = `Turn the ${name.toLowerCase()}`;
    keepPose(hand, turnedPart(hand.frame, part, turn), label, label);
  };
  return <div class="handles" role="group" aria-label="Parts of the pose to turn" ref={place}>
    {spots.map(({part, name}) => <button type="button" key={part} class={`handle turn ${part}`} aria-pressed={turning.value === part} aria-label={`Turn: ${name}`}
        title={`${name}: press, then drag a ring; or arrow keys, with Shift sideways`} onClick={() => { turning.value = part; }} onFocus={() => { turning.value = part; }}
        onKeyDown={event => key(event, part, name)} onBlur={settle} />)}
  </div>;
}
