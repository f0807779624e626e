// Handles on the avatar's joints, for the pose in hand: moved, or turned by rings.
import {useRef} from "preact/hooks";
import {posed, type Arm, type Handle, type Point} from "../model/posing.ts";
import {dropPose, handling, inHand, keepPose, tryPose} from "../state/posing.ts";
import {ball} from "../state/stage.ts";
import {settle} from "../state/store.ts";
import type {AvatarView} from "../view/avatar_view.ts";
import {pressToMove, steppedByKey} from "./moving.ts";
import {useSpots} from "./spots.ts";
import {TurnHandles} from "./turn_handles.tsx";

const handles: readonly {readonly handle: Handle; readonly bone: string; readonly name: string}[] = [
  {handle: "head", bone: "head", name: "Head"},
  {handle: "rightElbow", bone: "rightLowerArm", name: "Right elbow"},
  {handle: "rightWrist", bone: "rightHand", name: "Right wrist"},
  {handle: "leftElbow", bone: "leftLowerArm", name: "Left elbow"},
  {handle: "leftWrist", bone: "leftHand", name: "Left wrist"},
];

function armOf(view: AvatarView, handle: Handle): Arm | null {
  const side = handle.startsWith("left") ? "left" : "right";
  const [shoulder, elbow, wrist] = [view.place(`${side}UpperArm`), view.place(`${side}LowerArm`), view.place(`${side}Hand`)];
  return shoulder && elbow && wrist && {shoulder, elbow, wrist};
}

// Above the head's joint lies the part of it that is taken hold of.
function placeOf(view: AvatarView, handle: Handle, bone: string): Point | null {
  const at = view.place(bone);
  if (!at || handle !== "head") return at;
  const neck = view.place("neck");
  return neck ? [at[0] + 1.4 * (at[0] - neck[0]), at[1] + 1.4 * (at[1] - neck[1]), at[2] + 1.4 * (at[2] - neck[2])] : at;
}

function HandleButton({view, handle, bone, name}: {view: AvatarView; handle: Handle; bone: string; name: string}) {
  const label = `Move the ${name.toLowerCase()}`;
  const press = (event: PointerEvent) => {
    const hand = inHand.value;
    const neck = view.place("neck");
    const arm = armOf(view, handle);
    if (!hand || !neck) return;
    const to = (target: Point) => posed(hand.frame, handle, target, arm, neck);
    pressToMove(event, view, {from: () => placeOf(view, handle, bone), tried: target => tryPose(to(target)),
      kept: target => keepPose(hand, to(target), label, null), dropped: dropPose});
  };
  const key = (event: KeyboardEvent) => {
    const hand = inHand.value;
    const from = placeOf(view, handle, bone);
    const neck = view.place("neck");
    const target = hand && from && neck && steppedByKey(event, view, from);
    if (target) keepPose(hand, posed(hand.frame, handle, target, armOf(view, handle), neck), label, label);
  };
  return <button type="button" class={`handle ${handle}`} aria-label={`${name} of the pose`} title={`${name}: drag, or arrow keys; Shift+↑↓ away and near`}
      onPointerDown={press} onKeyDown={key} onBlur={settle} />;
}

function MoveHandles({view}: {view: AvatarView}) {
  const place = useRef<HTMLDivElement>(null);
  useSpots(view, place, handles.map(({handle, bone}) => () => placeOf(view, handle, bone)));
  return <div class="handles" role="group" aria-label="Joints of the pose" ref={place}>
    {handles.map(one => <HandleButton key={one.handle} view={view} {...one} />)}
  </div>;
}

export function Handles({view}: {view: AvatarView}) {
  if (inHand.value === null || ball.value) return null;  // the ball is in the way of joints
  return handling.value === "move" ? <MoveHandles view={view} /> : <TurnHandles view={view} />;
}
