// The projects on the server, and the choice where somebody else has saved the same one.
import {signal, useSignal} from "@preact/signals";
import {wordsOf} from "../api/ask.ts";
import type {Damaged} from "../api/client.ts";
import {projects, type ListedProject} from "../api/kept.ts";
import {chooseProject, saveProject} from "../actions/files.ts";
import {conflict, deleteFromServer, openFromServer, saveAsNew, saveOnServer} from "../actions/projects.ts";
import {studioDocument} from "../state/store.ts";
import {DamagedNote} from "./damaged_note.tsx";
import {Dialog} from "./dialog.tsx";
import {IconButton} from "./icon_button.tsx";

const open = signal(false);
const listed = signal<readonly ListedProject[] | null>(null);
const damaged = signal<readonly Damaged[]>([]);
const problem = signal("");

async function list(): Promise<void> {
  try {
    const answer = await projects();
    listed.value = answer.projects;
    damaged.value = answer.damaged;
    problem.value = "";
  } catch (wrong) {
    problem.value = wordsOf(wrong);
  }
}

export function openProjects(): void {
  listed.value = null;
  open.value = true;
  void list();
}

const when = (iso: string) => new Date(iso).toLocaleString([], {dateStyle: "medium", timeStyle: "short"});
const size = (bytes: number) => bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} KB` : `${(bytes / 1e6).toFixed(1)} MB`;

function Row({one}: {one: ListedProject}) {
  const sure = useSignal(false);
  const here = studioDocument.value.home === one.id;
  return <li class={here ? "project here" : "project"}>
    <button type="button" class="button project-open" onClick={() => {
      open.value = false;
      void openFromServer(one.id);
    }}><b>{one.name}</b><span class="note">{when(one.saved)}, {size(one.bytes)}{here ? ", open here" : ""}</span></button>
    {sure.value ? <>
      <button type="button" class="button small" onClick={() => void deleteFromServer(one.id).then(list, wrong => { problem.value = wordsOf(wrong); })}>Delete for good</button>
      <button type="button" class="button small" onClick={() => { sure.value = false; }}>Keep</button>
    </> : <IconButton icon="bin" name={`Delete ${one.name} from the server`} onClick={() => { sure.value = true; }} />}
  </li>;
}

export function ProjectsDialog() {
  const {name, home} = studioDocument.value;
  const done = (run: () => void) => () => {
    open.value = false;
    run();
  };
  return <Dialog open={open} id="projects" title="Projects on the server" narrow>
    {listed.value === null ? <p class="note" role="status">{problem.value === "" ? "The list is coming …" : ""}</p> :
      listed.value.length === 0 ? <p class="note">There is none yet.</p> :
      <ul class="projects" aria-label="Projects">{listed.value.map(one => <Row key={one.id} one={one} />)}</ul>}
    <DamagedNote damaged={damaged.value} />
    <p class="problem-words" role="alert">{problem.value}</p>
    <div class="ends-with">
      <button type="button" class="button small" title="Ctrl+O" onClick={done(chooseProject)}>Open a file</button>
      <button type="button" class="button small" onClick={done(saveProject)}>Save as a file</button>
      <span class="spring" />
      {home !== null && <button type="button" class="button small" onClick={done(() => void saveAsNew(`${name} (copy)`.slice(0, 80)))}>Save a copy</button>}
      <button type="button" class="button primary" onClick={done(() => void saveOnServer())}>{home === null ? "Save here" : "Save"}</button>
    </div>
  </Dialog>;
}

export function ConflictDialog() {
  const {name, home} = studioDocument.value;
  const done = (run: () => void) => () => {
    conflict.value = false;
    run();
  };
  return <Dialog open={conflict} id="conflict" title="Somebody else has saved this project" narrow>
    <p class="note">“{name}” was saved from elsewhere since you opened it. Neither version is lost: keep yours beside it, or look at theirs first.</p>
    <div class="ends-with">
      <button type="button" class="button small" title="Undo brings yours back" onClick={done(() => { if (home !== null) void openFromServer(home); })}>Open theirs (undo brings back mine)</button>
      <button type="button" class="button primary" onClick={done(() => void saveAsNew(`${name} (mine)`.slice(0, 80)))}>Save mine beside it</button>
    </div>
  </Dialog>;
}
