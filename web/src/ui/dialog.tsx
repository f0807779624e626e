// A dialog of the page: it takes the focus, Escape closes it, and the focus goes back where it was.
import type {Signal} from "@preact/signals";
import type {ComponentChildren} from "preact";
import {useEffect, useRef} from "preact/hooks";
import {IconButton} from "./icon_button.tsx";

interface Props {
  open: Signal<boolean>;
  id: string;
  title: string;
  narrow?: boolean;
  mayClose?: () => boolean;  // false: it stays, having said why
  children: ComponentChildren;
}

export function Dialog({open, id, title, narrow, mayClose, children}: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  const isOpen = open.value;
  const shown = useRef(false);
  useEffect(() => {  // when its content is there, which may want the focus
    shown.current = isOpen;
    if (isOpen) dialog.current?.showModal();
    else dialog.current?.close();
  }, [isOpen]);
  const close = () => { if (mayClose?.() ?? true) open.value = false; };
  // Not by us: a browser closes at a second Escape without asking.
  const closed = () => {
    if (!shown.current || dialog.current?.open) return;
    if (mayClose?.() ?? true) open.value = false;
    else dialog.current?.showModal();
  };
  return <dialog class={narrow ? "dialog narrow" : "dialog"} ref={dialog} aria-labelledby={`${id}-title`}
      onCancel={event => {
        if (event.target !== event.currentTarget) return;  // of a file's choice within it
        event.preventDefault();
        close();
      }} onClose={closed}>
    <div class="panel-head">
      <h2 id={`${id}-title`}>{title}</h2>
      <IconButton icon="close" name="Close" keys="Esc" onClick={close} />
    </div>
    {isOpen && children}
  </dialog>;
}
