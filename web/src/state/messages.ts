// What the page tells: read out, and shown until the next one or until it is closed.
import {signal} from "@preact/signals";

export interface Message { readonly kind: "said" | "problem"; readonly text: string; readonly number: number }

export const message = signal<Message | null>(null);

let number = 0;
let timer: ReturnType<typeof setTimeout> | undefined;

function put(kind: Message["kind"], text: string): void {
  clearTimeout(timer);
  const shown = {kind, text, number: ++number};
  message.value = shown;
  // Problems stay until they are closed.
  if (kind === "said") timer = setTimeout(() => { if (message.value === shown) message.value = null; }, 6000);
}

export const say = (text: string): void => put("said", text);
export const complain = (text: string): void => put("problem", text);
export const dismiss = (): void => { message.value = null; };
