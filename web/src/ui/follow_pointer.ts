// Follows one pointer from its press on an element until it is let go, or given up by Escape or by the system.
export interface Following {
  moved(event: PointerEvent): void;
  ended(kept: boolean): void;
}

export function followPointer(event: PointerEvent, {moved, ended}: Following): void {
  const target = event.currentTarget as HTMLElement;
  target.setPointerCapture(event.pointerId);
  const stop = new AbortController();
  const end = (kept: boolean) => {
    stop.abort();
    ended(kept);
  };
  target.addEventListener("pointermove", moved, {signal: stop.signal});
  target.addEventListener("pointerup", () => end(true), {signal: stop.signal});
  target.addEventListener("pointercancel", () => end(false), {signal: stop.signal});
  window.addEventListener("keydown", next => {
    if (next.key !== "Escape") return;
    next.stopPropagation();
    end(false);
  }, {signal: stop.signal, capture: true});
}
