// Validates a glTF file with the Khronos validator: node validate.mjs FILE.glb
// Prints every message; exits with 1 where there is an error or a warning, with 2 where it could not run.
import { readFile } from "node:fs/promises";
import process from "node:process";

const file = process.argv[2];
if (!file) {
  console.error("usage: node validate.mjs FILE.glb");
  process.exit(2);
}
let validator;
try {
  validator = (await import("gltf-validator")).default;
} catch (error) {
  console.error(`the validator is not installed (${error.code}); run npm ci in ${import.meta.dirname}`);
  process.exit(2);
}
const report = await validator.validateBytes(new Uint8Array(await readFile(file)), { maxIssues: 100 });
for (const message of report.issues.messages)
  console.log(`severity ${message.severity} ${message.code} ${message.pointer ?? ""}: ${message.message}`);
const { numErrors, numWarnings, numInfos, numHints } = report.issues;
console.log(`${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints; ` +
  `${report.info.totalVertexCount} vertices, ${report.info.totalTriangleCount} triangles`);
process.exit(numErrors + numWarnings > 0 ? 1 : 0);
