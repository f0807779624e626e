// An effect of signals that runs at once, in the same frame of the screen as what it follows; useSignalEffect waits for the
// next one. From when the component is there until it goes.
import {effect} from "@preact/signals";
import {useEffect} from "preact/hooks";

export function useLiveEffect(run: () => void): void {
  useEffect(() => effect(run), []);
}
