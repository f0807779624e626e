// A study's session that the server runs: what is on now, and what the participant does there.
import {ask, check, post, send} from "./ask.ts";

export interface SessionOf { readonly participant: string; readonly study: string; readonly language: string }

// Metres from the board's lower left corner, y up: x, y, width, height.
export type Box = readonly [x: number, y: number, width: number, height: number];

// `size_m`: the height of a line. Texts are laid out: a line feed ends each line.
export interface BoardText { readonly box: Box; readonly text: string; readonly size_m: number; readonly bold: boolean; readonly centred: boolean;
  readonly faint: boolean; readonly level: boolean }
export interface BoardButton { readonly box: Box; readonly label: string; readonly caption: string; readonly id: number; readonly enabled: boolean;
  readonly chosen: boolean; readonly role: "go_on" | "leave" | "play" | "option" | "other" }
// `value`: null until it is touched.
export interface BoardSlider { readonly box: Box; readonly track: Box; readonly id: number; readonly low: number; readonly high: number;
  readonly value: number | null; readonly labels: readonly string[]; readonly label_size_m: number; readonly enabled: boolean }
export interface BoardField { readonly box: Box; readonly id: number; readonly text: string; readonly hint: string; readonly active: boolean; readonly enabled: boolean }

export interface Board {
  readonly width_m: number;
  readonly height_m: number;
  readonly progress: number | null;  // 0 to 1
  readonly texts: readonly BoardText[];
  readonly buttons: readonly BoardButton[];
  readonly sliders: readonly BoardSlider[];
  readonly fields: readonly BoardField[];
}

export interface Task {
  readonly trial: number;  // 1.. of its stage
  readonly of: number;
  readonly practice: boolean;
  readonly system: string;
  readonly keyframes_only: boolean;
  readonly question: string;
  readonly project: unknown;  // what to start from, or to go on with
  readonly limit_s: number;
  readonly left_s: number;
  readonly may_end_early: boolean;
}

export interface SessionNow {
  readonly revision: number;
  readonly state: string;
  readonly stage: string;
  readonly notice: string;
  readonly over: boolean;
  readonly panel: Board | null;
  readonly authoring: Task | null;
}

// What was done since the last work that was sent, or what was undone.
export interface SentEdit { readonly at_s: number; readonly what: string; readonly patch: readonly unknown[] }
export interface Work { readonly trial: number; readonly project: object; readonly edits: readonly SentEdit[]; readonly generated: number }

const path = "/v1/session";

// At once where the present revision is another one than `after`, else when it changes, or after ten seconds.
export async function sessionNow(after: number | null, stop: AbortSignal): Promise<SessionNow> {
  const answer = await (await ask(after === null ? path : `${path}?after=${after}`, {signal: stop})).json() as SessionNow;
  check(typeof answer.revision === "number" && answer.panel !== undefined && answer.authoring !== undefined, path, "a board or a task");
  return answer;
}

// Each is refused with 409 where the board, or the trial, is another one meanwhile.
const revisionOf = async (answer: Promise<Response>): Promise<number> => (await (await answer).json() as {revision: number}).revision;
export const press = (revision: number, button: number): Promise<number> => revisionOf(post(`${path}/press`, {revision, button}));
export const slide = (revision: number, slider: number, value: number): Promise<number> => revisionOf(post(`${path}/slide`, {revision, slider, value}));
export const type = (revision: number, field: number, text: string): Promise<number> => revisionOf(post(`${path}/type`, {revision, field, text}));
export const finish = (work: Work): Promise<number> => revisionOf(post(`${path}/finish`, work));
export const pauseSession = (): Promise<number> => revisionOf(post(`${path}/pause`, {}));

export async function putWork(work: Work): Promise<number> {
  return (await (await send("PUT", `${path}/work`, work)).json() as {left_s: number}).left_s;
}
