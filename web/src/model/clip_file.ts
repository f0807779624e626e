// Frames out of a file: a project, or what the server answers as JSON. Other files are the server's to read.
import {numbersPerFrame, type Frame} from "./document.ts";
import {isFrame} from "./frames.ts";
import {projectOf, ProjectError} from "./project.ts";

export interface Clip { readonly frames: readonly Frame[]; readonly from: number; readonly to: number }  // the part that is wanted

export const mostFrames = 300;

function parsedOf(json: string): unknown {
  try {
    return JSON.parse(json) as unknown;
  } catch {
    return undefined;
  }
}

// Whether a file is one of those that are read here, whatever is wrong with it.
export function isOurs(json: string): boolean {
  const parsed = parsedOf(json) as {format?: unknown; frames?: unknown} | null | undefined;
  return parsed?.format === "deixis-studio" || Array.isArray(parsed?.frames ?? parsed);
}

// Of frames, the part that a gesture may have.
export const wholeClip = (frames: readonly Frame[]): Clip => ({frames, from: 0, to: Math.min(mostFrames, frames.length)});

// Throws a ProjectError.
export function clipOf(json: string): Clip {
  const parsed = parsedOf(json);
  if (parsed === undefined) throw new ProjectError("This file is not JSON. A project of the studio is read, and an answer of the server with frames.");
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
  return wholeClip(frames);
}
