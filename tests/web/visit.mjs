// The studio's page in Chromium, from the program's own server or from a stand-in for it.
import {spawn} from "node:child_process";
import fs from "node:fs";
import net from "node:net";
import path from "node:path";
import {chromium} from "playwright-core";
import {standIn} from "./stand_in.mjs";

const browserFile = () => ["chromium", "chromium-browser", "google-chrome"].flatMap(name =>
    process.env.PATH.split(":").map(place => path.join(place, name))).find(file => fs.existsSync(file));

const freePort = () => new Promise(resolve => {
  const server = net.createServer().listen(0, "127.0.0.1", () => {
    const {port} = server.address();
    server.close(() => resolve(port));
  });
});

async function programServes(program, folder) {
  const port = await freePort();
  const token = "of-the-tests";
  const child = spawn(program, ["serve", "--port", String(port), "--token", token, "--folder", folder], {stdio: ["ignore", "inherit", "inherit"]});
  const address = `http://127.0.0.1:${port}`;
  for (let k = 0; k < 300; ++k) {
    if (child.exitCode !== null) throw new Error(`${program} serve ended with ${child.exitCode}`);
    const answer = await fetch(`${address}/v1/health`, {headers: {Authorization: `Bearer ${token}`}}).catch(() => null);
    if (answer?.ok) return {address, page: `${address}/?token=${token}`, log: null, stop: () => child.kill()};
    await new Promise(done => setTimeout(done, 100));
  }
  child.kill();
  throw new Error(`${program} serve does not answer`);
}

// `session`: one that it runs (stand_in_session.mjs).
export async function standInServes(share, session = null) {
  const port = await freePort();
  const {server, log} = await standIn(path.join(share, "studio"), path.join(share, "avatar.glb"), port, session);
  const address = `http://127.0.0.1:${port}`;
  return {address, page: `${address}/`, log, stop: () => { server.close(); server.closeAllConnections(); }};
}

// `share`: the folder with studio/ and avatar.glb. With a program, that serves. Exit status 77: there is no Chromium.
export async function begin({share, out, program}) {
  if (!browserFile()) {
    console.log("tests/web: there is no Chromium (scripts/install.sh tests installs it); nothing was looked at");
    process.exit(77);
  }
  fs.rmSync(out, {recursive: true, force: true});
  fs.mkdirSync(out, {recursive: true});
  const server = program ? await programServes(program, path.join(out, "kept")) : await standInServes(share);
  const browser = await chromium.launch({executablePath: browserFile(),
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage"]});
  return {server, browser, program, share, at: name => path.join(out, name), async end() {
    await browser.close();
    server.stop();
  }};
}

// For sessions that look at no picture of the avatar: a machine of tests draws in software, slowly.
export function undrawn() {
  for (const name of ["drawElements", "drawArrays"]) WebGL2RenderingContext.prototype[name] = () => {};
}

// A new window with the page in it, and what the page complained about, asked for, and got. `expected`: complaints that a
// test provokes; `ready`: what shows that it has come.
export async function visit({server, browser}, {width = 1280, height = 720, dark = false, script = null, expected = /^$/, before = async () => {}, ready = "canvas.ready"} = {}) {
  const context = await browser.newContext({viewport: {width, height}, colorScheme: dark ? "dark" : "light", acceptDownloads: true});
  if (script) await context.addInitScript(script);
  const page = await context.newPage();
  page.setDefaultTimeout(60000);
  const said = [];
  const asked = [];
  const generated = [];
  page.on("console", message => {
    if (["error", "warning"].includes(message.type()) && !expected.test(message.text()) && !/GPU stall|GL Driver/.test(message.text())) said.push(message.text());
  });
  page.on("pageerror", problem => said.push(String(problem)));
  page.on("request", request => { if (!/^(data|blob):/.test(request.url())) asked.push(request.url()); });
  page.on("response", async response => {
    if (response.url().endsWith("/v1/generate") && response.ok()) generated.push(await response.json().catch(() => null));
  });
  await before(page);
  await page.goto(server.page);
  await page.waitForSelector(ready);
  await page.waitForSelector(".tile", {state: "attached"});
  return {page, context, said, asked, generated};
}

export const sentence = "Welcome, everybody. Over here on the left you find the entrance, and the big hall is right behind me.";

export async function generate(page, text = sentence) {
  await page.fill("#text", text);
  await page.getByRole("button", {name: "Generate", exact: true}).click();
  await page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
  await page.waitForSelector(".word");
}

// Stops the sound, which a generated motion begins with; on a slow machine it may have ended by itself.
export async function still(page) {
  await page.waitForFunction(() => document.querySelector(".play").getAttribute("aria-label") === "Pause" ||
      Number(document.querySelector(".ruler").getAttribute("aria-valuenow")) > 0);
  await page.evaluate(() => document.querySelector(".play[aria-label=Pause]")?.click());
  await page.locator(".play[aria-label=Play]").waitFor();
}

export const middleOf = async place => {
  const {x, y, width, height} = await place.boundingBox();
  return {x: x + width / 2, y: y + height / 2, left: x, right: x + width};
};

export async function drag(page, from, by, {keys = []} = {}) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (const key of keys) await page.keyboard.down(key);
  await page.mouse.move(from.x + by.x / 2, from.y + by.y / 2, {steps: 4});
  await page.mouse.move(from.x + by.x, from.y + by.y, {steps: 4});
  await page.mouse.up();
  for (const key of keys) await page.keyboard.up(key);
}

// What the project's file says now.
export async function projectOf(page) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Control+s")]);
  return {name: download.suggestedFilename(), file: await download.path(), project: JSON.parse(fs.readFileSync(await download.path(), "utf8"))};
}
