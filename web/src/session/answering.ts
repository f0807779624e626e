// What a participant does on a board: buttons are pressed, sliders and fields are set. One thing goes to the server at a
// time, in order; what has not arrived is sent again, and a press that meets another board than it was meant for is none.
import {signal} from "@preact/signals";
import {ServerError} from "../api/ask.ts";
import {press, slide, type} from "../api/session.ts";
import {arrived, askAnew, boardName, present} from "./state.ts";

type Value = number | string;
interface Unsent { readonly board: string | null; readonly value: Value }

// Of sliders and fields, by their ids: what is set here and not yet there.
const unsent = signal<ReadonlyMap<number, Unsent>>(new Map());
export const pressed = signal<ReadonlySet<number>>(new Set());  // buttons whose presses are under way

// What is set of the board that is on; undefined: nothing that the server does not know.
export function setHere(id: number): Value | undefined {
  const one = unsent.value.get(id);
  return one?.board === boardName.value ? one?.value : undefined;
}

const isOld = (problem: unknown) => problem instanceof ServerError && problem.status === 409;
const isRefused = (problem: unknown) => problem instanceof ServerError && problem.status >= 400 && problem.status < 500 && problem.status !== 401;
const most_tries = 3;  // of what meets a board that has just changed

// Until it is there, or is not wanted: it was set once more, the board is another one, or the server refuses it.
async function deliver(id: number, one: Unsent): Promise<void> {
  for (let tries = 0; tries < most_tries && boardName.value === one.board && unsent.value.get(id) === one;) {
    const {revision} = present.value!;
    try {
      await (typeof one.value === "string" ? type(revision, id, one.value) : slide(revision, id, one.value));
      await arrived(revision);
      break;
    } catch (problem) {
      if (isRefused(problem)) ++tries;
      await askAnew();
    }
  }
  if (unsent.value.get(id) === one) unsent.value = new Map([...unsent.value].filter(([other]) => other !== id));
}

let queue = Promise.resolve();
const inTurn = (what: () => Promise<void>): Promise<void> => queue = queue.then(what, what);

let planned = false;

async function deliverAll(): Promise<void> {
  planned = false;
  for (let [first] = unsent.value; first; [first] = unsent.value) await deliver(...first);
}

export function set(id: number, value: Value): void {
  unsent.value = new Map(unsent.value).set(id, {board: boardName.value, value});
  if (!planned) void inTurn(deliverAll);
  planned = true;
}

// Whether it is there and may be pressed.
const isOpen = (id: number) => present.value?.panel?.buttons.some(button => button.id === id && button.enabled) ?? false;

// A press that met a change of its own board is made again.
async function deliverPress(id: number, board: string | null): Promise<void> {
  for (let tries = 0; tries < most_tries && boardName.value === board && isOpen(id); ++tries) {
    const {revision} = present.value!;
    try {
      await press(revision, id);
      await arrived(revision);
      return;
    } catch (problem) {
      await askAnew();
      if (!isOld(problem)) return;  // whether it has arrived nobody knows: the board shows it
    }
  }
}

export function pressButton(id: number): void {
  if (pressed.value.has(id) || present.value?.over) return;
  const board = boardName.value;
  pressed.value = new Set(pressed.value).add(id);
  void inTurn(() => deliverPress(id, board)).finally(() => { pressed.value = new Set([...pressed.value].filter(one => one !== id)); });
}
