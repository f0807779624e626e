// An effect of signals that runs at once, in the same frame of the screen as what it follows; useSignalEffect waits for the
// next one. From when the component stands in the page, before anybody sees it, until it goes.
import {effect} from "@preact/signals";
import {useLayoutEffect} from "preact/hooks";

export function useLiveEffect(run: () => void): void {
  useLayoutEffect(() => effect(run), []);
}
