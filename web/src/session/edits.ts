// What was done to a project since work was last sent, as the session records it.
import type {Patch} from "immer";
import type {SentEdit} from "../api/session.ts";
import type {History, Step} from "../model/history.ts";

export interface Done { readonly at_s: number; readonly what: string; readonly patch: readonly Patch[]; readonly merge: string | null }

// A motion is made anew of the project: what it is of says enough.
function told(patch: Patch): Patch {
  if (patch.path[0] !== "motion") return patch;
  const motion = patch.value as {madeFrom?: string; system?: string} | null | undefined;
  return {op: patch.op, path: ["motion"], value: motion ? {madeFrom: motion.madeFrom, system: motion.system} : null};
}

// `after`: the history with the step done.
export function doneBy(step: Step, after: History, at_s: number): Done {
  const undone = after.edits[after.position];
  const redone = after.edits[after.position - 1];
  const [what, patches] = step.kind === "edit" ? [step.edit.label, step.edit.patches]
      : step.kind === "undo" ? [`Undo: ${undone?.label ?? ""}`, undone?.inverse ?? []] : [`Redo: ${redone?.label ?? ""}`, redone?.patches ?? []];
  return {at_s, what, patch: patches.map(told), merge: step.kind === "edit" ? step.edit.merge : null};
}

const pathsOf = ({patch}: Done) => JSON.stringify(patch.map(({op, path}) => [op, path]));

// With one more: steps of one movement (a slider's) that set the same become the last of them.
export function gathered(all: readonly Done[], next: Done): readonly Done[] {
  const last = all.at(-1);
  const together = last && next.merge !== null && next.merge === last.merge && pathsOf(next) === pathsOf(last);
  return together ? [...all.slice(0, -1), next] : [...all, next];
}

export const isGenerated = (step: Step): boolean => step.kind === "edit" && step.edit.patches.some(({path}) => path[0] === "motion");

export const sent = ({at_s, what, patch}: Done): SentEdit => ({at_s: Math.round(1000 * at_s) / 1000, what, patch});
