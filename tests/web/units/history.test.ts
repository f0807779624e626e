import assert from "node:assert/strict";
import {test} from "node:test";
import {advanced, canRedo, canUndo, startOf, stepOf, type History, type Step} from "../../../web/src/model/history.ts";
import {emptyDocument, fingerprint, frameCountOf, type StudioDocument} from "../../../web/src/model/document.ts";
import {fileNameOf, ProjectError, readProject, writeProject} from "../../../web/src/model/project.ts";
import {nextBorder, snapped, snappedShift, snapPoints} from "../../../web/src/model/snapping.ts";

const at = "2026-01-01T00:00:00Z";
const typed = (history: History, text: string, merge: string | null = null): Step =>
    stepOf(history.document, "type", at, merge, draft => { draft.text = text; })!;

test("undo goes back to the start, redo to the end, and an edit forgets what was undone", () => {
  let history = startOf(emptyDocument);
  const seen: string[] = [];
  for (const text of ["a", "ab", "abc"]) {
    history = advanced(history, typed(history, text));
    seen.push(history.document.text);
  }
  for (const text of ["ab", "a", ""]) {
    history = advanced(history, {kind: "undo", at});
    assert.equal(history.document.text, text);
  }
  assert.ok(!canUndo(history) && advanced(history, {kind: "undo", at}) === history);
  assert.deepEqual(history.document, emptyDocument);
  for (const text of seen) {
    history = advanced(history, {kind: "redo", at});
    assert.equal(history.document.text, text);
  }
  history = advanced(history, {kind: "undo", at});
  history = advanced(history, typed(history, "z"));
  assert.ok(!canRedo(history) && history.edits.length === 3);
  assert.equal(advanced(history, {kind: "undo", at}).document.text, "ab");
});

test("edits that merge are undone together; others are not", () => {
  let history = startOf(emptyDocument);
  for (const text of ["a", "ab", "abc"]) history = advanced(history, typed(history, text, "text"));
  assert.equal(history.edits.length, 1);
  const later = stepOf(history.document, "type", "2026-01-01T00:00:09Z", "text", draft => { draft.text = "later"; })!;
  assert.equal(advanced(history, later).edits.length, 2, "nor after a pause");
  history = advanced(history, {kind: "undo", at});
  assert.equal(history.document.text, "");
  history = advanced(history, {kind: "redo", at});
  assert.equal(history.document.text, "abc");
});

test("the same steps lead to the same document: the journal brings back everything", () => {
  let history = startOf(emptyDocument);
  const steps: Step[] = [];
  const take = (step: Step) => {
    steps.push(JSON.parse(JSON.stringify(step)));
    history = advanced(history, step);
  };
  take(typed(history, "one"));
  take(stepOf(history.document, "open", at, null, () => ({...emptyDocument, name: "Other", seed: 4}))!);
  take({kind: "undo", at});
  take(typed(history, "two", "text"));
  take(typed(history, "three", "text"));
  take({kind: "undo", at});
  take({kind: "redo", at});
  const again = steps.reduce(advanced, startOf(emptyDocument));
  assert.deepEqual(again.document, history.document);
  assert.equal(again.position, history.position);
});

test("a recipe that changes nothing is no step", () => {
  assert.equal(stepOf(emptyDocument, "nothing", at, null, draft => { draft.text = ""; }), null);
});

const frame = Array.from({length: 9}, () => [0, 1, 0]).flat();
const speech = {text: "Hello there", voice: null, recording: null, pitch: [0, 120, 118.5], pitch_fps: 100, duration_s: 1.01, words: [{word: "Hello", start_s: 0.1, end_s: 0.4},
  {word: "there", start_s: 0.45, end_s: 0.9}], accents: [{start_s: 0.1, end_s: 0.2, strength: 1, word: 0}], wav: "UklGRg=="};
const full: StudioDocument = {...emptyDocument, name: "Größe / test", text: "Hello there", speech, seed: 3,
  motion: {frames: Array(16).fill(frame), tracks: {fps: 15, bones: ["head"], rotations: Array(16).fill([0, 0, 0, 1])}, system: "s", synthetic: true, madeFrom: "x"},
  poseControls: [{kind: "pose", id: "p", start: 2, length: 3, name: "Point", base: [frame, frame], mirrored: true, rule: "a1"}],
  styleControls: [{kind: "style", id: "q", start: 4, length: 6, speed: 0, space: null, handedness: [{at: 0, value: -3}, {at: 0.25, value: 1.5}]}], range: {from: 3, to: 9}, recording: {id: "r", name: "mine.wav", wav: "UklGRg=="}, bypass: {pose: true, style: false}, exact: true,
  system: "rules", variety: 1.5, finish: {fade: true, still: false, relaxedFingers: false}, byRules: true, home: null};

test("a project comes back as it was written", () => {
  assert.deepEqual(readProject(writeProject(full, [])), full);
  assert.deepEqual(readProject(writeProject(emptyDocument, [])), emptyDocument);
  const file = writeProject({...full, home: "p1"}, []);
  assert.ok(!("home" in JSON.parse(file).document) && readProject(file).home === null, "a file is not the server's project");
});

