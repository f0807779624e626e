// The unit gestures that the server has, searched by the words of their names and meanings.
import {computed, signal} from "@preact/signals";
import {wordsOf} from "../api/ask.ts";
import {motions, type Damaged, type LibraryMotion} from "../api/client.ts";

export const library = signal<readonly LibraryMotion[] | null>(null);  // null: not there yet
export const libraryProblem = signal<string | null>(null);
export const libraryDamaged = signal<readonly Damaged[]>([]);
export const motionType = "application/x-deixis-motion";  // of a gesture that is dragged
export const searched = signal("");
export const addingSpeed = signal(1);
export const ownOnly = signal(false);
export const hasOwn = computed(() => (library.value ?? []).some(motion => motion.own));

export function matches(motion: LibraryMotion, words: string): boolean {
  const text = `${motion.name} ${motion.meaning} ${motion.class}`.toLowerCase();
  return words.toLowerCase().split(/\s+/).every(word => text.includes(word));
}

export const found = computed(() => (library.value ?? []).filter(motion => matches(motion, searched.value.trim()) && (motion.own || !ownOnly.value)));

export async function loadLibrary(): Promise<void> {
  try {
    const {motions: all, damaged} = await motions();
    library.value = all;
    libraryDamaged.value = damaged;
    libraryProblem.value = null;
  } catch (problem) {
    libraryProblem.value = wordsOf(problem);
  }
}
