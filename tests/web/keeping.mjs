// Projects on the server, two windows on the same one, and films.
import assert from "node:assert/strict";
import fs from "node:fs";
import {generate, projectOf, visit} from "./visit.mjs";
import {has} from "./authoring.mjs";

const button = (page, name) => page.getByRole("button", {name, exact: true});
const says = (page, words) => page.waitForFunction(part => document.querySelector(".messages").textContent.includes(part), words);

async function projects(place, page, context) {
  const name = `Tour ${Date.now()}`;
  await page.getByLabel("The project's name").fill(name);
  await button(page, "Projects").click();
  await button(page, "Save here").click();
  await says(page, "saved on the server");
  await page.fill("#text", "Hello here.");
  await page.keyboard.press("Control+s");
  await says(page, "saved on the server");

  // A second window on it saves first.
  const second = await context.newPage();
  await second.goto(place.server.page);
  await second.waitForSelector("canvas.ready");
  await button(second, "Projects").click();
  await second.locator(".project-open").filter({hasText: name}).click();
  await says(second, "This project is open in another window");
  await second.fill("#text", "Theirs.");
  await second.keyboard.press("Control+s");
  await says(second, "saved on the server");
  await second.close();

  // The first window is told; neither version is lost.
  await page.fill("#text", "Mine.");
  await page.keyboard.press("Control+s");
  await page.getByRole("dialog", {name: "Somebody else has saved this project"}).waitFor();
  await page.screenshot({path: place.at("conflict.png")});
  await button(page, "Save mine beside it").click();
  await says(page, `${name} (mine) is saved`);
  assert.equal(await page.inputValue("#text"), "Mine.");
  await button(page, "Projects").click();
  await page.locator(".project").nth(1).waitFor();
  await page.screenshot({path: place.at("projects.png")});
  await page.keyboard.press("Escape");
  await button(page, "Projects").click();
  await page.locator(".project-open").filter({hasText: name}).filter({hasNotText: "(mine)"}).click();
  await page.waitForFunction(() => document.querySelector("#text").value === "Theirs.");
  await page.getByRole("button", {name: /^Undo/}).click();
  assert.equal(await page.inputValue("#text"), "Mine.", "undo brings back what was there");

  // Deleted there; what is open stays here.
  await button(page, "Projects").click();
  const row = page.locator(".project.here");
  await row.getByRole("button", {name: /^Delete/}).click();
  await button(page, "Delete for good").click();
  await row.waitFor({state: "detached"});
  assert.equal(await page.inputValue("#text"), "Mine.", "what is open stays");
  await page.keyboard.press("Escape");
  await button(page, "New").click();
}

async function films(place, page) {
  await generate(page, "Hello.");
  await button(page, "Film").click();
  await page.getByRole("radio", {name: "640 × 360"}).click();
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, "Make the film").click()]);
  const bytes = fs.readFileSync(await download.path());
  assert.match(download.suggestedFilename(), /\.webm$/);
  assert.equal(bytes.readUInt32BE(0), 0x1a45dfa3, "it is WebM");
  assert.ok(bytes.includes("V_VP9") && bytes.includes("A_OPUS"));
  const {duration_s} = (await projectOf(page)).project.document.speech;
  const length_s = await page.evaluate(async data => {
    const video = document.createElement("video");
    video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(data), one => one.charCodeAt(0))], {type: "video/webm"}));
    await new Promise((resolve, reject) => { video.onloadedmetadata = resolve; video.onerror = () => reject(video.error); });
    return video.duration;
  }, bytes.toString("base64"));
  assert.ok(Math.abs(length_s - duration_s) < 0.05, `${length_s} s of ${duration_s} s`);

  // Cancelled; and where the browser cannot.
  await button(page, "Film").click();
  await button(page, "Make the film").click();
  await page.locator("progress").waitFor();
  await page.locator("dialog[open]").getByRole("button", {name: "Cancel"}).click();
  await page.getByText("The film was cancelled").waitFor();
  await page.evaluate(() => { delete globalThis.VideoEncoder; });
  await button(page, "Make the film").click();
  await page.getByText("This browser cannot write the film").waitFor();
  await page.keyboard.press("Escape");
  return `${(bytes.length / 1000).toFixed(0)} KB of film for ${length_s.toFixed(2)} s`;
}

export async function keeping(place) {
  const {page, context, said} = await visit(place, {expected: /412/});
  const keeps = await has(page, "Projects");
  if (keeps) await projects(place, page, context);
  const film = await films(place, page);
  assert.deepEqual(said, []);
  await context.close();
  return `${keeps ? "projects kept, two windows told apart" : "this server keeps no projects"}; ${film}`;
}
