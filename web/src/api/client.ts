// The server's routes, version 1. What an answer must have is checked here, once.
import {fps, numbersPerFrame, type Accent, type Frame, type Tracks, type Word} from "../model/document.ts";

export interface Health { readonly version: string; readonly systems: readonly string[]; readonly voices: readonly string[]; readonly synthetic: boolean }

export interface LibraryMotion {
  readonly id: string;
  readonly name: string;
  readonly meaning: string;
  readonly class: string;
  readonly frames: readonly Frame[];
  readonly own: boolean;
}

export interface GenerateRequest {
  readonly speech_id: string;
  readonly seed: number;
  readonly format: "json";
  readonly exact?: true;
  readonly pose_controls?: readonly {readonly start_frame: number; readonly frames: readonly Frame[]}[];
  readonly style_controls?: readonly {readonly start_frame: number; readonly frame_count: number; readonly speed?: number;
    readonly space?: number; readonly handedness?: number}[];
  readonly keep?: {readonly frames: readonly Frame[]; readonly from_frame: number; readonly to_frame: number};
}

export interface Spoken {
  readonly speech_id: string;
  readonly words: readonly Word[];
  readonly accents: readonly Accent[];
  readonly duration_s: number;
  readonly pitch: readonly number[];
  readonly pitch_fps: number;
  readonly sound: string;
}

export interface Generated {
  readonly frames: readonly Frame[];
  readonly system: string;
  readonly synthetic: boolean;
  readonly tracks: Tracks;
}

export type MotionFormat = "bvh" | "glb" | "csv";

// `field`: what of the request was wrong, where the server says so.
export class ServerError extends Error {
  readonly status: number;
  readonly field: string | null;
  constructor(message: string, status: number, field: string | null) {
    super(message);
    this.status = status;
    this.field = field;
  }
}

async function ask(path: string, request: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, {...request, credentials: "same-origin"});
  } catch {
    throw new ServerError("The studio's server does not answer. Start it again with deixis studio; nothing of your work is lost.", 0, null);
  }
  if (response.ok) return response;
  if (response.status === 401)
    throw new ServerError("This page may no longer speak to the server. Open the address that deixis studio printed.", 401, null);
  const answer = await response.json().catch(() => null) as {error?: {message?: string; field?: string | null}} | null;
  throw new ServerError(answer?.error?.message ?? `The server answered ${response.status} to ${path}.`, response.status, answer?.error?.field ?? null);
}

const post = (path: string, body: unknown): Promise<Response> =>
    ask(path, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body)});

function check(holds: boolean, path: string, what: string): void {
  if (!holds) throw new ServerError(`The server's answer to ${path} lacks ${what}: page and server are of different versions.`, 0, null);
}

export async function health(): Promise<Health> {
  return await (await ask("/v1/health")).json() as Health;
}

export async function generate(request: GenerateRequest): Promise<Generated> {
  const path = "/v1/generate";
  const answer = await (await post(path, request)).json() as Generated & {fps: number};
  check(answer.fps === fps, path, `motion at ${fps} frames a second`);
  check(Array.isArray(answer.frames) && answer.frames.length > 0 && answer.frames.every(frame => frame.length === numbersPerFrame), path, "frames");
  check(answer.tracks?.rotations?.length === answer.frames.length &&
      answer.tracks.rotations.every(row => row.length === 4 * answer.tracks.bones.length), path, "the avatar's tracks");
  return answer;
}

// By a voice, or as recorded.
export async function speak(request: {text: string; voice?: string} | {text: string; sound: Blob}): Promise<Spoken> {
  const path = "/v1/speech";
  let response: Response;
  if ("sound" in request) {
    const form = new FormData();
    form.append("text", request.text);
    form.append("sound", request.sound, "recording.wav");
    response = await ask(path, {method: "POST", body: form});
  } else {
    response = await post(path, request);
  }
  const answer = await response.json() as Spoken;
  check(typeof answer.speech_id === "string" && answer.duration_s > 0 && Array.isArray(answer.words) && Array.isArray(answer.accents) &&
      Array.isArray(answer.pitch), path, "words, accents and pitch");
  return answer;
}

export async function soundOf(path: string): Promise<ArrayBuffer> {
  check(path.startsWith("/v1/"), "/v1/speech", "a sound of its own");
  return (await ask(path)).arrayBuffer();
}

export async function motions(): Promise<LibraryMotion[]> {
  const {motions: all} = await (await ask("/v1/motions")).json() as {motions: LibraryMotion[]};
  check(Array.isArray(all) && all.every(one => one.id && one.name && one.frames?.length > 0), "/v1/motions", "motions");
  return all;
}

export async function tracksOf(frames: readonly Frame[]): Promise<Tracks> {
  const {tracks} = await (await post("/v1/tracks", {frames})).json() as {tracks: Tracks};
  check(tracks?.rotations?.length === frames.length && tracks.rotations.every(row => row.length === 4 * tracks.bones.length), "/v1/tracks", "tracks");
  return tracks;
}

export async function exportMotion(request: {frames: readonly Frame[]; duration_s: number; format: MotionFormat}): Promise<ArrayBuffer> {
  return (await post("/v1/export", request)).arrayBuffer();
}
