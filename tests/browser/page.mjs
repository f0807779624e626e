// What is looked at on every page of figures in Chromium, as people would: every figure drawn, at three widths, on light
// and dark screens, on paper, by keyboard and without JavaScript.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {pathToFileURL} from "node:url";
import puppeteer from "puppeteer-core";

const widths = [400, 1000, 1600];

// A new, empty folder, and what runs the program in it. Exit status 77: there is no Chromium.
export function workplace(program, folder) {
  if (!chromium()) {
    console.log("tests/browser: there is no Chromium (scripts/install.sh tests installs it); nothing was looked at");
    process.exit(77);
  }
  fs.rmSync(folder, {recursive: true, force: true});
  fs.mkdirSync(folder, {recursive: true});
  return {
    at: name => path.join(folder, name),
    run: (...words) => execFileSync(program, words, {cwd: folder, stdio: ["ignore", "pipe", "inherit"], encoding: "utf8"}),
  };
}

function chromium() {
  return ["chromium", "chromium-browser", "google-chrome"].flatMap(name =>
      process.env.PATH.split(":").map(place => path.join(place, name))).find(file => fs.existsSync(file));
}

// What a figure shows, and whether anything of it is cut off or lies on something else.
export const figuresOf = page => page.evaluate(() => [...document.querySelectorAll("figure")].map(figure => {
  const svg = figure.querySelector(".chart-wrapper svg, .drawing > svg");
  const box = element => { const {left, top, right, bottom} = element.getBoundingClientRect(); return {left, top, right, bottom}; };
  const turned = text => /rotate\((?!0)/.test(text.getAttribute("transform") ?? "");
  const frame = svg ? box(svg) : null;
  const seen = text => text.textContent.trim() !== "" && getComputedStyle(text).opacity !== "0";
  const texts = svg ? [...svg.querySelectorAll("text")].filter(seen) : [];
  const cut = texts.filter(text => {
    const one = box(text);
    const slack = turned(text) ? 7 : 1;  // the corners of a slanting line's box are empty
    return one.left < frame.left - slack || one.right > frame.right + slack || one.top < frame.top - slack ||
        one.bottom > frame.bottom + slack;
  });
  const labels = svg ? [...svg.querySelectorAll(".role-axis-label text")].filter(seen).map(text => ({...box(text), words: text.textContent,
      turned: turned(text)})) : [];
  const over = [];
  for (const a of labels)
    for (const b of labels)
      if (a !== b && !a.turned && !b.turned && a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 2 &&
          b.top < a.bottom - 2)
        over.push(a.words + " / " + b.words);
  return {
    id: figure.id, label: figure.getAttribute("aria-label"), drawn: figure.dataset.drawn === "yes",
    spec: JSON.parse(figure.querySelector("script").textContent),
    drawingLabel: figure.querySelector(".chart-wrapper")?.getAttribute("aria-label"), frame, whole: box(figure),
    marks: svg ? svg.querySelectorAll(".mark-symbol path, .mark-rect path, .mark-rule line, .mark-line path").length : 0,
    labels: labels.map(label => label.words), cut: cut.map(text => text.textContent), over,
    diamonds: svg ? [...svg.querySelectorAll(".mark-symbol path[stroke='#1c1c1a']")].map(path => {
      const {top, bottom} = box(path);
      return 0.5 * (top + bottom);
    }) : [],
  };
}));

// The diamonds of box plots stand where the means are that they show.
export function meansStand(diamonds, means, words) {
  assert.equal(diamonds.length, means.length, `${words}: a mean for each system`);
  const low = means.indexOf(Math.min(...means));
  const high = means.indexOf(Math.max(...means));
  if (means[high] - means[low] < 0.01) return;
  means.forEach((mean, k) => {
    const wanted = diamonds[low] + (mean - means[low]) / (means[high] - means[low]) * (diamonds[high] - diamonds[low]);
    assert.ok(Math.abs(diamonds[k] - wanted) <= 1, `${words}: height of mean ${k + 1}: ${diamonds[k]} and ${wanted}`);
  });
}

const luminance = ([r, g, b]) => [r, g, b].map(part => part / 255)
    .map(part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4)
    .reduce((sum, part, k) => sum + part * [0.2126, 0.7152, 0.0722][k], 0);
const contrast = (a, b) => (Math.max(luminance(a), luminance(b)) + 0.05) / (Math.min(luminance(a), luminance(b)) + 0.05);

// The browser with one page's file in it.
class Visit {
  said = [];  // what the page complained about
  asked = [];  // what it asked for besides itself

  constructor(browser, file) {
    this.browser = browser;
    this.file = file;
  }

  async opened(width, {dark = false, script = true} = {}) {
    const page = await this.browser.newPage();
    page.setDefaultTimeout(120000);
    page.on("console", message => { if (["error", "warn"].includes(message.type())) this.said.push(message.text()); });
    page.on("pageerror", error => this.said.push(String(error)));
    page.on("request", request => {
      if (!/^(data|blob):/.test(request.url()) && !request.isNavigationRequest()) this.asked.push(request.url());
    });
    await page.setJavaScriptEnabled(script);
    await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: dark ? "dark" : "light"}]);
    await page.setViewport({width, height: 900});
    await page.goto(pathToFileURL(this.file).href);
    if (script)
      await page.waitForFunction(() =>
          [...document.querySelectorAll("figure")].every(figure => figure.dataset.drawn || figure.querySelector(".failed")));
    return page;
  }
}

