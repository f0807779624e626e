// The server's routes, version 1. What an answer must have is checked here, once.
import {ask, check, post} from "./ask.ts";
import type {SessionOf} from "./session.ts";
import {fps, numbersPerFrame, type Accent, type Frame, type Tracks, type Word} from "../model/document.ts";

export interface Voice { readonly name: string; readonly language: string | null }

// One way of making gestures, and which of the request's fields it takes.
export interface System { readonly system: string; readonly takes: readonly string[] }

export interface Health {
  readonly version: string;
  readonly voices: readonly Voice[];
  readonly gestures: readonly System[];  // none: an older server, which has no choice
  readonly folder: boolean;  // whether it keeps gestures, rules and projects
  readonly session: SessionOf | null;  // the study's session that it runs
}

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
  readonly system?: string;
  readonly exact?: true;
  readonly fade?: true;
  readonly still?: true;
  readonly relaxed_fingers?: boolean;
  readonly variety?: number;
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

// An older server names its voices only, and says nothing of systems and folders.
export async function health(): Promise<Health> {
  const answer = await (await ask("/v1/health")).json() as {version: string; voices?: (string | {name: string; language?: string})[];
    gestures?: System[]; folder?: boolean; session?: SessionOf};
  const voices = (answer.voices ?? []).map(one => typeof one === "string" ? {name: one, language: null} : {name: one.name, language: one.language ?? null});
  return {version: answer.version, voices, gestures: answer.gestures ?? [], folder: answer.folder ?? false, session: answer.session ?? null};
}

// The routes that the server's own document lists, as "GET /v1/motions/{}".
export async function routes(): Promise<Set<string>> {
  const {paths} = await (await ask("/v1/openapi.json")).json() as {paths?: Record<string, Record<string, unknown>>};
  return new Set(Object.entries(paths ?? {}).flatMap(([path, methods]) =>
      Object.keys(methods).map(method => `${method.toUpperCase()} ${path.replace(/\{[^}]*\}/g, "{}")}`)));
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

// A file in the server's folder that cannot be read, and why. The others are there.
export interface Damaged { readonly file: string; readonly problem: string }

export async function motions(): Promise<{motions: LibraryMotion[]; damaged: readonly Damaged[]}> {
  const {motions: all, damaged = []} = await (await ask("/v1/motions")).json() as {motions: LibraryMotion[]; damaged?: Damaged[]};
  check(Array.isArray(all) && all.every(one => one.id && one.name && one.frames?.length > 0), "/v1/motions", "motions");
  return {motions: all, damaged};
}

export async function tracksOf(frames: readonly Frame[], relaxed: boolean | null = null): Promise<Tracks> {
  const {tracks} = await (await post("/v1/tracks", {frames, ...(relaxed !== null && {relaxed_fingers: relaxed})})).json() as {tracks: Tracks};
  check(tracks?.rotations?.length === frames.length && tracks.rotations.every(row => row.length === 4 * tracks.bones.length), "/v1/tracks", "tracks");
  return tracks;
}

export async function exportMotion(request: {frames: readonly Frame[]; duration_s: number; format: MotionFormat; relaxed_fingers?: boolean}): Promise<ArrayBuffer> {
  return (await post("/v1/export", request)).arrayBuffer();
}
