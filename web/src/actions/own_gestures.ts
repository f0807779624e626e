// Gestures of one's own in the library, which the server keeps.
import {wordsOf} from "../api/ask.ts";
import {addMotion, deleteMotion, readMotion} from "../api/kept.ts";
import type {LibraryMotion} from "../api/client.ts";
import {clipOf, isOurs, wholeClip, type Clip} from "../model/clip_file.ts";
import {library} from "../state/library.ts";
import {complain, say} from "../state/messages.ts";
import {readsClips} from "../state/server.ts";

// The shipped ones first, one's own behind them, the newest last.
const put = (made: LibraryMotion) => { library.value = [...(library.value ?? []), made]; };

// Throws a ServerError: a name that is taken, say.
export async function addOwn(motion: {name: string; meaning?: string; frames: LibraryMotion["frames"]}): Promise<LibraryMotion> {
  const made = await addMotion(motion);
  put(made);
  say(`${made.name} is in the library.`);
  return made;
}

const largestJson = 64e6;

// What is in a clip's file: a project, frames, or a clip of another program where the server reads those. Throws with words
// for people.
export async function clipIn(file: File): Promise<Clip & {readonly remarks: readonly string[]}> {
  const isJson = file.size < largestJson && /^\s*[[{]/.test(await file.slice(0, 64).text());
  const text = isJson ? await file.text() : "";
  if (!readsClips.value || isOurs(text)) return {...clipOf(text), remarks: []};
  const {frames, remarks} = await readMotion(file);
  return {...wholeClip(frames), remarks};
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
