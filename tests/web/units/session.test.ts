// A session's logic: the order of a board's parts, its size, the clock's words, and the edits that are told.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import test from "node:test";
import {describedBy, headOf, laidOut, scaleOf} from "../../../web/src/session/board_layout.ts";
import {doneBy, gathered, isGenerated, sent, type Done} from "../../../web/src/session/edits.ts";
import {inMinutes} from "../../../web/src/session/minutes.ts";
import {advanced, startOf, stepOf, type History, type Step} from "../../../web/src/model/history.ts";
import {emptyDocument, type StudioDocument} from "../../../web/src/model/document.ts";
import type {Board} from "../../../web/src/api/session.ts";

const boards = JSON.parse(fs.readFileSync(path.join(process.env.TESTS_WEB!, "session_boards.json"), "utf8")) as Record<string, Board>;

test("parts are read from the top, answers behind their questions", () => {
  const placed = laidOut(boards.survey!);
  const words = placed.map(({piece}) => piece.kind === "text" ? piece.of.text : piece.kind === "button" ? `[${piece.of.label}]` : piece.kind);
  assert.deepEqual(words, ["About what you have just done", "Please say how much you agree.", "I could author gestures as I intended.", "group", "strongly disagree",
    "strongly agree", "The gestures that I made were appropriate to the speech.", "group", "strongly disagree", "strongly agree", "How mentally demanding was the\ntask?", "slider",
    "Please answer all questions.", "[Continue]", "Page 1 of 3"]);
  assert.equal(headOf(placed), "board-text-0");
  const textOf = (id: string | null) => boards.survey!.texts[Number(id!.slice("board-text-".length))]!.text;
  assert.deepEqual(placed.filter(one => one.labelledBy !== null).map(one => textOf(one.labelledBy)),
      ["I could author gestures as I intended.", "The gestures that I made were appropriate to the speech.", "How mentally demanding was the\ntask?"]);
});

test("steps are described by their labels, lettered options by what stands beside them", () => {
  const meaning = (board: Board, id: number) => describedBy(board, board.buttons.find(one => one.id === id)!).map(text => board.texts[Number(text.slice(11))]!.text);
  assert.deepEqual([1000, 1001, 1005, 1006].map(id => meaning(boards.survey!, id)), [["strongly disagree"], [], [], ["strongly agree"]]);
  assert.match(meaning(boards.long!, 1000)[0]!, /^I first thought/);
  assert.deepEqual(meaning(boards.long!, 1001), []);
  assert.deepEqual(meaning(boards.survey!, 1), []);
});

test("each part stands once, whatever the board", () => {
  for (const [name, board] of Object.entries(boards)) {
    const ids = laidOut(board).flatMap(({piece}) => piece.kind === "group" ? piece.pieces.map(one => one.id) : [piece.id]);
    assert.equal(new Set(ids).size, ids.length, name);
    assert.equal(ids.length, board.texts.length + board.buttons.length + board.sliders.length + board.fields.length, name);
  }
});

test("boards fit the windows of laboratories, in letters of about 16 px", () => {
  for (const [name, board] of Object.entries(boards))
    for (const [width, height] of [[1280, 720], [1920, 1080], [2560, 1440]] as const) {
      const px = scaleOf(board, width - 64, height - 36);
      assert.ok(px * board.width_m <= width && px * board.height_m <= height, `${name} at ${width} by ${height}`);
      for (const text of board.texts) assert.ok(px * text.size_m / 1.36 > 15, `${name}: ${text.text}`);
    }
});

test("times are told in minutes and seconds that have begun", () => {
  assert.deepEqual([300, 299.2, 60, 59.9, 9.01, 0.1, 0].map(inMinutes), ["5:00", "5:00", "1:00", "1:00", "0:10", "0:01", "0:00"]);
});

const begun: StudioDocument = {...emptyDocument, seed: 3};
function edited(history: History, label: string, recipe: Parameters<typeof stepOf>[4], merge: string | null = null): {step: Step; after: History} {
  const step = stepOf(history.document, label, "2026-01-01T00:00:00Z", merge, recipe)!;
  return {step, after: advanced(history, step)};
}

test("edits are told with what they change; motions by their origin alone", () => {
  const {step, after} = edited(startOf(begun), "Generate", draft => {
    draft.motion = {frames: [[1]], tracks: {fps: 15, bones: [], rotations: [[]]}, system: "model", synthetic: true, madeFrom: "abc"};
  });
  assert.ok(isGenerated(step));
  assert.deepEqual(sent(doneBy(step, after, 12.34567)), {at_s: 12.346, what: "Generate", patch: [{op: "replace", path: ["motion"], value: {madeFrom: "abc", system: "model"}}]});
  const undo: Step = {kind: "undo", at: ""};
  const undone = advanced(after, undo);
  assert.deepEqual(sent(doneBy(undo, undone, 13)), {at_s: 13, what: "Undo: Generate", patch: [{op: "replace", path: ["motion"], value: null}]});
  const redo: Step = {kind: "redo", at: ""};
  assert.equal(doneBy(redo, advanced(undone, redo), 14).what, "Redo: Generate");
  assert.ok(!isGenerated(undo));
});

test("a slider's steps are one edit, its last", () => {
  let history = startOf(begun);
  let all: readonly Done[] = [];
  for (const [label, seed, merge] of [["Change the version", 4, "seed"], ["Change the version", 5, "seed"], ["Other", 6, null], ["Change the version", 7, "seed"]] as const) {
    const {step, after} = edited(history, label, draft => { draft.seed = seed; }, merge);
    all = gathered(all, doneBy(step, after, seed));
    history = after;
  }
  assert.deepEqual(all.map(one => [one.at_s, one.what]), [[5, "Change the version"], [6, "Other"], [7, "Change the version"]]);
});
