// The unit gestures that the server has, searched by the words of their names and meanings.
import {computed, signal} from "@preact/signals";
import {motions, type LibraryMotion} from "../api/client.ts";

export const library = signal<readonly LibraryMotion[] | null>(null);  // null: not there yet
export const libraryProblem = signal<string | null>(null);
export const motionType = "application/x-deixis-motion";  // of a gesture that is dragged
export const searched = signal("");
export const addingSpeed = signal(1);

export function matches(motion: LibraryMotion, words: string): boolean {
  const text = `${motion.name} ${motion.meaning} ${motion.class}`.toLowerCase();
  return words.toLowerCase().split(/\s+/).every(word => text.includes(word));
}

export const found = computed(() => (library.value ?? []).filter(motion => matches(motion, searched.value.trim())));

export async function loadLibrary(): Promise<void> {
  try {
    library.value = await motions();
    libraryProblem.value = null;
  } catch (problem) {
    libraryProblem.value = problem instanceof Error ? problem.message : String(problem);
  }
}
