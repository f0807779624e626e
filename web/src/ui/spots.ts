// Keeps buttons where places of the avatar's picture are.
import type {RefObject} from "preact";
import {useEffect} from "preact/hooks";
import type {Point} from "../model/posing.ts";
import type {AvatarView} from "../view/avatar_view.ts";

// The k-th child of an element stands at the k-th place.
export function useSpots(view: AvatarView, parent: RefObject<HTMLElement | null>, places: readonly (() => Point | null)[]): void {
  useEffect(() => {
    const put = () => places.forEach((place, k) => {
      const button = parent.current?.children[k] as HTMLElement | undefined;
      const at = place();
      if (!button) return;
      button.hidden = !at;
      if (!at) return;
      const {x, y} = view.seen(at);
      button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    });
    view.drawn.add(put);
    put();
    return () => { view.drawn.delete(put); };
  }, [view]);
}
