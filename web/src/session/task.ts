// The trial that is worked on: its project is opened, its work is sent, and it is finished, paused, or over by its time.
import {signal} from "@preact/signals";
import {ServerError, wordsOf} from "../api/ask.ts";
import {finish, pauseSession, putWork, type SessionNow, type Task, type Work} from "../api/session.ts";
import {firstMotion, withSpeech} from "../actions/generate.ts";
import {projectFile, projectOf} from "../model/project.ts";
import type {StudioDocument} from "../model/document.ts";
import {pause} from "../playback/player.ts";
import {complain} from "../state/messages.ts";
import {atWork, keyframesTask, mode, modelTask} from "../state/mode.ts";
import {keyframes, served} from "../state/server.ts";
import {begin, history, logOfEdits, onStep, studioDocument} from "../state/store.ts";
import {left_s, setLeft} from "./clock.ts";
import {doneBy, gathered, isGenerated, sent, type Done} from "./edits.ts";
import {freshTools} from "./fresh_tools.ts";
import {arrived, askAnew, present, session} from "./state.ts";
import {keepUnsent, takeUnsent} from "./unsent.ts";

export const task = signal<Task | null>(null);  // the one whose project is open
export const opening = signal<string | null>(null);  // what it still waits for
export const timeOver = signal(false);
export const finishing = signal(false);

const every_ms = 1000;
const mostEdits = 1000;  // at a time: many come together where the connection was lost
const nearEnd_s = 3;  // from then on work is sent at once

// What belongs to the trial that is open: which it is, and what the server does not know of it yet.
let name = "";
let soundless = false;  // its project came without its sound, and goes without it
let done: readonly Done[] = [];
let generated = 0;
let changed = false;
let lastSent_ms = 0;
let sending: Promise<void> | null = null;

const nameOf = ({stage}: SessionNow, {trial}: Task) =>
    JSON.stringify([session.value?.study, session.value?.participant, stage, trial]);

function project(): object {
  const document = studioDocument.value;
  const speech = soundless && document.speech ? {...document.speech, wav: ""} : document.speech;
  return projectFile({...document, speech}, logOfEdits());
}

const workOf = (one: Task, edits: readonly Done[]): Work => ({trial: one.trial, project: project(), edits: edits.map(sent), generated});

// The system is the task's, whatever the project says; the server's first is named by nothing.
function ofTask(document: StudioDocument, {keyframes_only}: Task): StudioDocument {
  const [first, ...others] = (served.value?.gestures ?? []).map(one => one.system);
  const wanted = keyframes_only ? keyframes : [first, ...others].find(one => one === "model") ?? first;
  return {...document, home: null, system: wanted === first ? null : wanted ?? null};
}

async function open(now: SessionNow, given: Task): Promise<void> {
  const wanted = nameOf(now, given);
  name = wanted;
  opening.value = "The speech is coming …";
  timeOver.value = false;
  mode.value = given.keyframes_only ? keyframesTask : modelTask;
  freshTools();
  const before = takeUnsent(wanted);
  const start = ofTask(projectOf(before?.project ?? given.project), given);
  soundless = !start.speech?.wav;
  while (opening.value !== null) {
    try {
      const spoken = await withSpeech(start);
      if (name !== wanted) return;
      begin(spoken);  // which system makes the motion is asked of the project that is open
      task.value = given;
      const moving = spoken.motion || !given.keyframes_only ? spoken : await firstMotion(spoken);
      if (name !== wanted) return;
      if (moving !== spoken) begin(moving);
      break;
    } catch (problem) {
      if (name !== wanted) return;
      opening.value = `${wordsOf(problem)} It is tried again …`;
      await new Promise(resolve => setTimeout(resolve, every_ms));
    }
  }
  [done, generated, changed] = [before?.done ?? [], before?.generated ?? 0, before !== null];
  opening.value = null;
}

// What the server does not take goes with the next work.
function sendWork(): Promise<void> {
  sending ??= send().finally(() => { sending = null; });
  return sending;
}

async function send(): Promise<void> {
  const one = task.value;
  if (!one || opening.value !== null) return;
  const [of, taken, times] = [name, done.slice(0, mostEdits), generated];
  const work = workOf(one, taken);
  done = done.slice(mostEdits);
  [generated, changed, lastSent_ms] = [0, done.length > 0, performance.now()];
  try {
    const left = await putWork(work);
    if (name === of) setLeft(left);
  } catch (problem) {
    if (name !== of) return;
    [done, generated, changed] = [[...taken, ...done], times + generated, true];
    if (problem instanceof ServerError && problem.status === 409) await askAnew();
  }
}

// What is there counts, and is sent at once.
function endTime(): void {
  if (timeOver.value) return;
  pause();
  timeOver.value = true;
  atWork.value = false;
  changed = true;
  lastSent_ms = 0;
}

// With each tick of the clock.
export function tend(): void {
  if (!task.value || opening.value !== null || finishing.value) return;  // finishing tells all that there is
  const left = left_s.value ?? Infinity;
  if (left <= 0 && atWork.value) endTime();
  const due = performance.now() - lastSent_ms >= every_ms || left > 0 && left < nearEnd_s;
  if (changed && due && !sending) void sendWork();
}

// With each answer of the server. A pause and the pages between trials are boards.
export function followTask(now: SessionNow): void {
  const given = now.panel === null && !now.over ? now.authoring : null;
  if (!given) {
    pause();
    atWork.value = false;
    if (!now.authoring) changed = false;  // it is answered
    return;
  }
  setLeft(given.left_s);
  if (nameOf(now, given) !== name) {
    atWork.value = false;
    void open(now, given).then(askAnew, problem => { opening.value = wordsOf(problem); });
    return;
  }
  if (opening.value !== null) return;
  task.value = given;
  if (given.left_s <= 0) {
    endTime();
    return;
  }
  timeOver.value = false;
  atWork.value = true;
}

export async function finishTask(): Promise<void> {
  const one = task.value;
  if (!one || finishing.value) return;
  finishing.value = true;
  pause();
  try {
    await sending;
    const {revision} = present.value!;
    await finish(workOf(one, done.slice(-mostEdits)));
    [done, generated, changed] = [[], 0, false];
    await arrived(revision);
  } catch (problem) {
    complain(wordsOf(problem));
  } finally {
    finishing.value = false;
  }
}

export async function pauseTask(): Promise<void> {
  pause();
  try {
    await sendWork();
    const {revision} = present.value!;
    await pauseSession();
    await arrived(revision);
  } catch (problem) {
    complain(wordsOf(problem));
  }
}

// Called once.
export function keepWork(): void {
  onStep(step => {
    if (!task.value || timeOver.value) return;
    done = gathered(done, doneBy(step, history.value, task.value.limit_s - (left_s.value ?? 0)));
    if (isGenerated(step)) ++generated;
    changed = true;
  });
  addEventListener("pagehide", () => {
    if ((changed || sending) && task.value && !timeOver.value) keepUnsent({name, project: project(), done, generated});
  });
}
