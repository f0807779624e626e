// The project: its name, its files, undo and redo.
import {useEffect, useRef} from "preact/hooks";
import {chooseProject, newProject, openProject, saveMotion, saveProject, saveSound} from "../actions/files.ts";
import {saveOnServer} from "../actions/projects.ts";
import {say} from "../state/messages.ts";
import {offers} from "../state/mode.ts";
import {stepTrial} from "../state/posing.ts";
import {keepsProjects} from "../state/server.ts";
import {edit, redo, redoable, settle, studioDocument, undo, undoable} from "../state/store.ts";
import {openProjects} from "./projects_dialog.tsx";
import {openFilm} from "./film_dialog.tsx";
import {helpOpen} from "./help.tsx";
import {IconButton} from "./icon_button.tsx";

export function undoAloud(): void {
  if (stepTrial(-1)) return;
  const label = undo();
  if (label !== null) say(`Undone: ${label}.`);
}
export function redoAloud(): void {
  if (stepTrial(1)) return;
  const label = redo();
  if (label !== null) say(`Done again: ${label}.`);
}

// Where the project is kept: on the server if it is from there, else as a file; in a session by itself.
export function save(): void {
  if (!offers("files")) say("Your work is kept by itself.");
  else if (keepsProjects.value && studioDocument.value.home !== null) void saveOnServer();
  else saveProject();
}

export function HistoryButtons() {
  return <div class="header-group" role="group" aria-label="History">
    <IconButton icon="undo" name={undoable.value === null ? "Undo" : `Undo: ${undoable.value}`} keys="Ctrl+Z" disabled={undoable.value === null} onClick={undoAloud} />
    <IconButton icon="redo" name={redoable.value === null ? "Redo" : `Redo: ${redoable.value}`} keys="Ctrl+Shift+Z" disabled={redoable.value === null} onClick={redoAloud} />
  </div>;
}

export function HelpButton() {
  return <IconButton icon="help" name="Keys and mouse" keys="?" onClick={() => { helpOpen.value = true; }} />;
}

export function Header() {
  const file = useRef<HTMLInputElement>(null);
  const {name, motion, speech} = studioDocument.value;
  useEffect(() => { document.title = `${name} – Deixis Studio`; }, [name]);
  return <header class="header">
    <h1><svg class="brand" viewBox="0 0 24 24" aria-hidden="true"><circle cx="8" cy="6" r="3" /><path d="M8 11v7M8 12l5 2.5 8-4.5M8 12l-4 5" /></svg>
      <span>Deixis <em>Studio</em></span></h1>
    <input class="project-name" aria-label="The project's name" value={name} maxLength={80} spellcheck={false} onInput={event => {
      const words = event.currentTarget.value;
      edit("Rename the project", draft => { draft.name = words; }, "name");
    }} onBlur={settle} />
    <div class="header-group" role="group" aria-label="Project">
      <IconButton icon="file" name="New project" onClick={newProject}>New</IconButton>
      <IconButton icon="open" name="Open a project" keys="Ctrl+O" onClick={chooseProject}>Open</IconButton>
      <IconButton icon="save" name="Save the project" keys="Ctrl+S" onClick={save}>Save</IconButton>
      {keepsProjects.value && <IconButton icon="server" name="Projects on the server" onClick={openProjects}>Projects</IconButton>}
      <input ref={file} id="project-file" type="file" accept=".json,application/json" hidden aria-label="Project file" onChange={() => {
        const chosen = file.current?.files?.[0];
        if (chosen) void openProject(chosen);
        if (file.current) file.current.value = "";
      }} />
    </div>
    <HistoryButtons />
    <span class="spring" />
    <div class="header-group" role="group" aria-label="Export">
      {(["bvh", "glb", "csv"] as const).map(format => <IconButton key={format} icon="save" name={`Download the motion as ${format.toUpperCase()}`}
          disabled={!motion} onClick={() => void saveMotion(format)}>{format.toUpperCase()}</IconButton>)}
      <IconButton icon="save" name="Download the sound as WAV" disabled={!speech} onClick={saveSound}>WAV</IconButton>
      <IconButton icon="film" name="Make a film (WebM)" disabled={!motion} onClick={openFilm}>Film</IconButton>
    </div>
    <HelpButton />
  </header>;
}
