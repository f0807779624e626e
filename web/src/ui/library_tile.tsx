// One gesture of the library: looked at, added, dragged; one's own deleted.
import type {LibraryMotion} from "../api/client.ts";
import {addGesture} from "../actions/editing.ts";
import {deleteOwn} from "../actions/own_gestures.ts";
import {fps} from "../model/document.ts";
import {addingSpeed, motionType} from "../state/library.ts";
import {keepsMotions} from "../state/server.ts";
import {Figure} from "./figure.tsx";
import {IconButton} from "./icon_button.tsx";

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

export function Tile({motion, tabbable, usable, onLook, onReach}: TileProps) {
  const deletable = motion.own && keepsMotions.value;
  const remove = (tile: Element | null) => {
    const next = tile && (neighbour(tile, "ArrowRight") ?? neighbour(tile, "ArrowLeft"));
    onLook(null);
    void deleteOwn(motion);
    (next as HTMLElement | null)?.focus();
  };
  const key = (event: KeyboardEvent) => {
    if (deletable && event.key === "Delete") {
      event.preventDefault();
      event.stopPropagation();
      remove(event.currentTarget as Element);
      return;
    }
    if (!["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End"].includes(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    (neighbour(event.currentTarget as Element, event.key) as HTMLElement | null)?.focus();
  };
  return <li>
    <button type="button" class="tile" tabIndex={tabbable ? 0 : -1} aria-disabled={!usable} draggable={usable}
        aria-label={`${motion.name}${motion.meaning && `: ${motion.meaning}`}. ${usable ? "Add at the playhead" : "Generate first to add it"}${deletable ? ". Your own: Delete takes it away" : ""}`}
        title={`${motion.meaning || motion.name} (${motion.class}, ${(motion.frames.length / fps).toFixed(1)} s)`}
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
    {deletable && <IconButton icon="bin" name={`Delete ${motion.name} from the library`} tabIndex={-1} onClick={() => remove(null)} />}
  </li>;
}

