// What docs/studio-tour.md says, step by step, with its pictures. It needs the program: gestures are its own.
import assert from "node:assert/strict";
import {drag, generate, middleOf, projectOf, still, visit} from "./visit.mjs";

const text = "Welcome, everybody. This house is much bigger than the old one, and the garden is right behind me.";
const button = (page, name) => page.getByRole("button", {name, exact: true});
const upToDate = page => page.waitForFunction(() => document.querySelector(".state").textContent.startsWith("Gestures are up to date"));
const word = (page, spoken) => page.locator(".word").filter({hasText: spoken}).first();

async function again(page) {
  await button(page, "Generate").click();
  await upToDate(page);
  await still(page);
}

export async function tour(place) {
  if (!place.program) return "not without the program";
  const {page, context, said} = await visit(place);
  let pictures = 0;
  const picture = async () => {
    await page.evaluate(() => document.querySelectorAll("[aria-label='Close the message']").forEach(close => close.click()));
    await page.mouse.move(640, 90); // where nothing lights up
    await page.waitForTimeout(600);
    await page.screenshot({path: place.at(`tour-${++pictures}.png`)});
  };

  // A text becomes speech and gestures.
  await generate(page, text);
  await still(page);
  await word(page, "bigger").click();
  await picture();

  // A gesture on a word.
  await page.getByRole("searchbox").fill("big");
  await page.waitForFunction(() => document.querySelectorAll(".tile").length < 10);
  await word(page, "bigger").click();
  await page.locator(".tile").first().click();
  const pose = page.locator(".control.pose");
  await pose.waitFor();
  await page.getByRole("searchbox").fill("");
  await again(page);
  const block = await middleOf(pose);
  await pose.click();
  await page.locator(".ruler").click({position: {x: block.x - (await page.locator(".ruler").boundingBox()).x, y: 10}});
  const wrist = page.getByRole("button", {name: "Left wrist of the pose"});
  await wrist.waitFor();
  await page.waitForTimeout(500);
  await drag(page, await middleOf(wrist), {x: 30, y: -50});
  await picture();
  await again(page);

  // A style for the beginning.
  await page.keyboard.press("Escape");
  await word(page, "Welcome").dblclick();
  await button(page, "Happy").click();
  await page.locator(".control.style").waitFor();
  await picture();

  // The ball behind.
  await page.keyboard.press("Escape");
  await word(page, "behind").click();
  await button(page, "Point").click();
  await page.getByText(/hand, [\d.]+° off/).waitFor();
  await page.getByLabel("Left (m)").fill("1.2");
  await page.getByLabel("Left (m)").press("Enter");
  await page.getByLabel("Ahead (m)").fill("-0.4");
  await page.getByLabel("Ahead (m)").press("Enter");
  await page.waitForTimeout(300);
  await picture();
  await page.getByRole("button", {name: "Point here at"}).click();
  await button(page, "Put the ball away").click();
  await again(page);

  // To a file.
  const {project} = await projectOf(page);
  assert.deepEqual(project.document.poseControls.map(one => one.name).length, 2);
  assert.equal(project.document.styleControls.length, 1);
  const [bvh] = await Promise.all([page.waitForEvent("download"), button(page, "BVH").click()]);
  assert.match(bvh.suggestedFilename(), /\.bvh$/);
  await button(page, "Film").click();
  await page.locator("dialog[open]").waitFor();
  assert.deepEqual(said, []);
  await context.close();
  return `${pictures} pictures`;
}
