// Projects and motion as files that the browser saves and opens.
import {wordsOf} from "../api/ask.ts";
import {exportMotion, type MotionFormat} from "../api/client.ts";
import {emptyDocument, fingerprint} from "../model/document.ts";
import {fileNameOf, readProject, writeProject} from "../model/project.ts";
import {base64Of, bytesOf} from "../playback/base64.ts";
import {pause} from "../playback/player.ts";
import {complain, say} from "../state/messages.ts";
import {relaxes} from "../state/server.ts";
import {busy, edit, logOfEdits, newId, playhead, select, studioDocument} from "../state/store.ts";

export function download(content: BlobPart, type: string, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], {type}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

export const chooseProject = (): void => document.getElementById("project-file")?.click();

export function saveProject(): void {
  const name = fileNameOf(studioDocument.value, "deixis.json");
  download(writeProject(studioDocument.value, logOfEdits()), "application/json", name);
  say(`Project saved as ${name}.`);
}

// Opening and beginning anew are edits, too: undo brings back what was there.
export async function openProject(file: File): Promise<void> {
  try {
    const opened = readProject(await file.text());
    pause();
    edit(`Open ${opened.name}`, () => opened as never);
    playhead.value = 0;
    select();
    say(`${opened.name} opened. Undo brings back what was there before.`);
  } catch (problem) {
    complain(wordsOf(problem));
  }
}

export function newProject(): void {
  pause();
  edit("New project", () => emptyDocument as never);
  playhead.value = 0;
  select();
  say("A new project. Undo brings back what was there before.");
}

// The motion that the avatar shows, as generated.
export async function saveMotion(format: MotionFormat): Promise<void> {
  const project = studioDocument.value;
  if (!project.motion || !project.speech || busy.value !== null) return;
  busy.value = "Writing the motion";
  try {
    const name = fileNameOf(project, format);
    const bytes = await exportMotion({frames: project.motion.frames, duration_s: project.speech.duration_s, format, ...(relaxes.value !== null && {relaxed_fingers: relaxes.value})});
    download(bytes, "application/octet-stream", name);
    say(`Motion saved as ${name}.` + (project.motion.madeFrom === fingerprint(project) ? "" : " It is the motion last generated: controls have changed since."));
  } catch (problem) {
    complain(wordsOf(problem));
  } finally {
    busy.value = null;
  }
}

export function saveSound(): void {
  const {speech} = studioDocument.value;
  if (speech) download(bytesOf(speech.wav) as BlobPart, "audio/wav", fileNameOf(studioDocument.value, "wav"));
}

const largestRecording = 40e6;

// A recorded speech in place of a voice. Its text must be what is said in it.
export async function chooseRecording(file: File): Promise<void> {
  if (file.size > largestRecording) {
    complain(`${file.name} is larger than ${largestRecording / 1e6} MB, which a project takes. Cut it, or save it with one channel and 16 kHz.`);
    return;
  }
  const recording = {id: newId(), name: file.name, wav: base64Of(new Uint8Array(await file.arrayBuffer()))};
  edit(`Take ${file.name}`, draft => { draft.recording = recording; });
  say(`${file.name} is the speech. Type what is said in it, then generate.`);
}

export function dropRecording(): void {
  edit("Leave the recording out", draft => { draft.recording = null; });
}