// At each width: drawn, nothing cut, nothing wider than the screen.
async function checkWidths(visit, at, expected) {
  for (const width of widths) {
    const page = await visit.opened(width);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= width, `the page is ${wide} px wide on a screen of ${width} px`);
    const figures = await figuresOf(page);
    for (const figure of figures) {
      const where = `${figure.id} at ${width} px`;
      assert.ok(figure.drawn, `${where} is drawn`);
      assert.ok(figure.marks >= 3, `${where} has marks: ${figure.marks}`);
      assert.ok(figure.frame.right - figure.frame.left > 200, `${where} is wide enough`);
      assert.ok(figure.frame.right <= figure.whole.right + 1, `${where} keeps to its place`);
      assert.deepEqual(figure.cut, [], `${where}: words are cut`);
      assert.deepEqual(figure.over, [], `${where}: labels lie on each other`);
      assert.ok(figure.label.length > 40 && figure.drawingLabel === figure.label, `${where} tells what it shows`);
    }
    expected(figures);
    // What scrolls is reached by keyboard, and has a name.
    const scrolls = await page.evaluate(() => [...document.querySelectorAll(".scroll")].map(one =>
        ({name: one.getAttribute("aria-label"), role: one.getAttribute("role"), tab: one.tabIndex})));
    assert.ok(scrolls.length > 0 && scrolls.every(one => one.name && one.role === "region" && one.tab === 0),
        "each table is in a region that takes the keyboard");
    assert.equal(new Set(scrolls.map(one => one.name)).size, scrolls.length, "regions have names of their own");
    if (width === 400) {
      const scrolled = await page.evaluate(() => {
        const wide = [...document.querySelectorAll(".scroll")].find(one => one.checkVisibility() && one.scrollWidth > one.clientWidth);
        wide.scrollIntoView();
        wide.focus();
        return wide.getAttribute("aria-label");
      });
      await page.keyboard.press("ArrowRight");
      await page.waitForFunction(name => document.querySelector(`.scroll[aria-label="${name}"]`).scrollLeft > 0, {}, scrolled);
    }
    await page.screenshot({path: at(`light-${width}.png`), fullPage: true});

    // Chromium's own account of the page for those who cannot see it.
    if (width === 1000) {
      const tree = await page.accessibility.snapshot({interestingOnly: false});
      const names = [];
      (function walk(node) { if (node.role === "figure") names.push(node.name); node.children?.forEach(walk); })(tree);
      assert.deepEqual(names, figures.map(one => one.label), "figures by name in the accessibility tree");
    }

    // The same page turned narrow while it is open: figures follow.
    if (width === 1600) {
      await page.setViewport({width: 500, height: 900});
      await page.waitForFunction(() => document.documentElement.scrollWidth <= 500);
    }
    await page.close();
  }
}

