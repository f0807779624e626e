// What the page says when things go wrong, and that nothing is lost.
import assert from "node:assert/strict";
import fs from "node:fs";
import {generate, projectOf, still, visit} from "./visit.mjs";

const problem = page => page.getByRole("alert");

async function opens(page, file, words) {
  await page.setInputFiles("#project-file", file);
  await page.waitForFunction(start => document.querySelector("[role=alert]").textContent.includes(start), words);
}

export async function goesWrong(place) {
  const {page, context, said} = await visit(place, {expected: /Failed to load resource/});

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
  return `"${refusal}"; foreign and newer projects, no room, a second window, a server that is gone: each said, nothing lost`;
}
