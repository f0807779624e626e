// The page in a session: boards, and between them the studio with a bar over it.
import {useLayoutEffect, useRef} from "preact/hooks";
import {atWork} from "../state/mode.ts";
import {Workshop} from "../ui/workshop.tsx";
import {Bar} from "./bar.tsx";
import {BoardView} from "./board_view.tsx";
import {connection, elsewhere, present, session} from "./state.ts";
import {opening, task, timeOver} from "./task.ts";

function Connection({underBar}: {underBar: boolean}) {
  const words = {good: "", lost: "The connection is lost. It is tried again; nothing of what you did is lost.",
    refused: "This page may no longer speak to the program. Open the address that it printed."}[connection.value];
  return <div class={underBar ? "connection under-bar" : "connection"} role="alert">{words && <p>{words}</p>}</div>;
}

// The studio is there from the beginning, so that it is ready when a trial begins; it is out of reach while something else
// is on.
export function SessionView() {
  const studio = useRef<HTMLDivElement>(null);
  const focused = useRef<{readonly trial: string; readonly element: HTMLElement} | null>(null);
  const now = present.value;
  const works = atWork.value;
  const trial = `${now?.stage} ${task.value?.trial}`;
  // A trial begins at its head; one that goes on, where it was left.
  useLayoutEffect(() => {
    if (works) {
      const {current: last} = focused;
      (last?.trial === trial && last.element.isConnected ? last.element : studio.current?.querySelector("h1"))?.focus();
    } else {
      for (const dialog of document.querySelectorAll("dialog[open]")) (dialog as HTMLDialogElement).close();
    }
  }, [works, trial]);
  const board = now?.panel ?? null;
  const veil = board ? null : now?.over ? "That was all. You can close this window."
      : elsewhere.value ? "The session is open in another window. Go on there, or close it." : timeOver.value ? "The time is over. What you made is kept." : opening.value ?? (now?.authoring && task.value ? null : "One moment …");
  return <>
    <div class={board || !task.value ? "task covered" : "task"} ref={studio} inert={!works} onFocusIn={event => { focused.current = {trial, element: event.target as HTMLElement}; }}>
      {task.value ? <Bar task={task.value} /> : <header class="header session-bar" />}
      <Workshop />
    </div>
    {veil !== null && <div class="veil"><p role="status">{veil}</p></div>}
    {board && <BoardView board={board} now={now!} language={session.value?.language ?? "en"} />}
    <Connection underBar={board === null} />
  </>;
}
