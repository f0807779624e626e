// What the screen is set to: light or dark, and whether things may move by themselves.
import {signal} from "@preact/signals";

const dark = matchMedia("(prefers-color-scheme: dark)");

export const scheme = signal(dark.matches ? "dark" : "light");
dark.addEventListener("change", () => { scheme.value = dark.matches ? "dark" : "light"; });

export const colour = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export const calm = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;
