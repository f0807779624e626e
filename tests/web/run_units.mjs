// Bundles the units' tests with the page's own esbuild, and runs them: node itself does not read TypeScript.
//   node run_units.mjs FOLDER
import {execFileSync, spawnSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {fileURLToPath} from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const web = path.resolve(here, "../../web");
const out = path.resolve(process.argv[2]);
fs.rmSync(out, {recursive: true, force: true});
fs.mkdirSync(out, {recursive: true});
const esbuild = fs.readdirSync(path.join(web, "node_modules/@esbuild")).map(one => path.join(web, "node_modules/@esbuild", one, "bin/esbuild"))[0];
const tests = fs.readdirSync(path.join(here, "units")).map(one => path.join(here, "units", one));
execFileSync(esbuild, [...tests, "--bundle", "--platform=node", "--format=esm", "--out-extension:.js=.mjs", "--log-level=warning", `--outdir=${out}`],
    {stdio: "inherit"});
process.exitCode = spawnSync(process.execPath, ["--test", ...fs.readdirSync(out).map(one => path.join(out, one))], {stdio: "inherit", env: {...process.env, TESTS_WEB: here}}).status ?? 1;