// A dark screen: other colours, and words that can be read; on paper: A4, light even where the screen is dark, every figure
// whole. Leaves how many figures there are.
async function checkColours(visit, at, printed) {
  const colours = page => page.evaluate(() => {
    const of = (element, property) => getComputedStyle(element)[property].match(/\d+/g).slice(0, 3).map(Number);
    return {paper: of(document.body, "backgroundColor"), words: of(document.body, "color"),
      labels: [...document.querySelectorAll("figure .role-axis text, figure .role-legend text")].map(one => of(one, "fill"))};
  });
  const light = await visit.opened(1000);
  const dark = await visit.opened(1000, {dark: true});
  const seen = {light: await colours(light), dark: await colours(dark)};
  assert.notDeepEqual(seen.light.paper, seen.dark.paper);
  for (const [name, screen] of Object.entries(seen)) {
    assert.ok(screen.labels.length > 0);
    for (const words of [screen.words, ...screen.labels])
      assert.ok(contrast(words, screen.paper) >= 4.5, `contrast of ${words} on ${screen.paper}, ${name}`);
  }
  await light.close();
  await dark.screenshot({path: at("dark-1000.png"), fullPage: true});

  fs.writeFileSync(at("print.pdf"), await dark.pdf({format: "A4", preferCSSPageSize: true, printBackground: true}));
  const text = execFileSync("pdftotext", ["-layout", at("print.pdf"), "-"], {encoding: "utf8"});
  const count = await dark.evaluate(() => document.querySelectorAll("figure").length);
  for (let k = 1; k <= count; ++k) assert.ok(text.includes(`Figure ${k}.`), `Figure ${k} is printed`);
  assert.ok(printed.some(words => text.includes(words)), "axes are printed");
  await dark.emulateMediaType("print");
  assert.equal(await dark.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  await dark.close();
  return count;
}

// By keyboard: to the first figure's menu, into it, and its picture is saved.
async function checkKeyboard(visit, at, systems) {
  const light = await visit.opened(1000);
  const first = await light.$eval("figure", figure => figure.id);
  const downloads = at("downloads");
  fs.mkdirSync(downloads);
  const session = await visit.browser.target().createCDPSession();
  await session.send("Browser.setDownloadBehavior", {behavior: "allow", downloadPath: downloads});
  await light.bringToFront();
  const focused = () => light.evaluate(() => ({tag: document.activeElement.tagName,
    figure: document.activeElement.closest("figure")?.id, name: document.activeElement.getAttribute("aria-label"),
    download: document.activeElement.download}));
  let where = await focused();
  for (let k = 0; k < 40 && where.tag !== "SUMMARY"; ++k) {
    await light.keyboard.press("Tab");
    where = await focused();
  }
  assert.equal(where.figure, first, "Tab reaches the menu of the first figure");
  assert.equal(where.name, "Save Figure 1.");
  await light.keyboard.press("Enter");
  await light.waitForSelector(`#${first} details[data-ready]`);
  const arrives = async (name, begins) => {
    const file = path.join(downloads, name);
    for (let k = 0; k < 600 && !(fs.existsSync(file) && fs.statSync(file).size > 0); ++k)
      await new Promise(done => setTimeout(done, 100));
    assert.ok(fs.existsSync(file), `${name} is saved`);
    const bytes = fs.readFileSync(file);
    assert.equal(bytes.subarray(0, begins.length).toString("latin1"), begins);
    return bytes;
  };
  await light.keyboard.press("Tab");
  assert.equal((await focused()).download, `${first}.svg`);
  await light.keyboard.press("Enter");
  const svg = (await arrives(`${first}.svg`, "<svg")).toString("utf8");
  for (const system of systems) assert.ok(svg.includes(system.split(/[- ]/)[0]), `${system} is in the saved figure`);
  assert.ok(!svg.includes("var("), "a saved figure carries its own colours");
  await light.keyboard.press("Tab");
  assert.equal((await focused()).download, `${first}.png`);
  await light.keyboard.press("Enter");
  const png = await arrives(`${first}.png`, "\x89PNG");
  assert.ok(png.readUInt32BE(16) >= 1000, "the PNG is large enough to print");
  await light.keyboard.press("Escape");
  assert.deepEqual(await light.evaluate(() => document.querySelectorAll("figure details[open]").length), 0);
  const entries = await light.evaluate(id => document.querySelectorAll(`#${id} .vega-actions a`).length, first);
  assert.equal(entries, 2, "the menu saves, and offers nothing that needs a network");
  await light.close();
}

// `file`: a page in the folder of at(). `systems`: names that the first figure shows. `printed`: words of axes, one of which
// is on paper. `plain`: words that stand on the page where JavaScript is off. `expected(figures)` looks further at what
// figuresOf found, at every width. Throws where something is not as it should be; leaves pictures and a print in the folder.
export async function checkPage({at, file, systems, printed, plain, expected}) {
  const browser = await puppeteer.launch({executablePath: chromium(), headless: true, protocolTimeout: 600000,
      args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--font-render-hinting=none"]});
  const visit = new Visit(browser, at(file));
  try {
    await checkWidths(visit, at, expected);
    const count = await checkColours(visit, at, printed);
    await checkKeyboard(visit, at, systems);

    const without = await visit.opened(1000, {script: false});
    const text = await without.$eval("body", body => body.innerText);
    for (const words of ["The figures are drawn with JavaScript, which is off here.", ...plain])
      assert.ok(text.includes(words), `without JavaScript the page says "${words}"`);
    await without.close();

    assert.deepEqual(visit.said, [], "the page complains of nothing");
    assert.deepEqual(visit.asked, [], "the page asks for nothing");
    return `${count} figures drawn at ${widths.join(", ")} px, dark, printed, saved by keyboard`;
  } catch (error) {
    if (visit.said.length > 0) console.error("The page said:", visit.said);
    throw error;
  } finally {
    await browser.close();
  }
}
