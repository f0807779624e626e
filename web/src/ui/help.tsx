// All keys, in one dialog.
import {signal, useSignalEffect} from "@preact/signals";
import {useRef} from "preact/hooks";
import {IconButton} from "./icon_button.tsx";

export const helpOpen = signal(false);

const groups: readonly (readonly [string, readonly (readonly [string, string])[]])[] = [
  ["Generate", [["Ctrl+Enter", "Generate gestures"], ["Ctrl+Shift+Enter", "Generate the marked range only"]]],
  ["Play", [["Space", "Play, pause"], ["Home, End", "To the start, to the end"], ["L", "Repeat (the marked range, or all)"], ["M", "Sound off and on"],
    ["← → on the playhead", "One frame; with Shift a second, with Ctrl to the next word"]]],
  ["Mark", [["I, O", "The marked range starts, ends at the playhead"], ["Drag on sound or words", "Mark a range"],
    ["Shift+Enter on a word", "Mark the word, or on to it"], ["Esc", "Clear the selection, then the range"]]],
  ["Controls", [["Drag a joint", "Change the pose in hand; joints also take the arrow keys"], ["P", "Keep the shown pose, or the marked range"], ["S", "Add a style"], ["← → ↑ ↓", "To another control"], ["Ctrl+← →", "Move by a frame"],
    ["Ctrl+Shift+← →", "Move to the next word's border"], ["Shift+← →", "Stretch by a frame"], ["F", "Flip left and right"], ["Delete or D", "Delete"],
    ["Ctrl+C, X, V", "Copy, cut, paste at the playhead"], ["Shift+click, Ctrl+A", "Select more than one, all"], ["Alt while dragging", "Do not snap"], ["N", "Snapping off and on"]]],
  ["Project", [["Ctrl+Z, Ctrl+Shift+Z", "Undo, redo"], ["Ctrl+S, Ctrl+O", "Save, open"], ["+, −", "Zoom the timeline; also Ctrl and the wheel"]]],
];

export function Help() {
  const dialog = useRef<HTMLDialogElement>(null);
  useSignalEffect(() => {
    if (helpOpen.value) dialog.current?.showModal();
    else dialog.current?.close();
  });
  return <dialog class="help" ref={dialog} aria-labelledby="help-title" onClose={() => { helpOpen.value = false; }}>
    <div class="panel-head">
      <h2 id="help-title">Keys and mouse</h2>
      <IconButton icon="close" name="Close" keys="Esc" onClick={() => { helpOpen.value = false; }} />
    </div>
    <div class="help-groups">{groups.map(([name, keys]) => <section key={name}>
      <h3>{name}</h3>
      <dl>{keys.map(([key, does]) => <div key={key}><dt><kbd>{key}</kbd></dt><dd>{does}</dd></div>)}</dl>
    </section>)}</div>
    <p class="note"><a href="/licences.txt" target="_blank">Licences of the libraries that this page is built with</a></p>
  </dialog>;
}
