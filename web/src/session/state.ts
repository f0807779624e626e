// What is on in the session, as the server said it last, and how the page hears of it.
import {computed, signal} from "@preact/signals";
import {ServerError} from "../api/ask.ts";
import {sessionNow, type SessionNow, type SessionOf} from "../api/session.ts";

export const session = signal<SessionOf | null>(null);
export const present = signal<SessionNow | null>(null);
// "refused": this address is none of the session's any more.
export const connection = signal<"good" | "lost" | "refused">("good");

export const elsewhere = signal(false);  // another window takes part

// Which board it is: the same one while it is answered, whatever answers change on it.
function nameOf({state, stage, panel}: SessionNow): string | null {
  if (!panel) return null;
  const bold = panel.texts.filter(one => one.bold && !/^[-\d\s]*$/.test(one.text)).map(one => one.text);
  const asks = panel.sliders.length + panel.fields.length > 0 || panel.buttons.some(button => button.role === "option");
  const rest = asks ? [] : panel.texts.filter(one => !one.bold).map(one => one.text.replace(/\d+/g, "0"));  // times are counted down
  const ids = [...panel.sliders, ...panel.fields].map(one => one.id);
  return JSON.stringify([state, stage, bold, rest, ids]);
}
export const boardName = computed(() => present.value && nameOf(present.value));

const patience_ms = 15_000;
const again_ms = 1000;
const wait = (ms: number) => new Promise(done => setTimeout(done, ms));

let asking = new AbortController();
let anew = false;
const waiting = new Set<() => void>();

// Resolves with the next answer of the server.
const nextAnswer = (): Promise<void> => new Promise(resolve => waiting.add(resolve));

// Asks now, whatever has been asked.
export function askAnew(): Promise<void> {
  const answered = nextAnswer();
  anew = true;
  asking.abort();
  return answered;
}

// When what is on is another one than `before`, or after a while: what a press has led to is on its way.
export async function arrived(before: number): Promise<void> {
  if (present.value?.revision !== before) return;
  await Promise.race([nextAnswer(), wait(2000)]);
  if (present.value?.revision === before) await askAnew();
}

// Follows the session until it is over. `each`: with every answer.
export async function follow(each: (now: SessionNow) => void): Promise<void> {
  let after: number | null = null;
  while (!present.value?.over) {
    asking = new AbortController();
    if (anew) after = null;
    anew = false;
    const timer = setTimeout(() => asking.abort(), patience_ms);
    const begun = performance.now();
    try {
      const now = await sessionNow(after, asking.signal);
      const quick = now.revision === after && performance.now() - begun < 500;
      present.value = now.over && !now.panel ? {...now, panel: present.value?.panel ?? null} : now;  // the last board stays
      connection.value = "good";
      after = now.revision;
      each(now);
      const told = [...waiting];
      waiting.clear();
      for (const tell of told) tell();
      if (quick) await wait(again_ms);  // it does not wait for a change, as it should
    } catch (problem) {
      after = null;
      if (anew) continue;
      connection.value = problem instanceof ServerError && problem.status === 401 ? "refused" : "lost";
      await wait(again_ms);
    } finally {
      clearTimeout(timer);
    }
  }
}
