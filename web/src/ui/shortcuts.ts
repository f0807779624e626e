// Keys that work wherever the focus is, except where it types or has a use of its own for them.
import {addShown, copy, cut, flip, paste, remove, unmark} from "../actions/editing.ts";
import {chooseProject} from "../actions/files.ts";
import {generateGestures} from "../actions/generate.ts";
import {toggleBall} from "../actions/pointing.ts";
import {dropTried, keepTried, tryShown} from "../actions/trying.ts";
import {allControls} from "../model/controls.ts";
import {seek, toggle} from "../playback/player.ts";
import {say} from "../state/messages.ts";
import {atWork, offers} from "../state/mode.ts";
import {handling, inHand, trial} from "../state/posing.ts";
import {isManual, points} from "../state/server.ts";
import {ball, chosenCamera} from "../state/stage.ts";
import {duration, looping, muted, select, selection, snapping, studioDocument} from "../state/store.ts";
import {zoomBy} from "../timeline/scale.ts";
import {markEnd, markStart} from "../timeline/transport.tsx";
import {cameras} from "../view/cameras.ts";
import {redoAloud, save, undoAloud} from "./header.tsx";
import {helpOpen} from "./help.tsx";
import {addBlankStyle} from "./style_card.tsx";

const types = (element: Element) => element.matches("textarea, select, input:not([type=range])");
const spoken = () => duration.value > 0;

// With Ctrl (or Cmd). Those that type keep their own copying and undoing.
const commands: Record<string, {run: () => void; typing: boolean}> = {
  "enter": {run: () => void generateGestures("all"), typing: true},
  "shift+enter": {run: () => void generateGestures("range"), typing: true},
  "s": {run: save, typing: true},
  "o": {run: () => { if (offers("files")) chooseProject(); }, typing: true},
  "z": {run: undoAloud, typing: false},
  "shift+z": {run: redoAloud, typing: false},
  "y": {run: redoAloud, typing: false},
  "a": {run: () => select(...allControls(studioDocument.value).map(control => control.id)), typing: false},
  "c": {run: copy, typing: false},
  "x": {run: cut, typing: false},
  "v": {run: paste, typing: false},
};

function escape(): void {
  if (trial.value) dropTried();
  else if (ball.value) toggleBall();
  else if (selection.value.size > 0) select();
  else unmark();
}

const keys: Record<string, () => void> = {
  " ": toggle,
  "delete": remove,
  "backspace": remove,
  "d": remove,
  "f": () => flip(),
  "p": addShown,
  "s": () => { if (spoken() && !isManual.value) addBlankStyle(); },
  "t": tryShown,
  "k": keepTried,
  "r": () => { if (inHand.value) handling.value = handling.value === "turn" ? "move" : "turn"; },
  "b": () => { if (points.value) toggleBall(); },
  ...Object.fromEntries(cameras.map(([camera, name], k) => [String(k + 1), () => {
    chosenCamera.value = {camera};
    say(`Seen from: ${name}.`);
  }])),
  "i": () => { if (spoken()) markStart(); },
  "o": () => { if (spoken()) markEnd(); },
  "l": () => { looping.value = !looping.value; say(looping.value ? "Repeats." : "Plays once."); },
  "m": () => { muted.value = !muted.value; say(muted.value ? "Sound off." : "Sound on."); },
  "n": () => { snapping.value = !snapping.value; say(snapping.value ? "Snaps." : "Does not snap."); },
  "home": () => seek(0),
  "end": () => seek(studioDocument.value.speech?.duration_s ?? 0),
  "escape": escape,
  "+": () => zoomBy(1.5),
  "=": () => zoomBy(1.5),
  "-": () => zoomBy(1 / 1.5),
  "?": () => { helpOpen.value = true; },
};

export function startShortcuts(): void {
  window.addEventListener("keydown", event => {
    const at = event.target as Element;
    if (!atWork.value || event.defaultPrevented || event.altKey || document.querySelector("dialog[open]")) return;
    const key = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey) {
      const command = commands[`${event.shiftKey ? "shift+" : ""}${key}`];
      if (!command || types(at) && !command.typing) return;
      if (key === "c" && String(getSelection()) !== "") return;  // text on the page is copied
      event.preventDefault();
      command.run();
      return;
    }
    if (types(at)) return;
    // Buttons are pressed by space; what lies on the timeline has Enter for that.
    if (key === " " && at.matches("button:not(.control):not(.word), summary")) return;
    if (at.matches("input[type=range]") && ["home", "end", "+", "-"].includes(key)) return;
    const run = keys[key];
    if (!run) return;
    event.preventDefault();
    run();
  });
}
