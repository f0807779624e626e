// The one store: the document with its history, and what the page shows of it. Whatever changes the document goes through
// edit(), undo() and redo().
import {batch, computed, signal} from "@preact/signals";
import type {Draft} from "immer";
import {advanced, canRedo, canUndo, startOf, stepOf, type History, type Step} from "../model/history.ts";
import {emptyDocument, fps, frameCount, type StudioDocument} from "../model/document.ts";
import {allControls} from "../model/controls.ts";
import type {LogLine} from "../model/project.ts";

export const history = signal<History>(startOf(emptyDocument));
export const studioDocument = computed(() => history.value.document);
export const undoable = computed(() => canUndo(history.value) ? history.value.edits[history.value.position - 1]!.label : null);
export const redoable = computed(() => canRedo(history.value) ? history.value.edits[history.value.position]!.label : null);

let lines: LogLine[] = [];
const listeners: ((step: Step) => void)[] = [];

// The edits of this window, in order, for the project's file.
export const logOfEdits = (): readonly LogLine[] => lines;
// Called with each step after it is done; how a project is begun is none.
export function onStep(listener: (step: Step) => void): void { listeners.push(listener); }

function take(step: Step): void {
  const before = history.value;
  const after = advanced(before, step);
  if (after === before) return;
  history.value = after;
  const label = step.kind === "edit" ? step.edit.label : before.edits[Math.min(before.position, after.position)]!.label;
  lines.push({at: step.kind === "edit" ? step.edit.at : step.at, kind: step.kind, label});
  const ids = new Set(allControls(after.document).map(control => control.id));
  if ([...selection.value].some(id => !ids.has(id))) selection.value = new Set([...selection.value].filter(id => ids.has(id)));
  const end = after.document.speech?.duration_s ?? 0;
  if (playhead.value > end) playhead.value = end;
  for (const listener of listeners) listener(step);
}

// Which row of edits that merge it is: in the steps themselves, so that the journal's lead to the same history.
let row = 0;

// `merge`: edits in a row with the same word become one, until settle().
export function edit(label: string, recipe: (draft: Draft<StudioDocument>) => Draft<StudioDocument> | void, merge: string | null = null): void {
  const step = stepOf(studioDocument.value, label, new Date().toISOString(), merge === null ? null : `${row} ${merge}`, recipe);
  if (step) take(step);
}

// Ends a row of edits that would merge.
export function settle(): void { ++row; }

// A project that is given: nothing leads back behind it.
export function begin(document: StudioDocument): void {
  lines = [];
  settle();
  batch(() => {
    history.value = startOf(document);
    selection.value = new Set();
    playhead.value = 0;
    ++beginnings.value;
  });
}
export const beginnings = signal(0);  // what was asked for before one is not for the project that is there now

// Each says what it undid or did again, null where there was nothing.
export function undo(): string | null {
  const label = undoable.value;
  if (label !== null) take({kind: "undo", at: new Date().toISOString()});
  return label;
}
export function redo(): string | null {
  const label = redoable.value;
  if (label !== null) take({kind: "redo", at: new Date().toISOString()});
  return label;
}

// What the page shows, which no project keeps.
export const selection = signal<ReadonlySet<string>>(new Set());
export const playhead = signal(0);  // seconds
export const playing = signal(false);
export const looping = signal(false);
export const muted = signal(false);
export const snapping = signal(true);
export const zoom = signal(1);  // 1: all of the speech is in sight
export const busy = signal<string | null>(null);  // what is being waited for

export const duration = computed(() => studioDocument.value.speech?.duration_s ?? 0);
export const totalFrames = computed(() => frameCount(studioDocument.value));
export const playheadFrame = computed(() => Math.min(Math.max(0, totalFrames.value - 1), Math.floor(playhead.value * fps + 1e-6)));
export const selected = computed(() => allControls(studioDocument.value).filter(control => selection.value.has(control.id)));

export const select = (...ids: string[]): void => { selection.value = new Set(ids); };

export const newId = (): string => crypto.randomUUID();
