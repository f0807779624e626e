// The last message: shown, and read out by screen readers, problems at once.
import {message, dismiss} from "../state/messages.ts";
import {IconButton} from "./icon_button.tsx";

export function Messages() {
  const shown = message.value;
  const words = (kind: "said" | "problem") => shown?.kind === kind ? <span key={shown.number}>{shown.text}</span> : null;
  return <div class={shown ? `messages ${shown.kind}` : "messages empty"}>
    <div role="status" aria-live="polite">{words("said")}</div>
    <div role="alert">{words("problem")}</div>
    {shown?.action && <button type="button" class="button small" onClick={() => {
      dismiss();
      shown.action!.run();
    }}>{shown.action.name}</button>}
    {shown && <IconButton icon="close" name="Close the message" onClick={dismiss} />}
  </div>;
}
