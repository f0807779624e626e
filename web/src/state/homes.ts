// Which projects of the server this window has, at which revision, and whether another window has the same one.
import {effect, untracked} from "@preact/signals";
import {complain} from "./messages.ts";
import {keepsProjects} from "./server.ts";
import {studioDocument} from "./store.ts";

const revisions = "deixis-studio-revisions";
const read = (kept: Storage): Record<string, string> => {
  try {
    return JSON.parse(kept.getItem(revisions) ?? "{}") as Record<string, string>;
  } catch {
    return {};
  }
};
const put = (kept: Storage, id: string, revision: string | null): void => {
  const {[id]: _, ...rest} = read(kept);
  kept.setItem(revisions, JSON.stringify(revision === null ? rest : {...rest, [id]: revision}));
};

let alone = true;  // no other window has the project

// Each window has its own: another one's save must not look like ours. The first one's is there after it was closed, too.
export const revisionOf = (id: string): string | null => read(sessionStorage)[id] ?? read(localStorage)[id] ?? null;
export function keepRevision(id: string, revision: string | null): void {
  put(sessionStorage, id, revision);
  if (alone || revision === null) put(localStorage, id, revision);
}

// While a project is open, its name is taken; who comes second is told. Called once.
export function watchHomes(): void {
  let held: string | null = null;
  let free = () => {};
  effect(() => {
    const id = keepsProjects.value ? studioDocument.value.home : null;
    if (id === held) return;
    held = id;
    untracked(() => {
      free();
      free = () => {};
      alone = id === null;
      if (id === null) return;
      void navigator.locks.request(`deixis-studio-project-${id}`, {ifAvailable: true}, lock => {
        alone = lock !== null;
        if (lock === null) {
          complain("This project is open in another window, too. Who saves second is asked what to do; nothing is lost.");
          return undefined;
        }
        const revision = read(sessionStorage)[id];
        if (revision !== undefined) put(localStorage, id, revision);
        return held === id ? new Promise<void>(resolve => { free = resolve; }) : undefined;
      });
    });
  });
}
