// Poses as nine directions: mirrored, resampled, and as points to draw.
import {fps, numbersPerFrame, type Frame} from "./document.ts";

type Vec3 = [number, number, number];

const bones = numbersPerFrame / 3;
// The other side's bone of each; the middle's are their own.
const otherSide = [0, 1, 2, 6, 7, 8, 3, 4, 5];

const direction = (frame: Frame, bone: number): Vec3 =>
    [frame[3 * bone] ?? 0, frame[3 * bone + 1] ?? 0, frame[3 * bone + 2] ?? 0];

// Left and right change sides.
export function mirrored(frame: Frame): Frame {
  const out: number[] = [];
  for (const bone of otherSide) {
    const [x, y, z] = direction(frame, bone);
    out.push(x === 0 ? 0 : -x, y, z);
  }
  return out;
}

// Along the arc between both directions; opposite ones have none, and jump in the middle.
function between(a: Vec3, b: Vec3, t: number): Vec3 {
  const dot = Math.min(1, Math.max(-1, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]));
  const angle = Math.acos(dot);
  if (angle < 1e-6) return a;
  if (Math.PI - angle < 1e-6) return t < 0.5 ? a : b;
  const [p, q] = [Math.sin((1 - t) * angle) / Math.sin(angle), Math.sin(t * angle) / Math.sin(angle)];
  return [p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]];
}

export function interpolated(a: Frame, b: Frame, t: number): Frame {
  if (t <= 0) return a;
  if (t >= 1) return b;
  const out: number[] = [];
  for (let bone = 0; bone < bones; ++bone) out.push(...between(direction(a, bone), direction(b, bone), t));
  return out;
}

// The same poses in `length` frames, the first and the last kept. One pose is held.
export function resampled(frames: readonly Frame[], length: number): Frame[] {
  const last = frames.length - 1;
  return Array.from({length}, (_, k) => {
    const at = length === 1 ? 0 : k * last / (length - 1);
    const low = Math.min(Math.floor(at), last);
    return interpolated(frames[low]!, frames[Math.min(low + 1, last)]!, at - low);
  });
}

// How many frames these poses take at one, two or three times their speed.
export const lengthAtSpeed = (count: number, speed: number): number => Math.max(1, Math.round(count / speed));

export const isFrame = (value: unknown): value is Frame =>
    Array.isArray(value) && value.length === numbersPerFrame && value.every(number => Number.isFinite(number));

// Joints of a drawn figure in metres from the spine, by the bones that lead to them (Yoon et al. 2021).
const ends: readonly (readonly [from: number, length: number])[] =
    [[-1, 0.26], [0, 0.18], [1, 0.14], [0, 0.22], [3, 0.36], [4, 0.33], [0, 0.22], [6, 0.36], [7, 0.33]];

// Ten points: the spine, then the joint at the end of each bone.
export function jointsOf(frame: Frame): Vec3[] {
  const joints: Vec3[] = [[0, 0, 0]];
  ends.forEach(([from, length], bone) => {
    const start = joints[from + 1]!;
    const [x, y, z] = direction(frame, bone);
    joints.push([start[0] + length * x, start[1] + length * y, start[2] + length * z]);
  });
  return joints;
}

export const secondsOf = (frames: number): number => frames / fps;
export const frameAt = (time_s: number): number => Math.round(time_s * fps);
