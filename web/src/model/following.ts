// Controls that follow their words into another speech: another voice, or a text that was changed in places.
import {fps, type Control, type Span, type Word} from "./document.ts";
import {fitting, inOrder, nearestStart} from "./controls.ts";

interface Timed { readonly words: readonly Word[]; readonly duration_s: number }

const mostCells = 4e6;
const leastShare = 0.3;  // of words found again, below which it is another speech

const plain = (word: Word): string => word.word.toLowerCase();

// Pairs of places of the same words, in order: as many as there can be.
export function sameWords(before: readonly Word[], after: readonly Word[]): [number, number][] {
  const [a, b] = [before.map(plain), after.map(plain)];
  let first = 0;
  while (first < a.length && first < b.length && a[first] === b[first]) ++first;
  let last = 0;
  while (last < a.length - first && last < b.length - first && a[a.length - 1 - last] === b[b.length - 1 - last]) ++last;
  const pairs: [number, number][] = Array.from({length: first}, (_, k) => [k, k]);
  const [rows, columns] = [a.length - first - last, b.length - first - last];
  if (rows * columns <= mostCells) {
    // longest[i][j]: of the words from i and j on.
    const width = columns + 1;
    const longest = new Uint16Array((rows + 1) * width);
    for (let i = rows - 1; i >= 0; --i)
      for (let j = columns - 1; j >= 0; --j)
        longest[i * width + j] = a[first + i] === b[first + j] ? longest[(i + 1) * width + j + 1]! + 1
            : Math.max(longest[(i + 1) * width + j]!, longest[i * width + j + 1]!);
    for (let i = 0, j = 0; i < rows && j < columns;) {
      if (a[first + i] === b[first + j]) pairs.push([first + i++, first + j++]);
      else if (longest[(i + 1) * width + j]! >= longest[i * width + j + 1]!) ++i;
      else ++j;
    }
  }
  for (let k = last; k > 0; --k) pairs.push([a.length - k, b.length - k]);
  return pairs;
}

// From seconds of one speech to those of the other: words fall on words, evenly between; null for another speech.
export function timesInto(before: Timed, after: Timed): ((time_s: number) => number) | null {
  const pairs = sameWords(before.words, after.words);
  if (pairs.length === 0 || pairs.length < leastShare * Math.min(before.words.length, after.words.length)) return null;
  const points: [number, number][] = [[0, 0]];
  for (const [i, j] of pairs) {
    const [from, to] = [before.words[i]!, after.words[j]!];
    points.push([from.start_s, to.start_s], [from.end_s, to.end_s]);
  }
  points.push([before.duration_s, after.duration_s]);
  return time_s => {
    const next = points.findIndex(([at]) => at > time_s);
    if (next < 0) return after.duration_s;
    const [[a, x], [b, y]] = [points[Math.max(0, next - 1)]!, points[next]!];
    return b - a < 1e-9 ? x : x + (y - x) * (time_s - a) / (b - a);
  };
}

// Gestures keep their lengths, styles reach from word to word. What has no room in the other speech is left out.
export function following<T extends Control>(controls: readonly T[], before: Timed, after: Timed, total: number): T[] {
  const into = timesInto(before, after);
  if (!into) return fitting(controls, total);
  const frame = (old: number) => Math.round(into(old / fps) * fps);
  const placed: T[] = [];
  for (const control of inOrder(controls)) {
    const start = frame(control.start);
    const length = control.kind === "style" ? Math.max(1, frame(control.start + control.length) - start) : control.length;
    const at = nearestStart(placed as readonly Span[], length, start, total);
    if (at !== null) placed.push({...control, start: at, length});
  }
  return placed;
}
