// Frames out of a file: a project, or what the server answers as JSON. Nothing else is read here.
import {numbersPerFrame, type Frame} from "./document.ts";
import {isFrame} from "./frames.ts";
import {projectOf, ProjectError} from "./project.ts";

export interface Clip { readonly frames: readonly Frame[]; readonly from: number; readonly to: number }  // the part that is wanted

export const mostFrames = 300;

// Throws a ProjectError.
export function clipOf(json: string): Clip {
  let parsed: unknown;
  try {
    parsed = JSON.parse(json);
  } catch {
    throw new ProjectError("This file is not JSON. A project of the studio is read, and an answer of the server with frames.");
  }
  const file = (parsed ?? {}) as {format?: unknown; frames?: unknown; fps?: unknown};
  if (file.format !== undefined && file.frames === undefined) {
    const {motion, range} = projectOf(parsed);
    if (!motion) throw new ProjectError("This project has no motion yet.");
    return {frames: motion.frames, from: range?.from ?? 0, to: range?.to ?? Math.min(mostFrames, motion.frames.length)};
  }
  const frames = Array.isArray(parsed) ? parsed : file.frames;
  if (!Array.isArray(frames) || frames.length === 0) throw new ProjectError("This file has no frames.");
  if (file.fps !== undefined && file.fps !== 15) throw new ProjectError(`This file has ${String(file.fps)} frames a second; 15 are read.`);
  frames.forEach((frame, k) => {
    if (!isFrame(frame)) throw new ProjectError(`Frame ${k + 1} of this file should be ${numbersPerFrame} numbers, the directions of nine bones.`);
  });
  return {frames, from: 0, to: Math.min(mostFrames, frames.length)};
}
