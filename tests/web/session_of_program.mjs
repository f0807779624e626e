// A study's session with the program itself: consent, a trial by each means, a questionnaire, and what is kept of them.
import assert from "node:assert/strict";
import {execFileSync, spawn} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {atWork, button, headed, press} from "./session_visit.mjs";
import {undrawn} from "./visit.mjs";

const study = `[study]
name = "making"
title = "Making gestures"
seed = 7

[targets]
from_projects = "given"

[[systems]]
name = "SGT"
projects = "given"

[[systems]]
name = "MANUAL"
projects = "given"

[[layouts]]
name = "across"
viewer_m = [0, 3]
heading_deg = 180

[[stages]]
name = "consent"
kind = "consent"
text = """
Taking part

Do you agree to take part?"""

[[stages]]
name = "making"
kind = "authoring"
items = 2
systems = ["SGT", "MANUAL"]
system_meets = "nested"
block_by = "system"
layouts = ["across"]
question = "Make gestures that go with the speech."
keyframes_only = ["MANUAL"]
limit_s = 240
may_end_early = true

[[stages]]
name = "after"
kind = "questionnaire"
title = "About it"
questions = [
 {id = "intended", kind = "scale", text = "I could author as I intended.", scale = {low = 1, high = 7, labels = ["no", "yes"]}},
 {id = "demand", kind = "scale", text = "How demanding was it?", scale = {kind = "slider", low = 0, high = 100, labels = ["low", "high"]}},
 {id = "age", kind = "number", text = "How old are you?", low = 18, high = 99},
]

[[stages]]
name = "thanks"
kind = "instructions"
text = """
Thank you

That was all."""
`;

const project = (text, system) => JSON.stringify({format: "deixis-studio", version: 2, fps: 15, log: [], document: {name: text, text, voice: null, recording: null,
  seed: 1, speech: null, motion: null, poseControls: [], styleControls: [], range: null, bypass: {pose: false, style: false}, exact: false, system, variety: 0,
  finish: {fade: false, still: false, relaxedFingers: true}, byRules: false}});

async function begun(program, folder) {
  fs.mkdirSync(path.join(folder, "given"), {recursive: true});
  fs.writeFileSync(path.join(folder, "making.toml"), study);
  for (const [item, text] of [["hello", "Hello everybody, I am over here."], ["house", "This house is much bigger than the old one."]])
    for (const [name, system] of [["SGT", "model"], ["MANUAL", "keyframes"]]) fs.writeFileSync(path.join(folder, "given", `${item}.${name}.json`), project(text, system));
  const child = spawn(program, ["run", "making.toml", "--station", "studio", "--participant", "P01", "--no-browser"], {cwd: folder, stdio: ["ignore", "pipe", "inherit"]});
  let told = "";
  child.stdout.on("data", part => { told += part; });
  const ended = new Promise(resolve => child.on("exit", resolve));
  for (let k = 0; k < 600; ++k) {
    const address = /http:\S+token=\S+/.exec(told)?.[0];
    if (address) return {address, ended, stop: () => child.kill()};
    if (child.exitCode !== null) break;
    await new Promise(done => setTimeout(done, 100));
  }
  throw new Error(`the session does not begin: ${told}`);
}

async function trial(page, number) {
  await headed(page, `Trial ${number} of 2`);
  await atWork(page);
  const isManual = await page.locator(".style-track").count() === 0;
  await page.locator(".tile").nth(8).click();
  await button(page, "Generate").click();
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  if (number === 1) {
    await page.waitForTimeout(1200);
    await page.reload();
    await atWork(page);
    assert.equal(await page.locator(".control.pose").count(), 1, "a reload goes on with the work");
    await press(page, "Pause session");
    await page.locator(".board").waitFor();
    await page.waitForTimeout(500);
    await page.locator(".board-button").first().click();
    await atWork(page);
  }
  await button(page, "Finish").click();
  await page.locator("dialog[open]").getByRole("button", {name: "Finish"}).click();
  return isManual;
}

export async function sessionOfProgram({browser, program, at}) {
  if (!program) return "not without the program";
  const folder = at("session");
  const {address, ended, stop} = await begun(program, folder);
  try {
    const context = await browser.newContext({viewport: {width: 1280, height: 720}});
    await context.addInitScript(undrawn);
    const page = await context.newPage();
    page.setDefaultTimeout(60000);
    const said = [];
    page.on("pageerror", problem => said.push(String(problem)));
    page.on("response", answer => { if (answer.status() >= 400) said.push(`${answer.status()} ${answer.url()}`); });
    await page.goto(address);
    await headed(page, "Taking part");
    await page.waitForTimeout(500);
    await page.locator(".board-button.go_on").click();
    const manual = [await trial(page, 1), await trial(page, 2)];
    assert.deepEqual(manual.sort(), [false, true], "one by each means");

    await headed(page, "About it");
    await page.waitForTimeout(500);
    await button(page, "6").click();
    const slider = page.getByRole("slider");
    await slider.press("ArrowRight");
    await slider.press("ArrowRight");
    await page.getByRole("textbox").fill("31");
    await button(page, "Continue").click();
    await headed(page, "Thank you");
    await page.waitForTimeout(500);
    await page.locator(".board-button").first().click();
    await page.getByText("You can close this window").waitFor();
    assert.equal(await ended, 0);
    assert.deepEqual(said, []);
    await context.close();
  } finally {
    stop();
  }
  execFileSync(program, ["export", "making.sqlite", "-o", "data"], {cwd: folder, stdio: "ignore"});
  const kept = fs.readFileSync(path.join(folder, "data", "responses.csv"), "utf8").split(/\r?\n/);
  const trials = kept.filter(line => line.includes(",authoring,"));
  assert.deepEqual(trials.map(line => /,making,.*,(SGT|MANUAL),/.exec(line.slice(0, 200))[1]).sort(), ["MANUAL", "SGT"]);
  for (const line of trials) assert.match(line, /,2,1,0,1(,|$)/, "two edits, one pose, no style, generated once");
  assert.equal(kept.filter(line => line.includes(",after,questionnaire,")).length, 3);
  return "two trials and a questionnaire, kept";
}
