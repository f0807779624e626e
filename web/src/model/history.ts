// One list of patches is undo, the journal that survives a crash, and the log of edits.
import {applyPatches, enablePatches, produceWithPatches, type Draft, type Patch} from "immer";
import type {StudioDocument} from "./document.ts";

enablePatches();

export interface Edit {
  readonly label: string;
  readonly at: string;  // ISO 8601
  readonly patches: readonly Patch[];
  readonly inverse: readonly Patch[];
  readonly merge: string | null;  // edits in a row with the same word, without a pause, are undone together: a slider's
}

export interface History {
  readonly document: StudioDocument;
  readonly edits: readonly Edit[];
  readonly position: number;  // edits before it are done, those behind it undone
}

export type Step = {readonly kind: "edit"; readonly edit: Edit} | {readonly kind: "undo" | "redo"; readonly at: string};

export const startOf = (document: StudioDocument): History => ({document, edits: [], position: 0});

const pause_ms = 3000;

// What a recipe changes, as a step; null where that is nothing.
export function stepOf(document: StudioDocument, label: string, at: string, merge: string | null,
    recipe: (draft: Draft<StudioDocument>) => Draft<StudioDocument> | void): Step | null {
  const [, patches, inverse] = produceWithPatches(document, recipe);
  return patches.length === 0 ? null : {kind: "edit", edit: {label, at, patches, inverse, merge}};
}

export const canUndo = (history: History): boolean => history.position > 0;
export const canRedo = (history: History): boolean => history.position < history.edits.length;

// The history after a step; itself where there is nothing to undo or redo.
export function advanced(history: History, step: Step): History {
  const {document, edits, position} = history;
  if (step.kind === "edit") {
    const kept = edits.slice(0, position);
    const last = kept.at(-1);
    const {edit} = step;
    const together = last && edit.merge !== null && last.merge === edit.merge && position === edits.length &&
        Date.parse(edit.at) - Date.parse(last.at) < pause_ms;
    if (together)
      kept[kept.length - 1] = {...edit, patches: [...last.patches, ...edit.patches], inverse: [...edit.inverse, ...last.inverse]};
    else
      kept.push(edit);
    return {document: applyPatches(document, edit.patches), edits: kept, position: kept.length};
  }
  if (step.kind === "undo") {
    if (!canUndo(history)) return history;
    return {document: applyPatches(document, edits[position - 1]!.inverse), edits, position: position - 1};
  }
  if (!canRedo(history)) return history;
  return {document: applyPatches(document, edits[position]!.patches), edits, position: position + 1};
}
