// What the page tells: read out, and shown until the next one or until it is closed.
import {signal} from "@preact/signals";

// What can be done about it, by a button beside it.
export interface MessageAction { readonly name: string; readonly run: () => void }
export interface Message { readonly kind: "said" | "problem"; readonly text: string; readonly number: number; readonly action: MessageAction | null }

export const message = signal<Message | null>(null);

let number = 0;
let timer: ReturnType<typeof setTimeout> | undefined;

function put(kind: Message["kind"], text: string, action: MessageAction | null): void {
  clearTimeout(timer);
  const shown = {kind, text, number: ++number, action};
  message.value = shown;
  // Problems stay until they are closed, and what asks for an answer.
  if (kind === "said" && !action) timer = setTimeout(() => { if (message.value === shown) message.value = null; }, 6000);
}

export const say = (text: string, action: MessageAction | null = null): void => put("said", text, action);
export const complain = (text: string, action: MessageAction | null = null): void => put("problem", text, action);
export const dismiss = (): void => { message.value = null; };
