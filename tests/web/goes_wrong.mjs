// What the page says when things go wrong, and that nothing is lost.
import assert from "node:assert/strict";
import fs from "node:fs";
import {generate, projectOf, still, undrawn, visit} from "./visit.mjs";

const problem = page => page.getByRole("alert");

async function opens(page, file, words) {
  await page.setInputFiles("#project-file", file);
  await page.waitForFunction(start => document.querySelector("[role=alert]").textContent.includes(start), words);
}

// An older server, which has none of the routes that keep things, and no choice of systems: what it lacks is not offered.
async function older(place) {
  const {page, context, said} = await visit(place, {script: undrawn, expected: /Failed to load resource/, before: async one => {
    await one.route("**/v1/openapi.json", route => route.fulfill({status: 404, json: {error: {message: "none", field: null}}}));
    await one.route("**/v1/health", route => route.fulfill({json: {status: "ok", version: "0", commit: "0", systems: ["rules"], voices: ["slt"], synthetic: true}}));
  }});
  const [request] = await Promise.all([page.waitForRequest("**/v1/generate"), generate(page)]);
  assert.deepEqual(Object.keys(request.postDataJSON()).sort(), ["format", "seed", "speech_id"]);
  for (const name of ["Add own", "Rules", "Point", "Projects"]) assert.equal(await page.getByRole("button", {name, exact: true}).count(), 0, name);
  assert.equal(await page.locator(".options").count(), 0);
  assert.ok(await page.locator(".tile").count() > 0 && await page.getByRole("button", {name: "Range only"}).count() === 1);
  await page.keyboard.press("b");
  assert.equal(await page.locator(".handle.ball").count(), 0);
  assert.deepEqual(said, []);
  await context.close();
}

// Somebody else changes the rules while they are open here.
async function rulesMeet(place) {
  const {page, context} = await visit(place, {script: undrawn, expected: /412/});
  if (await page.getByRole("button", {name: "Rules", exact: true}).count() > 0) {
    const dialog = page.locator("dialog[open]");
    await page.getByRole("button", {name: "Rules", exact: true}).click();
    await dialog.waitFor();
    await page.evaluate(async () => {
      const [now, {motions: [first]}] = await Promise.all(["/v1/rules", "/v1/motions"].map(async path => (await fetch(path)).json()));
      await fetch("/v1/rules", {method: "PUT", headers: {"Content-Type": "application/json", "If-Match": `"${now.revision}"`}, body: JSON.stringify({rules: [{word: `theirs${now.rules.length}`, motions: [first.id]}]})});
    });
    await dialog.getByRole("button", {name: "Add a rule"}).click();
    await dialog.getByRole("textbox").last().fill("mine");
    await dialog.getByRole("combobox").last().selectOption({index: 1});
    for (let k = 0; k < 3; ++k) await page.keyboard.press("Escape");
    await page.getByText("Not saved yet").waitFor();
    assert.equal(await dialog.getByRole("textbox").last().inputValue(), "mine", "Escape drops nothing, however often");
    await dialog.getByRole("button", {name: "Save", exact: true}).click();
    await page.getByText("Somebody else has changed the rules").waitFor();
    await dialog.getByRole("button", {name: "Save mine over theirs"}).click();
    await dialog.waitFor({state: "detached"});
    const {rules} = await page.evaluate(async () => (await fetch("/v1/rules")).json());
    assert.equal(rules.at(-1).word, "mine");
  }
  await context.close();
}

export async function goesWrong(place) {
  await older(place);
  await rulesMeet(place);
  const {page, context, said} = await visit(place, {expected: /Failed to load resource/, script: undrawn});

  // A text that has no words.
  await page.fill("#text", "... !");
  await page.getByRole("button", {name: "Generate", exact: true}).click();
  await page.waitForFunction(() => document.querySelector("[role=alert]").textContent.length > 10);
  const refusal = await problem(page).textContent();
  assert.equal(await page.locator(".word").count(), 0);

  await generate(page);
  await still(page);
  const before = (await projectOf(page)).project;

  // Projects that are none, or newer.
  const file = place.at("other.json");
  fs.writeFileSync(file, JSON.stringify({...before, version: 99}));
  await opens(page, file, "version 99");
  fs.writeFileSync(file, "not a project");
  await opens(page, file, "not a project of the studio");
  fs.writeFileSync(file, JSON.stringify({...before, document: {...before.document, seed: -1}}));
  await opens(page, file, "the seed");
  assert.deepEqual((await projectOf(page)).project.document, before.document);

  // No room for a gesture.
  for (let k = 0; k < 40; ++k) await page.locator(".tile").first().click();
  await page.waitForFunction(() => document.querySelector("[role=alert]").textContent.includes("no gap"));

  // A second window on the same studio.
  const second = await context.newPage();
  await second.goto(place.server.page);
  await second.waitForFunction(() => document.querySelector("[role=alert]")?.textContent.includes("another window"));
  await second.close();

  // The server goes: said clearly, and a reload from its cache is not needed to go on.
  await page.route("**/v1/**", route => route.abort());
  await page.keyboard.press("Control+Enter");
  await page.waitForFunction(() => document.querySelector("[role=alert]").textContent.includes("does not answer"));
  const after = (await projectOf(page)).project.document;
  assert.deepEqual(after.motion, before.document.motion);
  assert.ok(await page.getByRole("button", {name: "Generate", exact: true}).isEnabled());
  assert.deepEqual(said, []);
  await context.close();
  return `an older server; rules that two change; "${refusal}"; foreign and newer projects, no room, a second window, a server that is gone: each said, nothing lost`;
}
