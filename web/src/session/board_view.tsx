// A board: scaled to the window, with its parts in reading order. The focus goes to its head when it comes.
import {signal, useSignal} from "@preact/signals";
import {useEffect, useLayoutEffect, useRef} from "preact/hooks";
import type {Board, SessionNow} from "../api/session.ts";
import {Button, Field, Slider, Text, type Drawn} from "./board_parts.tsx";
import {headOf, laidOut, scaleOf, type Piece, type Placed} from "./board_layout.ts";
import {boardName} from "./state.ts";

const room = signal({width: innerWidth, height: innerHeight});
addEventListener("resize", () => { room.value = {width: innerWidth, height: innerHeight}; });
const beside_px = 32;  // of the board on either side
const over_px = 18;    // and over and under it; there is room for a line in a board's own margin

// What came with a board that has just come is not meant for it: the second press of a double click.
const tooSoon_ms = 300;

const least_share = 0.75;

// Letters of this machine may be wider than those that the board was laid out in: all of a kind are made as much smaller.
function fit(board: HTMLElement): void {
  const shares = new Map<string, number>();
  const all = [...board.querySelectorAll<HTMLElement>("[data-fit]")];
  for (const words of all) words.style.removeProperty("zoom");
  for (const words of all) {
    const around = words.parentElement!;
    const free = around.clientWidth - 2 * parseFloat(getComputedStyle(around).paddingLeft);
    const kind = words.dataset.fit!;
    shares.set(kind, Math.min(shares.get(kind) ?? 1, free / words.offsetWidth));
  }
  for (const words of all) {
    const share = Math.max(least_share, shares.get(words.dataset.fit!)!);
    if (share < 0.999) words.style.setProperty("zoom", String(share));
  }
}

function One({piece, labelledBy, stop, drawn}: {piece: Piece; labelledBy: string | null; stop: boolean; drawn: Drawn}) {
  switch (piece.kind) {
    case "text": return <Text id={piece.id} text={piece.of} drawn={drawn} />;
    case "button": return <Button id={piece.id} button={piece.of} stop={stop} drawn={drawn} />;
    case "slider": return <Slider id={piece.id} slider={piece.of} labelledBy={labelledBy} drawn={drawn} />;
    case "field": return <Field id={piece.id} field={piece.of} labelledBy={labelledBy} drawn={drawn} />;
  }
}

function Part({piece, labelledBy, drawn}: Placed & {drawn: Drawn}) {
  const reached = useSignal<string | null>(null);
  if (piece.kind !== "group") return <One piece={piece} labelledBy={labelledBy} stop drawn={drawn} />;
  const options = piece.pieces.filter(one => one.kind === "button" && one.of.enabled);
  const stop = options.find(one => one.id === reached.value) ?? options.find(one => one.kind === "button" && one.of.chosen) ?? options[0];
  return <div role="group" aria-labelledby={labelledBy ?? undefined} aria-label={labelledBy === null ? "Answer" : undefined}
      onFocusIn={event => { reached.value = (event.target as Element).id; }}>
    {piece.pieces.map(one => <One key={one.id} piece={one} labelledBy={labelledBy} stop={one === stop} drawn={drawn} />)}
  </div>;
}

export function BoardView({board, now, language}: {board: Board; now: SessionNow; language: string}) {
  const place = useRef<HTMLDivElement>(null);
  const since = useRef(0);
  const name = boardName.value;
  const {width, height} = room.value;
  const px = scaleOf(board, width - 2 * beside_px, height - 2 * over_px);
  const placed = laidOut(board);
  const mayPress = (event: MouseEvent) => {
    const age_ms = performance.now() - since.current;
    return event.detail === 0 || event.detail === 1 && age_ms >= tooSoon_ms;  // 0: by a key
  };
  const drawn: Drawn = {board, px, head: headOf(placed), mayPress};
  useLayoutEffect(() => {
    since.current = performance.now();
    (place.current?.querySelector("h1") ?? place.current)?.focus();
  }, [name]);
  useLayoutEffect(() => fit(place.current!));
  useEffect(() => {  // fonts that come later
    void document.fonts.ready.then(() => { if (place.current) fit(place.current); });
  }, []);
  return <main class="board-room" lang={language}>
    <div class="board" key={name} ref={place} tabIndex={-1} style={{width: `${px * board.width_m}px`, height: `${px * board.height_m}px`}}>
      {placed.map(one => <Part key={one.piece.id} {...one} drawn={drawn} />)}
      {board.progress !== null && <progress class="board-progress" aria-label="Progress" max={1} value={board.progress} />}
    </div>
    <div class="board-line" role="status">{now.notice && <p>{now.notice}</p>}</div>
    <div class="board-line under" role="status">{now.over && <p lang="en">That was all. You can close this window.</p>}</div>
  </main>;
}
