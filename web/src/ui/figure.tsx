// A pose as a small drawing: the figure from the front, seen a little from above.
import type {Frame} from "../model/document.ts";
import {jointsOf} from "../model/frames.ts";

// By places of joints: spine 0, neck 1, nose 2, head 3, left arm 4-6, right arm 7-9.
const arms = [[4, 5, 6], [7, 8, 9]];
const hands = [6, 9];

const width = 132;
const height = 112;

// Metres to the picture's units; what is nearer is drawn a little lower.
function pointsOf(frame: Frame): [number, number][] {
  return jointsOf(frame).map(([x, y, z]) => [width / 2 + 88 * x, 72 - 88 * (y - 0.16 * z)]);
}

export function Figure({frame}: {frame: Frame}) {
  const at = pointsOf(frame);
  const words = (points: readonly (readonly number[])[]) => points.map(point => point.map(one => one.toFixed(1)).join(",")).join(" ");
  const [spine, neck, head, left, right] = [at[0]!, at[1]!, at[3]!, at[4]!, at[7]!];
  // Shoulders drawn narrower than they are, and a waist.
  const shoulder = (one: readonly number[]) => [neck[0] + 0.78 * (one[0]! - neck[0]), one[1]! + 3];
  const waist = (side: number) => [spine[0] + 9 * side, spine[1] + 33];
  return <svg class="figure" viewBox={`-8 -18 ${width + 16} ${height + 18}`} aria-hidden="true">
    <polygon class="torso" points={words([shoulder(left), shoulder(right), waist(-1), waist(1)])} />
    <circle class="head" cx={0.35 * neck[0] + 0.65 * head[0]} cy={0.35 * neck[1] + 0.65 * head[1]} r={12} />
    {arms.map((arm, k) => <polyline key={k} class={k === 0 ? "arm left" : "arm right"} points={words(arm.map(joint => at[joint]!))} />)}
    {hands.map((hand, k) => <circle key={hand} class={k === 0 ? "hand left" : "hand right"} cx={at[hand]![0]} cy={at[hand]![1]} r={6.5} />)}
  </svg>;
}
