// A session begins: the page follows it from here on.
import {signal} from "@preact/signals";
import type {SessionOf} from "../api/session.ts";
import {atWork, keyframesTask, mode} from "../state/mode.ts";
import {startClock} from "./clock.ts";
import {elsewhere, follow, session} from "./state.ts";
import {followTask, keepWork, tend} from "./task.ts";

export const inSession = signal(false);

const patience_ms = 800;  // a window that is loaded anew is gone by then

// Two windows would work on the same trial: the second one waits until the first is closed.
function whenAlone(go: () => void): void {
  if (!navigator.locks) {
    go();
    return;
  }
  const timer = setTimeout(() => { elsewhere.value = true; }, patience_ms);
  void navigator.locks.request("deixis-session", () => {
    clearTimeout(timer);
    elsewhere.value = false;
    go();
    return new Promise<void>(() => {});
  });
}

// A key that is held down presses once.
function pressOnce(event: KeyboardEvent): void {
  if (event.repeat && (event.key === "Enter" || event.key === " ") && (event.target as Element).matches?.("button")) event.preventDefault();
}

export function beginSession(of: SessionOf): void {
  session.value = of;
  mode.value = keyframesTask;
  atWork.value = false;
  inSession.value = true;
  document.title = "Session – Deixis";
  addEventListener("keydown", pressOnce, {capture: true});
  keepWork();
  startClock(tend);
  whenAlone(() => void follow(followTask));
}
