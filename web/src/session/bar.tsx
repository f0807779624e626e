// The line over the studio in a trial: which one it is, what is asked, and how much time is left.
import {signal} from "@preact/signals";
import type {Task} from "../api/session.ts";
import {isCurrent} from "../model/project.ts";
import {studioDocument} from "../state/store.ts";
import {Dialog} from "../ui/dialog.tsx";
import {HelpButton, HistoryButtons} from "../ui/header.tsx";
import {announced, left_s} from "./clock.ts";
import {inMinutes} from "./minutes.ts";
import {finishing, finishTask, pauseTask} from "./task.ts";

const asking = signal(false);
const soon_s = 60;
const now_s = 10;

function TimeLeft() {
  const left = left_s.value;
  if (left === null) return null;
  return <>
    <p class={`time-left${left <= now_s ? " now" : left <= soon_s ? " soon" : ""}`} role="timer" aria-label="Time left">
      <span>{inMinutes(left)}</span> left</p>
    <p class="hidden" role="status">{announced.value}</p>
  </>;
}

function FinishDialog() {
  const document = studioDocument.value;
  return <Dialog open={asking} id="finish" title="Finish this trial?" narrow>
    <p class="note">You cannot come back to it.</p>
    {!isCurrent(document) && <p class="note">{document.motion ? "Something has changed since gestures were last generated: without generating again, it is not in them."
        : "No gestures have been generated yet."}</p>}
    <div class="ends-with">
      <button type="button" class="button small" autofocus onClick={() => { asking.value = false; }}>Go on working</button>
      <button type="button" class="button primary" onClick={() => {
        asking.value = false;
        void finishTask();
      }}>Finish</button>
    </div>
  </Dialog>;
}

export function Bar({task}: {task: Task}) {
  const {trial, of, practice, question, may_end_early} = task;
  return <header class="header session-bar">
    <h1 tabIndex={-1}>Trial {trial} of {of}</h1>
    {practice && <p class="practice">Practice</p>}
    <p class="asked">{question}</p>
    <HistoryButtons />
    <HelpButton />
    <span class="divider" />
    <TimeLeft />
    <button type="button" class="button small" onClick={() => void pauseTask()}>Pause session</button>
    {may_end_early && <button type="button" class="button primary" aria-haspopup="dialog" disabled={finishing.value} onClick={() => { asking.value = true; }}>Finish</button>}
    <FinishDialog />
  </header>;
}
