// Looks at the report's page in Chromium (page.mjs): figures are where the analysis' numbers say. Data: simulated
// participants.
//   node check_report.mjs PROGRAM FOLDER STUDY PARTICIPANTS
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import {checkPage, meansStand, workplace} from "./page.mjs";

const [program, folder, study, participants] = process.argv.slice(2).map((word, k) => k < 2 ? path.resolve(word) : word);
const {at, run} = workplace(program, folder);
run("simulate", study, "--participants", participants, "--db", at("study.sqlite"));
run("report", at("study.sqlite"), "-o", at("report.html"), "--json", at("analysis.json"));
const analysis = JSON.parse(fs.readFileSync(at("analysis.json"), "utf8"));
const measures = analysis.measures.filter(one => one.kind !== "preference").map(one => one.measure);

function expected(figures) {
  const named = start => figures.filter(one => one.id.startsWith(start)).length;
  assert.equal(named("means-"), measures.length, "a box plot for each measure");
  assert.equal(named("differences-"), measures.filter(measure =>
      analysis.pairwise.some(pair => pair.measure === measure && pair.n > 0)).length, "differences for each measure");
  assert.equal(named("preferences"), analysis.preferences.length > 0 ? 1 : 0, "preferences");
  // The boxes' numbers are the analysis', and the diamonds stand where their means are.
  for (const [i, measure] of measures.entries()) {
    const figure = figures.find(one => one.id === `means-${i + 1}`);
    const systems = analysis.systems.filter(one => one[measure].n > 0).map(one => one[measure]);
    const drawnBy = layer => figure.spec.layer.find(layer);
    const medians = drawnBy(one => one.mark.strokeWidth === 2.5).data.values.map(one => one.y);
    assert.deepEqual(medians, systems.map(one => one.box.median), `${measure}: medians`);
    meansStand(figure.diamonds, systems.map(one => one.mean), measure);
    const scale = analysis.measures.find(one => one.measure === measure);
    for (const end of [scale.low, scale.high])
      assert.ok(figure.labels.includes(scale.kind === "accuracy" ? `${100 * end}\u00a0%` : String(end)),
          `${measure}: the scale's end ${end} among ${figure.labels}`);
    const differing = analysis.pairwise.filter(pair => pair.measure === measure && pair.significant).length;
    const stars = drawnBy(one => one.mark.type === "text" && one.encoding.text?.field === "stars").data.values;
    assert.equal(stars.length, differing <= 15 ? differing : 0, `${measure}: a bracket for each pair that differs`);
  }
}

const found = await checkPage({at, file: "report.html", systems: analysis.systems.map(one => one.system),
  printed: ["share of answers", "difference, "], plain: measures.length > 0 ? ["What the box plots show"] : [], expected});
console.log(`check_report: ${study}, ${participants} simulated participants: ${found}`);
