// Looks at the evaluation's page in Chromium (page.mjs): figures are where the evaluation's numbers say. Clips: those of the
// built-in systems at the points of a grid.
//   node check_evaluation.mjs PROGRAM FOLDER POINTS SYSTEM...
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import {checkPage, meansStand, workplace} from "./page.mjs";

const [program, folder, points, ...systems] = process.argv.slice(2).map((word, k) => k < 2 ? path.resolve(word) : word);
const {at, run} = workplace(program, folder);
fs.writeFileSync(at("grid.csv"), run("targets", "--grid", points));
for (const system of systems) run("generate", system, "--targets", at("grid.csv"), "--out", at(system));
run("evaluate", ...systems.map(at), "-o", at("evaluation.html"), "--json", at("evaluation.json"));
const evaluation = JSON.parse(fs.readFileSync(at("evaluation.json"), "utf8"));

function expected(figures) {
  const named = start => figures.filter(one => one.id.startsWith(start));
  const count = evaluation.systems.length;
  for (const [start, wanted] of [["accuracy", 2], ["differences", count > 1 ? 1 : 0], ["reward-", count],
    ["speed-", count], ["density-", count + 2]])
    assert.equal(named(start).length, wanted, `figures ${start}`);

  const means = evaluation.systems.map(one => one.accuracy.mean);
  meansStand(figures.find(one => one.id === "accuracy").diamonds, means, "accuracy");

  // A point or diamond for each clip that is drawn, and a dot for each test point, at its colour.
  evaluation.systems.forEach((system, k) => {
    const drawn = figures.find(one => one.id === `density-${k + 1}`);
    assert.ok(drawn.marks >= Math.min(system.n, 500), `clips of ${system.system}: ${drawn.marks}`);
  });
  const space = figures.find(one => one.id === "density-space");
  assert.ok(space.marks >= Math.min(evaluation.targets.length, 1000), `test points: ${space.marks}`);
  // The view of space keeps its proportions: its height follows its width.
  const {left, right, top, bottom} = space.frame;
  const share = (bottom - top) / (right - left);
  assert.ok(share > 0.5 && share < 0.9, `proportions of the space: ${share}`);
}

const found = await checkPage({at, file: "evaluation.html", systems, printed: ["accuracy (Eq. 2)"],
  plain: ["What the box plots show", "Reward around the time of pointing", "deixis evaluate --csv"], expected});
console.log(`check_evaluation: ${systems.join(", ")} at ${points} points: ${found}`);
