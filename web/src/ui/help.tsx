// All keys, in one dialog.
import {signal} from "@preact/signals";
import {offers, type Offer} from "../state/mode.ts";
import {Dialog} from "./dialog.tsx";

export const helpOpen = signal(false);

// Some are for what the page may not offer.
const groups: readonly (readonly [string, readonly (readonly [keys: string, does: string, needs?: Offer])[]])[] = [
  ["Generate", [["Ctrl+Enter", "Generate gestures"], ["Ctrl+Shift+Enter", "Generate the marked range only"]]],
  ["Play", [["Space", "Play, pause"], ["Home, End", "To the start, to the end"], ["L", "Repeat (the marked range, or all)"], ["M", "Sound off and on"],
    ["← → on the playhead", "One frame; with Shift a second, with Ctrl to the next word"]]],
  ["Mark", [["I, O", "The marked range starts, ends at the playhead"], ["Drag on sound or words", "Mark a range"],
    ["Shift+Enter on a word", "Mark the word, or on to it"], ["Esc", "Clear the selection, then the range"]]],
  ["Controls", [["Drag a joint", "Change the pose in hand; joints also take the arrow keys"], ["R", "Turn parts by rings, move joints"], ["T, K, Esc", "Try a pose, keep it, drop it"], ["P", "Keep the shown pose, or the marked range"], ["S", "Add a style"], ["← → ↑ ↓", "To another control"], ["Ctrl+← →", "Move by a frame"],
    ["Ctrl+Shift+← →", "Move to the next word's border"], ["Shift+← →", "Stretch by a frame"], ["F", "Flip left and right"], ["Delete or D", "Delete"],
    ["Ctrl+C, X, V", "Copy, cut, paste at the playhead"], ["Shift+click, Ctrl+A", "Select more than one, all"], ["Alt while dragging", "Do not snap"], ["N", "Snapping off and on"]]],
  ["Avatar", [["1 to 6", "Front, left, right, above, a participant across, side by side"], ["Arrows on the picture", "Turn the view; + and − come closer and go away"], ["B", "The ball to point at; it takes the arrow keys"], ["Delete on a gesture of your own", "Take it out of the library", "kept"]]],
  ["Project", [["Ctrl+Z, Ctrl+Shift+Z", "Undo, redo"], ["Ctrl+S, Ctrl+O", "Save, open", "files"], ["+, −", "Zoom the timeline; also Ctrl and the wheel"]]],
];

export function Help() {
  return <Dialog open={helpOpen} id="help" title="Keys and mouse">
    <div class="help-groups">{groups.map(([name, keys]) => <section key={name}>
      <h3>{name}</h3>
      <dl>{keys.filter(([,, needs]) => !needs || offers(needs)).map(([key, does]) => <div key={key}><dt><kbd>{key}</kbd></dt><dd>{does}</dd></div>)}</dl>
    </section>)}</div>
    <p class="note"><a href="/licences.txt" target="_blank">Licences of the libraries that this page is built with</a></p>
  </Dialog>;
}
