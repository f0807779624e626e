// The library of unit gestures: searched, looked at on the avatar, added by a press or by dragging onto the track.
import {useSignal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import type {LibraryMotion} from "../api/client.ts";
import {addGesture} from "../actions/editing.ts";
import {fps} from "../model/document.ts";
import {addingSpeed, found, library, libraryProblem, loadLibrary, motionType, searched} from "../state/library.ts";
import {startPreviews} from "../state/preview.ts";
import {studioDocument} from "../state/store.ts";
import {Figure} from "./figure.tsx";
import {Icon} from "./icons.tsx";

// Which tile the arrows lead to: by place, since a row holds as many as there is room for.
function neighbour(tile: Element, key: string): Element | null {
  const tiles = [...tile.parentElement!.parentElement!.querySelectorAll(".tile")];
  const at = tiles.indexOf(tile);
  if (key === "Home") return tiles[0] ?? null;
  if (key === "End") return tiles.at(-1) ?? null;
  if (key === "ArrowLeft" || key === "ArrowRight") return tiles[at + (key === "ArrowLeft" ? -1 : 1)] ?? null;
  const {left, top} = tile.getBoundingClientRect();
  const column = tiles.filter(one => Math.abs(one.getBoundingClientRect().left - left) < 2);
  return key === "ArrowUp" ? column.findLast(one => one.getBoundingClientRect().top < top - 2) ?? null
      : column.find(one => one.getBoundingClientRect().top > top + 2) ?? null;
}

// The pose that tells a gesture best: where it is furthest from its first one.
function keyFrame(motion: LibraryMotion) {
  const [first] = motion.frames;
  const far = (frame: readonly number[]) => frame.reduce((sum, number, k) => sum + (number - first![k]!) ** 2, 0);
  return motion.frames.reduce((best, frame) => far(frame) > far(best) ? frame : best, first!);
}

interface TileProps { motion: LibraryMotion; tabbable: boolean; usable: boolean; onLook: (motion: LibraryMotion | null) => void; onReach: () => void }

function Tile({motion, tabbable, usable, onLook, onReach}: TileProps) {
  const key = (event: KeyboardEvent) => {
    if (!["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End"].includes(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    (neighbour(event.currentTarget as Element, event.key) as HTMLElement | null)?.focus();
  };
  return <li>
    <button type="button" class="tile" tabIndex={tabbable ? 0 : -1} aria-disabled={!usable} draggable={usable}
        aria-label={`${motion.name}: ${motion.meaning}. ${usable ? "Add at the playhead" : "Generate first to add it"}`}
        title={`${motion.meaning} (${motion.class}, ${(motion.frames.length / fps).toFixed(1)} s)`}
        onClick={() => { if (usable) addGesture(motion, addingSpeed.value); }}
        onDragStart={event => {
          event.dataTransfer?.setData(motionType, motion.id);
          onLook(null);
        }}
        onPointerEnter={() => onLook(motion)} onPointerLeave={() => onLook(null)} onBlur={() => onLook(null)} onKeyDown={key}
        onFocus={event => {
          onReach();
          if ((event.currentTarget as Element).matches(":focus-visible")) onLook(motion);
        }}>
      <Figure frame={keyFrame(motion)} />
      <span class="tile-name">{motion.name}</span>
    </button>
  </li>;
}

function Tiles() {
  const pointed = useSignal<LibraryMotion | null>(null);
  const reached = useSignal<string | null>(null);
  useEffect(() => startPreviews(pointed), []);
  const usable = studioDocument.value.speech !== null;
  const shown = found.value;
  const stop = shown.find(motion => motion.id === reached.value) ?? shown[0];
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
    <p class="hidden" role="status">{library.value ? `${found.value.length} gestures` : ""}</p>
    {libraryProblem.value !== null ? <p class="note">The library cannot be read: {libraryProblem.value} <button type="button" class="button small"
        onClick={() => void loadLibrary()}>Try again</button></p> : library.value === null ? <p class="note">The library is coming …</p> : <Tiles />}
  </section>;
}
