// Work that was not yet sent when the page was left: it is there again when the same window opens the same trial.
import type {Done} from "./edits.ts";

const place = "deixis-session-unsent";

export interface Unsent { readonly name: string; readonly project: unknown; readonly done: readonly Done[]; readonly generated: number }

export function keepUnsent(work: Unsent): void {
  try {
    sessionStorage.setItem(place, JSON.stringify(work));
  } catch {
    // There is no room: the server has what was there a second ago.
  }
}

// `name`: of the trial.
export function takeUnsent(name: string): Unsent | null {
  try {
    const kept = JSON.parse(sessionStorage.getItem(place) ?? "null") as Unsent | null;
    sessionStorage.removeItem(place);
    return kept?.name === name ? kept : null;
  } catch {
    return null;
  }
}
