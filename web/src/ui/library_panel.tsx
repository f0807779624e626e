// The library of unit gestures: searched, looked at on the avatar, added by a press or by dragging onto the track.
import {useSignal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import type {LibraryMotion} from "../api/client.ts";
import {addingSpeed, found, hasOwn, library, libraryDamaged, libraryProblem, loadLibrary, ownOnly, searched} from "../state/library.ts";
import {startPreviews} from "../state/preview.ts";
import {keepsMotions, keepsRules} from "../state/server.ts";
import {studioDocument} from "../state/store.ts";
import {DamagedNote} from "./damaged_note.tsx";
import {IconButton} from "./icon_button.tsx";
import {Icon} from "./icons.tsx";
import {Tile} from "./library_tile.tsx";
import {addingOwn} from "./own_gesture_dialog.tsx";
import {openRules} from "./rules_dialog.tsx";

function Tiles() {
  const pointed = useSignal<LibraryMotion | null>(null);
  const reached = useSignal<string | null>(null);
  useEffect(() => startPreviews(pointed), []);
  const usable = studioDocument.value.speech !== null;
  const shown = found.value;
  const stop = shown.find(motion => motion.id === reached.value) ?? shown[0];
  if (shown.length === 0 && ownOnly.value && !hasOwn.value)
    return <p class="note">There is no gesture of your own yet. “Add own” makes one of what the avatar does, or of a file.</p>;
  if (shown.length === 0) return <p class="note">No gesture is called “{searched.value.trim()}”. Try a shorter word, such as “point”.</p>;
  return <ul class="tiles" aria-label="Unit gestures">
    {shown.map(motion => <Tile key={motion.id} motion={motion} tabbable={motion === stop} usable={usable}
        onLook={one => { pointed.value = one; }} onReach={() => { reached.value = motion.id; }} />)}
  </ul>;
}

export function LibraryPanel() {
  return <section class="panel library" aria-labelledby="library-title">
    <div class="panel-head">
      <h2 id="library-title">Gestures</h2>
      <div class="segments" role="group" aria-label="Speed of what is added">
        {[1, 2, 3].map(speed => <button type="button" class="button small" key={speed} aria-pressed={addingSpeed.value === speed}
            title={`Add at ${speed} times the speed`} onClick={() => { addingSpeed.value = speed; }}>{speed}×</button>)}
      </div>
    </div>
    <label class="search"><Icon name="search" /><input type="search" aria-label="Search gestures" placeholder="Search by name or meaning"
        value={searched.value} onInput={event => { searched.value = event.currentTarget.value; }} /></label>
    {(keepsMotions.value || keepsRules.value) && <div class="library-tools">
      {keepsMotions.value && <div class="segments" role="group" aria-label="Which gestures">
        {[false, true].map(own => <button type="button" class="button small" key={String(own)} aria-pressed={ownOnly.value === own}
            onClick={() => { ownOnly.value = own; }}>{own ? "Own" : "All"}</button>)}
      </div>}
      <span class="spring" />
      {keepsMotions.value && <IconButton icon="plus" name="Add a gesture of your own: the marked range, the shown frame, or a clip in a file"
          onClick={() => { addingOwn.value = true; }}>Add own</IconButton>}
      {keepsRules.value && <IconButton icon="rules" name="Rules from words to gestures" onClick={() => void openRules()}>Rules</IconButton>}
    </div>}
    <DamagedNote damaged={libraryDamaged.value} />
    <p class="hidden" role="status">{library.value ? `${found.value.length} gestures` : ""}</p>
    {libraryProblem.value !== null ? <p class="note">The library cannot be read: {libraryProblem.value} <button type="button" class="button small"
        onClick={() => void loadLibrary()}>Try again</button></p> : library.value === null ? <p class="note">The library is coming …</p> : <Tiles />}
  </section>;
}
