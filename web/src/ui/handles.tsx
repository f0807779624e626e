// Handles on the avatar's joints, for the pose in hand: dragged over the picture, or moved by the arrow keys.
import {useEffect, useRef} from "preact/hooks";
import type {Frame} from "../model/document.ts";
import {posed, type Arm, type Handle, type Point} from "../model/posing.ts";
import {dropPose, inHand, keepPose, tryPose} from "../state/posing.ts";
import {settle} from "../state/store.ts";
import type {AvatarView} from "../view/avatar_view.ts";

const handles: readonly {readonly handle: Handle; readonly bone: string; readonly name: string}[] = [
  {handle: "head", bone: "head", name: "Head"},
  {handle: "rightElbow", bone: "rightLowerArm", name: "Right elbow"},
  {handle: "rightWrist", bone: "rightHand", name: "Right wrist"},
  {handle: "leftElbow", bone: "leftLowerArm", name: "Left elbow"},
  {handle: "leftWrist", bone: "leftHand", name: "Left wrist"},
];
const step_px = 6;
const step_m = 0.02;

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
    const from = placeOf(view, handle, bone);
    const neck = view.place("neck");
    if (event.button !== 0 || !hand || !from || !neck) return;
    const button = event.currentTarget as HTMLElement;
    button.setPointerCapture(event.pointerId);
    const arm = armOf(view, handle);
    const stop = new AbortController();
    const {clientX, clientY} = event;
    let last: Frame | null = null;
    button.addEventListener("pointermove", next => {
      last = posed(hand.frame, handle, view.shifted(from, next.clientX - clientX, clientY - next.clientY), arm, neck);
      tryPose(last);
    }, {signal: stop.signal});
    const end = (kept: boolean) => {
      stop.abort();
      if (kept && last) keepPose(hand, last, label, null);
      dropPose();
    };
    button.addEventListener("pointerup", () => end(true), {signal: stop.signal});
    button.addEventListener("pointercancel", () => end(false), {signal: stop.signal});
    window.addEventListener("keydown", next => {
      if (next.key !== "Escape") return;
      next.stopPropagation();
      end(false);
    }, {signal: stop.signal, capture: true});
  };
  const key = (event: KeyboardEvent) => {
    const far = event.shiftKey && (event.key === "ArrowUp" || event.key === "ArrowDown");
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    const hand = inHand.value;
    const from = placeOf(view, handle, bone);
    const neck = view.place("neck");
    if (!step || !hand || !from || !neck || event.ctrlKey) return;
    event.preventDefault();
    event.stopPropagation();
    const target = far ? view.shifted(from, 0, 0, -step_m * step[1]!) : view.shifted(from, step_px * step[0]!, step_px * step[1]!);
    keepPose(hand, posed(hand.frame, handle, target, armOf(view, handle), neck), label, `${label} ${hand.control.id}`);
  };
  return <button type="button" class={`handle ${handle}`} aria-label={`${name} of the pose`} title={`${name}: drag, or arrow keys; Shift+↑↓ away and near`}
      onPointerDown={press} onKeyDown={key} onBlur={settle} />;
}

export function Handles({view}: {view: AvatarView}) {
  const place = useRef<HTMLDivElement>(null);
  const shown = inHand.value !== null;
  useEffect(() => {
    const put = () => handles.forEach(({handle, bone}, k) => {
      const button = place.current?.children[k] as HTMLElement | undefined;
      const at = placeOf(view, handle, bone);
      if (!button || !at) return;
      const {x, y} = view.seen(at);
      button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    });
    view.onDrawn = put;
    put();
    return () => { view.onDrawn = () => {}; };
  }, [view, shown]);
  return <div class="handles" role="group" aria-label="Joints of the pose" ref={place} hidden={!shown}>
    {shown && handles.map(one => <HandleButton key={one.handle} view={view} {...one} />)}
  </div>;
}
