// Seconds that have begun, as minutes and seconds: 0:00 is shown when there are none.
export function inMinutes(seconds: number): string {
  const whole = Math.ceil(seconds - 1e-9);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}
