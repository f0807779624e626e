// Gestures of one's own in the library, which the server keeps.
import {wordsOf} from "../api/ask.ts";
import {addMotion, deleteMotion} from "../api/kept.ts";
import type {LibraryMotion} from "../api/client.ts";
import {library} from "../state/library.ts";
import {complain, say} from "../state/messages.ts";

// The shipped ones first, one's own behind them, the newest last.
const put = (made: LibraryMotion) => { library.value = [...(library.value ?? []), made]; };

// Throws a ServerError: a name that is taken, say.
export async function addOwn(motion: {name: string; meaning?: string; frames: LibraryMotion["frames"]}): Promise<LibraryMotion> {
  const made = await addMotion(motion);
  put(made);
  say(`${made.name} is in the library.`);
  return made;
}

export async function deleteOwn(motion: LibraryMotion): Promise<void> {
  try {
    await deleteMotion(motion.id);
    library.value = (library.value ?? []).filter(one => one.id !== motion.id);
    say(`${motion.name} is deleted from the library. Controls made of it stay.`, {name: "Bring it back", run: () => void bringBack(motion)});
  } catch (problem) {
    complain(wordsOf(problem));
  }
}

async function bringBack({name, meaning, frames}: LibraryMotion): Promise<void> {
  try {
    await addOwn({name, ...(meaning !== "" && {meaning}), frames});
  } catch (problem) {
    complain(wordsOf(problem));
  }
}
