// What the server keeps in its folder: gestures of one's own, rules, projects. And where an arm points to.
import type {Frame} from "../model/document.ts";
import {isFrame} from "../model/frames.ts";
import type {Rule} from "../model/rules.ts";
import {ask, check, post, send} from "./ask.ts";
import type {Damaged, LibraryMotion} from "./client.ts";

export async function addMotion(motion: {name: string; meaning?: string; frames: readonly Frame[]}): Promise<LibraryMotion> {
  const made = await (await post("/v1/motions", motion)).json() as LibraryMotion;
  check(typeof made.id === "string" && made.frames?.length > 0, "/v1/motions", "the gesture");
  return made;
}

// The upper body of a clip that another program wrote. Throws a ServerError with words for people.
export async function readMotion(file: File): Promise<{frames: readonly Frame[]; remarks: readonly string[]}> {
  const path = "/v1/motions/read";
  const form = new FormData();
  form.append("name", file.name);
  form.append("clip", file);
  const answer = await (await ask(path, {method: "POST", body: form})).json() as {frames: readonly Frame[]; remarks?: readonly string[]};
  check(Array.isArray(answer.frames) && answer.frames.length > 0 && answer.frames.every(isFrame), path, "frames");
  return {frames: answer.frames, remarks: answer.remarks ?? []};
}

export async function deleteMotion(id: string): Promise<void> {
  await ask(`/v1/motions/${encodeURIComponent(id)}`, {method: "DELETE"});
}

export interface KeptRules { readonly rules: readonly Rule[]; readonly revision: string; readonly damaged: readonly Damaged[] }

export async function rules(): Promise<KeptRules> {
  const answer = await (await ask("/v1/rules")).json() as KeptRules;
  check(Array.isArray(answer.rules) && answer.revision !== undefined, "/v1/rules", "rules");
  return {rules: answer.rules, revision: String(answer.revision), damaged: answer.damaged ?? []};
}

export async function putRules(kept: readonly Rule[], revision: string): Promise<KeptRules> {
  const answer = await (await send("PUT", "/v1/rules", {rules: kept}, revision)).json() as KeptRules;
  return {rules: answer.rules, revision: String(answer.revision), damaged: []};
}

export interface ListedProject { readonly id: string; readonly name: string; readonly saved: string; readonly bytes: number; readonly revision: string }

export async function projects(): Promise<{projects: readonly ListedProject[]; damaged: readonly Damaged[]}> {
  const {projects: all, damaged = []} = await (await ask("/v1/projects")).json() as {projects: ListedProject[]; damaged?: Damaged[]};
  check(Array.isArray(all), "/v1/projects", "projects");
  return {projects: all, damaged};
}

export async function project(id: string): Promise<{name: string; saved: string; revision: string; project: unknown}> {
  const path = `/v1/projects/${encodeURIComponent(id)}`;
  const answer = await (await ask(path)).json() as {name: string; saved: string; revision: string; project: unknown};
  check(answer.project !== undefined && answer.revision !== undefined, path, "the project");
  return {...answer, revision: String(answer.revision)};
}

export async function addProject(name: string, content: unknown): Promise<{id: string; revision: string}> {
  const answer = await (await post("/v1/projects", {name, project: content})).json() as {id: string; revision: string};
  check(typeof answer.id === "string", "/v1/projects", "the project's id");
  return {id: answer.id, revision: String(answer.revision)};
}

export async function putProject(id: string, name: string, content: unknown, revision: string): Promise<string> {
  const answer = await (await send("PUT", `/v1/projects/${encodeURIComponent(id)}`, {name, project: content}, revision)).json() as {revision: string};
  return String(answer.revision);
}

export async function deleteProject(id: string): Promise<void> {
  await ask(`/v1/projects/${encodeURIComponent(id)}`, {method: "DELETE"});
}

export type PointingSide = "auto" | "left" | "right";
export interface Pointed { readonly frame: Frame; readonly side: string; readonly off_deg: number }

export async function point(request: {target_m: readonly number[]; side: PointingSide; pose?: Frame}): Promise<Pointed> {
  const answer = await (await post("/v1/point", request)).json() as Pointed;
  check(isFrame(answer.frame), "/v1/point", "a pose");
  return answer;
}
