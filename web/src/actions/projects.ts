// Projects that the server keeps: opened, saved, and what happens where somebody else saved meanwhile.
import {signal} from "@preact/signals";
import {ServerError, wordsOf} from "../api/ask.ts";
import {addProject, deleteProject, project, putProject} from "../api/kept.ts";
import {projectFile, projectOf} from "../model/project.ts";
import {pause} from "../playback/player.ts";
import {keepRevision, revisionOf} from "../state/homes.ts";
import {complain, say} from "../state/messages.ts";
import {busy, edit, logOfEdits, playhead, select, studioDocument} from "../state/store.ts";

export const conflict = signal(false);  // somebody else saved the project that is open

const unknown = "unknown";  // no project's revision: this browser forgot which version it began from

const content = () => projectFile(studioDocument.value, logOfEdits());
const nameOf = () => studioDocument.value.name.trim() || "Untitled";

async function working(what: string, work: () => Promise<void>): Promise<void> {
  if (busy.value !== null) return;
  busy.value = what;
  try {
    await work();
  } catch (problem) {
    complain(wordsOf(problem));
  } finally {
    busy.value = null;
  }
}

// As a new one. Its id is an edit: undo leaves the project of the server alone, and the document without it.
export async function saveAsNew(name = nameOf()): Promise<void> {
  await working("Saving", async () => {
    const {id, revision} = await addProject(name, content());
    keepRevision(id, revision);
    edit("Keep on the server", draft => {
      draft.home = id;
      draft.name = name;
    });
    say(`${name} is saved on the server.`);
  });
}

// Where it is kept, or as a new one.
export async function saveOnServer(): Promise<void> {
  const {home} = studioDocument.value;
  if (home === null) {
    await saveAsNew();
    return;
  }
  await working("Saving", async () => {
    try {
      keepRevision(home, await putProject(home, nameOf(), content(), revisionOf(home) ?? unknown));
      say(`${nameOf()} is saved on the server.`);
    } catch (problem) {
      if (!(problem instanceof ServerError)) throw problem;
      if (problem.status === 412) {
        conflict.value = true;
      } else if (problem.status === 404) {
        complain("The server has this project no more.", {name: "Save it anew", run: () => void saveAsNew()});
      } else {
        throw problem;
      }
    }
  });
}

// An edit, too: undo brings back what was there.
export async function openFromServer(id: string): Promise<void> {
  await working("Opening", async () => {
    const answer = await project(id);
    const opened = {...projectOf(answer.project), name: answer.name, home: id};
    pause();
    edit(`Open ${answer.name}`, () => opened as never);
    keepRevision(id, answer.revision);
    playhead.value = 0;
    select();
    say(`${answer.name} opened. Undo brings back what was there before.`);
  });
}

export async function deleteFromServer(id: string): Promise<void> {
  await deleteProject(id);
  keepRevision(id, null);
  if (studioDocument.value.home === id) edit("Leave the deleted project", draft => { draft.home = null; });
}
