// A number that is typed: what stands in the field is the person's until it is left or Enter is pressed, whatever else changes.
import {useSignal} from "@preact/signals";

interface Props { value: string; min: number | string; max: number | string; step: number | "any"; onChange: (value: number) => void; onKeyDown?: (event: KeyboardEvent) => void }

export function TypedNumber({value, min, max, step, onChange, onKeyDown}: Props) {
  const typed = useSignal<string | null>(null);
  return <input type="number" min={min} max={max} step={step} value={typed.value ?? value} onInput={event => { typed.value = event.currentTarget.value; }}
      onChange={event => {
        const wanted = event.currentTarget.valueAsNumber;
        typed.value = null;
        if (Number.isFinite(wanted)) onChange(wanted);
        event.currentTarget.value = value;
      }}
      onBlur={() => { typed.value = null; }} onKeyDown={event => {
        if (event.key === "ArrowUp" || event.key === "ArrowDown") typed.value = null;
        onKeyDown?.(event);
      }} />;
}
