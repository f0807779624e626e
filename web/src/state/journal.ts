// The steps since the project was begun, kept by the browser as they are done: a reload, a crash or a server that has gone
// loses none of them. One window keeps them; a second one is told.
import {advanced, startOf, type History, type Step} from "../model/history.ts";
import {emptyDocument, type StudioDocument} from "../model/document.ts";
import {history, onStep} from "./store.ts";
import {complain} from "./messages.ts";

const name = "deixis-studio";
const stepsKept = 300;

function done<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

async function opened(): Promise<IDBDatabase> {
  const request = indexedDB.open(name, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore("base");
    request.result.createObjectStore("steps", {autoIncrement: true});
  };
  return done(request);
}

// The lock is held until this window closes.
function isOnlyWindow(): Promise<boolean> {
  return new Promise(resolve => {
    void navigator.locks.request(name, {ifAvailable: true}, lock => {
      resolve(lock !== null);
      return lock ? new Promise<void>(() => {}) : undefined;
    });
  });
}

function restored(base: StudioDocument | undefined, steps: readonly Step[]): History | null {
  if (!base) return null;
  let state = startOf({...emptyDocument, ...base});  // an older page kept less
  for (const step of steps) state = advanced(state, step);
  return state;
}

// Brings back what was there, and keeps what is done from now on. Whether there was anything.
export async function keepJournal(): Promise<boolean> {
  try {
    if (!await isOnlyWindow()) {
      complain("The studio is open in another window, which keeps your edits. What you do in this one is lost when it closes, unless you save it.");
      return false;
    }
    const database = await opened();
    const stores = (mode: IDBTransactionMode) => {
      const transaction = database.transaction(["base", "steps"], mode);
      return {base: transaction.objectStore("base"), steps: transaction.objectStore("steps")};
    };
    const reading = stores("readonly");
    const [base, steps] = await Promise.all([done<StudioDocument | undefined>(reading.base.get("document")), done<Step[]>(reading.steps.getAll())]);
    // Whoever was quicker than this keeps what they have begun.
    const before = history.value.edits.length === 0 ? restored(base, steps) : null;
    if (before) history.value = before;
    if (!before || steps.length > stepsKept) {
      const writing = stores("readwrite");
      writing.base.put(history.value.document, "document");
      writing.steps.clear();
    }
    onStep(step => {
      stores("readwrite").steps.add(step).onerror = () =>
          complain("The browser cannot keep your edits any longer: save the project.");
    });
    return before !== null && before.document.text !== "";
  } catch (problem) {
    complain(`The browser does not keep your edits: save the project before you close it. (${problem instanceof Error ? problem.message : String(problem)})`);
    return false;
  }
}
