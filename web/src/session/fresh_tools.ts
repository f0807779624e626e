// Each trial begins with the page as it is at first: nothing is left of the one before.
import {forgetCopied} from "../actions/editing.ts";
import {addingSpeed, searched} from "../state/library.ts";
import {dismiss} from "../state/messages.ts";
import {endTrial, handling} from "../state/posing.ts";
import {ball, chosenCamera} from "../state/stage.ts";
import {looping, muted, snapping} from "../state/store.ts";

export function freshTools(): void {
  forgetCopied();
  endTrial();
  dismiss();
  handling.value = "move";
  ball.value = null;
  chosenCamera.value = {camera: "front"};
  searched.value = "";
  addingSpeed.value = 1;
  [looping.value, muted.value, snapping.value] = [false, false, true];
}
