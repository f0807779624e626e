// A button with an icon, its name for all, and the key that does the same.
import type {ComponentChildren} from "preact";
import {Icon, type IconName} from "./icons.tsx";

interface Props {
  icon: IconName;
  name: string;
  keys?: string;
  pressed?: boolean;
  disabled?: boolean;
  tabIndex?: number;
  onClick: () => void;
  children?: ComponentChildren;  // words beside the icon
}

export function IconButton({icon, name, keys, pressed, disabled, tabIndex, onClick, children}: Props) {
  return <button type="button" class={children ? "button" : "button icon-only"} aria-label={children ? undefined : name} aria-pressed={pressed}
      title={keys ? `${name} (${keys})` : name} disabled={disabled} tabIndex={tabIndex} onClick={onClick}>
    <Icon name={icon} />{children && <span>{children}</span>}
  </button>;
}
