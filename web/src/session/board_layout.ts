// A board as a page: in which order its parts are read, what belongs together, and what names it.
import type {Board, BoardButton, BoardField, BoardSlider, BoardText, Box} from "../api/session.ts";

export type Piece = {readonly kind: "text"; readonly id: string; readonly of: BoardText} | {readonly kind: "button"; readonly id: string; readonly of: BoardButton} |
  {readonly kind: "slider"; readonly id: string; readonly of: BoardSlider} | {readonly kind: "field"; readonly id: string; readonly of: BoardField};
// Options of one question, and what stands between them.
export interface Group { readonly kind: "group"; readonly id: string; readonly pieces: readonly Piece[] }
export type Placed = {readonly piece: Piece | Group; readonly labelledBy: string | null};  // by the id of a text

const row_m = 0.03;  // what begins so near is in one row
const near_m = 0.06;
const same_m = 1e-3;

const topOf = ({of: {box}}: Piece) => box[1] + box[3];
const isQuestion = (text: BoardText) => text.bold && !/^[-\d\s]*$/.test(text.text);

// Which question an option belongs to: the steps of a rating, or one of a page's questions.
const questionOf = (id: number): string | null => id >= 1000 && id < 5000 ? String(Math.floor(id / 100)) : id > 100 && id < 200 ? "rating" : null;

// From the top, rows from the left.
function inOrder(board: Board): Piece[] {
  const all: Piece[] = [
    ...board.texts.map((of, k) => ({kind: "text" as const, id: `board-text-${k}`, of})),
    ...board.buttons.map(of => ({kind: "button" as const, id: `board-button-${of.id}`, of})),
    ...board.sliders.map(of => ({kind: "slider" as const, id: `board-slider-${of.id}`, of})),
    ...board.fields.map(of => ({kind: "field" as const, id: `board-field-${of.id}`, of})),
  ];
  all.sort((a, b) => topOf(b) - topOf(a));
  const rows: Piece[][] = [];
  for (const piece of all) {
    const row = rows.at(-1);
    if (row && topOf(row[0]!) - topOf(piece) < row_m) row.push(piece);
    else rows.push([piece]);
  }
  return rows.flatMap(row => row.sort((a, b) => a.of.box[0] - b.of.box[0]));
}

// Each part behind the question that it answers.
export function laidOut(board: Board): Placed[] {
  const pieces = inOrder(board);
  const placed: Placed[] = [];
  let question: string | null = null;
  for (let k = 0; k < pieces.length; ++k) {
    const piece = pieces[k]!;
    const key: string | null = piece.kind === "button" && piece.of.role === "option" ? questionOf(piece.of.id) : null;
    if (key === null) {
      if (piece.kind === "text" && isQuestion(piece.of)) question = piece.id;
      placed.push({piece, labelledBy: piece.kind === "slider" || piece.kind === "field" ? question : null});
      continue;
    }
    const last = pieces.findLastIndex(one => one.kind === "button" && one.of.role === "option" && questionOf(one.of.id) === key);
    placed.push({piece: {kind: "group", id: `board-group-${key}`, pieces: pieces.slice(k, last + 1)}, labelledBy: question});
    k = last;
  }
  return placed;
}

const isBeside = ([x, y, width, height]: Box, [tx, ty, , theight]: Box) =>
    tx >= x + width && tx - x - width <= near_m && ty < y + height && ty + theight > y;
const isUnder = ([x, y, width]: Box, [tx, ty, twidth, theight]: Box) => {
  const down = y - ty - theight;
  return down > -same_m && down < row_m && (Math.abs(tx - x) < same_m || Math.abs(tx + twidth - x - width) < same_m);
};

// What a step or a lettered option means: the ids of the texts right under it, or beside it.
export const describedBy = (board: Board, button: BoardButton): string[] => button.role !== "option" ? [] :
  board.texts.flatMap((text, k) => !text.bold && (isBeside(button.box, text.box) || isUnder(button.box, text.box)) ? [`board-text-${k}`] : []);

// The text that heads the board: its first bold one.
export const headOf = (placed: readonly Placed[]): string | null =>
    placed.find(({piece}) => piece.kind === "text" && isQuestion(piece.of))?.piece.id ?? null;

// Pixels of a metre, so that the board fits; letters are neither tiny nor huge, and a board that is too large scrolls.
const least_px = 560;
export function scaleOf({width_m, height_m}: Pick<Board, "width_m" | "height_m">, width_px: number, height_px: number): number {
  const most = Math.min(820, Math.max(640, 0.8 * height_px));
  return Math.max(least_px, Math.min(most, width_px / width_m, height_px / height_m));
}
