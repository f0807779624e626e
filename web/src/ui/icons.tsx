// Line icons, 20 by 20, drawn in the colour of the text around them.
const paths = {
  play: "M6.5 4.2v11.6l9-5.8z",
  pause: "M6.5 4.5v11M13.5 4.5v11",
  toStart: "M5 4.5v11M15 4.5 8 10l7 5.5z",
  loop: "M4 9V8a3 3 0 0 1 3-3h8m0 0-2.5-2.5M15 5l-2.5 2.5M16 11v1a3 3 0 0 1-3 3H5m0 0 2.5-2.5M5 15l2.5 2.5",
  sound: "M3.5 8v4H6.5l4 3.5v-11l-4 3.5zM13.5 7.5a3.5 3.5 0 0 1 0 5M15.5 5a7 7 0 0 1 0 10",
  silent: "M3.5 8v4H6.5l4 3.5v-11l-4 3.5zM13.5 8l4 4M17.5 8l-4 4",
  undo: "M7 5 3.5 8.5 7 12M4 8.5h7.5a4.5 4.5 0 0 1 0 7H8",
  redo: "M13 5l3.5 3.5L13 12M16 8.5H8.5a4.5 4.5 0 0 0 0 7H12",
  plus: "M10 4.5v11M4.5 10h11",
  minus: "M4.5 10h11",
  close: "M5.5 5.5l9 9M14.5 5.5l-9 9",
  bin: "M4 6h12M8 6V4h4v2M5.5 6l.7 10h7.6l.7-10M8.5 9v4.5M11.5 9v4.5",
  copy: "M7.5 7.5h8v8h-8zM12.5 7.5v-3h-8v8h3",
  flip: "M10 3.5v13M7.5 6 3 14h4.5zM12.5 6l4.5 8h-4.5z",
  help: "M7.5 7.5a2.5 2.5 0 1 1 3.6 2.2c-.7.4-1.1.9-1.1 1.8M10 14.5v.1",
  save: "M10 3.5v9m0 0L6.5 9M10 12.5 13.5 9M4 15.5h12",
  open: "M3.5 15.5v-10H8l1.5 2h7v8z",
  file: "M5.5 3.5h6l3 3v10h-9zM11.5 3.5v3h3",
  spark: "M10 3.5l1.6 4.4 4.4 1.6-4.4 1.6L10 15.5l-1.6-4.4L4 9.5l4.4-1.6z",
  range: "M4.5 4.5v11M15.5 4.5v11M4.5 10h11M7 7.5 4.5 10 7 12.5M13 7.5l2.5 2.5-2.5 2.5",
  magnet: "M5 4.5v6a5 5 0 0 0 10 0v-6h-3v6a2 2 0 0 1-4 0v-6zM5 7.5h3M12 7.5h3",
  microphone: "M10 3.5a2.3 2.3 0 0 1 2.3 2.3v4a2.3 2.3 0 0 1-4.6 0v-4A2.3 2.3 0 0 1 10 3.5zM5 9.5a5 5 0 0 0 10 0M10 14.5v2.5",
  eye: "M3 10s2.5-4.5 7-4.5S17 10 17 10s-2.5 4.5-7 4.5S3 10 3 10zM10 8a2 2 0 1 1 0 4 2 2 0 0 1 0-4z",
  noEye: "M3 10s2.5-4.5 7-4.5S17 10 17 10s-2.5 4.5-7 4.5S3 10 3 10zM4.5 15.5l11-11",
  search: "M8.5 4a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM12 12l4 4",
  hand: "M7 10V4.8a1.2 1.2 0 0 1 2.4 0V9m0-5.2a1.2 1.2 0 0 1 2.4 0V9m0-3.7a1.2 1.2 0 0 1 2.4 0v6.2c0 3-1.8 5-4.4 5-2 0-3-.8-4-2.4l-1.9-3.2c-.6-1.2 1-2 1.8-1L7 11.3",
  turn: "M15.5 10a5.5 5.5 0 1 1-1.8-4.1M14.5 3v3.2h-3.2",
  target: "M10 4a6 6 0 1 1 0 12 6 6 0 0 1 0-12zM10 8.2a1.8 1.8 0 1 1 0 3.6 1.8 1.8 0 0 1 0-3.6z",
  options: "M3.5 6h7M14.5 6h2M3.5 14h2M9.5 14h7M12.5 4a2 2 0 1 1 0 4 2 2 0 0 1 0-4zM7.5 12a2 2 0 1 1 0 4 2 2 0 0 1 0-4z",
  server: "M4 4.5h12v5H4zM4 9.5h12v5H4zM6.5 7h.1M6.5 12h.1M9 17h2",
  film: "M3.5 5h9v10h-9zM12.5 8.5l4-2.5v8l-4-2.5",
  rules: "M4 5.5h5M4 10h5M4 14.5h5M11.5 10h4.5m0 0-2-2M16 10l-2 2",
  pin: "M10 17v-5M6.5 12h7l-1.5-3V4.5h.8V3.5H7.2v1H8V9z",
} as const;

export type IconName = keyof typeof paths;

export function Icon({name}: {name: IconName}) {
  return <svg class={`icon icon-${name}`} viewBox="0 0 20 20" aria-hidden="true"><path d={paths[name]} /></svg>;
}