test("a project of version 1 is read, and its motion still is of its controls", () => {
  const file = JSON.parse(writeProject({...full, styleControls: []}, []));
  const {system, variety, finish, byRules, ...document} = file.document;
  delete document.poseControls[0].rule;
  const before = readProject(JSON.stringify({...file, version: 1, document}));
  assert.deepEqual(before, {...full, styleControls: [], poseControls: [{...full.poseControls[0]!, rule: null}], system: null, variety: 0,
    finish: emptyDocument.finish, byRules: false});
  const same = {...emptyDocument, text: "Hello there", seed: 3, exact: true, poseControls: before.poseControls,
    styleControls: [{kind: "style" as const, id: "q", start: 4, length: 6, speed: 0, space: null, handedness: -3}]};
  assert.equal(fingerprint(same), "172cd265-323", "as the page of version 1 wrote it");
});

const refused = (change: (file: any) => void, words: RegExp) => {
  const file = JSON.parse(writeProject(full, []));
  change(file);
  assert.throws(() => readProject(JSON.stringify(file)), (problem: unknown) => problem instanceof ProjectError && words.test(problem.message));
};

test("a project that is not one is refused with what is wrong", () => {
  assert.throws(() => readProject("{"), /not JSON/);
  assert.throws(() => readProject("[]"), /not a project/);
  refused(file => { file.version = 3; }, /version 3.*newer/);
  refused(file => { delete file.version; }, /version/);
  refused(file => { file.document.text = 5; }, /the text should be text/);
  refused(file => { file.document.styleControls[0].speed = 3.5; }, /style control 1's speed should be a number from -3 to 3/);
  refused(file => { file.document.styleControls[0].handedness = [{at: 0, value: 0}]; }, /style control 1's handedness should be a number, null, or points/);
  refused(file => { file.document.styleControls[0].handedness[1].at = 0; }, /points in order/);
  refused(file => { file.document.styleControls[0].handedness[1].value = 4; }, /handedness, point 2 should be a number from -3 to 3/);
  refused(file => { file.document.variety = 3; }, /the variety/);
  refused(file => { delete file.document.finish.still; }, /whether it is still/);
  refused(file => { file.document.styleControls[0].length = 13; }, /style control 1's length should be/);
  refused(file => { file.document.poseControls[0].base[1].pop(); }, /pose control 1's frames, frame 2 should be 27 numbers/);
  refused(file => { file.document.poseControls.push({...file.document.poseControls[0], id: "r"}); }, /do not overlap/);
  refused(file => { file.document.motion.frames.pop(); }, /the motion should be 16 frames long/);
  refused(file => { file.document.motion.tracks.rotations[3] = [1]; }, /rotations of frame 4 should be 4 numbers/);
  refused(file => { file.document.speech.accents[0].word = 2; }, /accent 1's word/);
  refused(file => { file.document.range = {from: 5, to: 5}; }, /marked range's end/);
});

test("files are named after the project, in what any file system takes", () => {
  assert.equal(fileNameOf(full, "bvh"), "Größe-test.bvh");
  assert.equal(fileNameOf({...full, name: " ../.. "}, "bvh"), "untitled.bvh");
});

test("whether the motion is of these controls does not depend on names", () => {
  const used = {...full, bypass: {pose: false, style: false}};
  const [pose] = full.poseControls;
  assert.equal(fingerprint(used), fingerprint({...used, poseControls: [{...pose!, name: "Other"}]}));
  assert.notEqual(fingerprint(used), fingerprint({...used, poseControls: [{...pose!, start: 3}]}));
  assert.equal(fingerprint(full), fingerprint({...full, poseControls: [{...pose!, start: 3}]}), "bypassed ones do not count");
  assert.equal(fingerprint(used), fingerprint({...used, poseControls: [{...pose!, rule: null}], byRules: false, home: "p"}));
  for (const other of [{system: null}, {variety: 0}, {finish: {...full.finish, still: true}}])
    assert.notEqual(fingerprint(full), fingerprint({...full, ...other}));
  assert.notEqual(fingerprint(full), fingerprint({...full, seed: 4}));
  assert.notEqual(fingerprint(full), fingerprint({...full, styleControls: [{...full.styleControls[0]!, speed: null}]}));
});

test("a sound of n/15 s has n frames, a little more one more", () => {
  assert.deepEqual([0.001, 1, 1.0001, 2 / 15, 6.2, 1.066667, 1.0667].map(frameCountOf), [1, 15, 16, 2, 93, 16, 17]);
});

test("edges snap to words, accents and other controls within reach, to whole frames always", () => {
  const points = snapPoints(full, new Set(["p"]), 0.5);
  assert.ok(points.includes(0.45 * 15) && points.includes(4) && points.includes(10) && !points.includes(2));
  assert.equal(snapped(6.4, [6.75], 0.5), 7);
  assert.equal(snapped(6.4, [6.95], 0.5), 6);
  assert.equal(snapped(6.4, [6.75], 0), 6);
  assert.equal(snappedShift(10, 5, 2, [18], 2), 3, "the end goes to a point, the start is near none");
  assert.equal(snappedShift(10, 5, 2, [11.2, 18.9], 2), 1, "the start is nearer to a point than the end");
  assert.equal(snappedShift(10, 5, 2, [11.2, 17.3], 2), 2, "the end is nearer to a point than the start");
  assert.equal(snappedShift(10, 5, 2.4, [30], 2), 2);
});

test("the next word's border", () => {
  assert.equal(nextBorder(full, 0, 1), 2);
  assert.equal(nextBorder(full, 6, 1), 7);
  assert.equal(nextBorder(full, 7, -1), 6);
  assert.equal(nextBorder(full, 14, 1), 15);
  assert.equal(nextBorder(full, 0, -1), 0);
});
