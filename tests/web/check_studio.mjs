// A whole session in the studio by mouse, another by keyboard alone; what it looks like; and what happens when things go
// wrong.
//   node check_studio.mjs SHARE OUT [PROGRAM]
import path from "node:path";
import {authoring} from "./authoring.mjs";
import {authoringByKeys} from "./authoring_keys.mjs";
import {byKeyboard} from "./by_keyboard.mjs";
import {byMouse} from "./by_mouse.mjs";
import {keeping} from "./keeping.mjs";
import {looks} from "./looks.mjs";
import {goesWrong} from "./goes_wrong.mjs";
import {inStep} from "./in_step.mjs";
import {sessionByKeyboard} from "./session_by_keyboard.mjs";
import {sessionByMouse} from "./session_by_mouse.mjs";
import {sessionGoesWrong} from "./session_goes_wrong.mjs";
import {sessionLooks} from "./session_looks.mjs";
import {sessionOfProgram} from "./session_of_program.mjs";
import {tour} from "./tour.mjs";
import {begin} from "./visit.mjs";

const [share, out, program] = process.argv.slice(2).map(word => path.resolve(word));
const place = await begin({share, out, program});
try {
  const only = process.env.ONLY?.split(",");
  for (const [name, check] of Object.entries({inStep, byMouse, byKeyboard, authoring, authoringByKeys, keeping, looks, tour, goesWrong, sessionByMouse,
    sessionByKeyboard, sessionGoesWrong, sessionLooks, sessionOfProgram})) {
    if (only && !only.includes(name)) continue;
    const begun = performance.now();
    const found = await check(place);
    console.log(`check_studio: ${name}: ${found} (${((performance.now() - begun) / 1000).toFixed(1)} s)`);
  }
} finally {
  await place.end();
}
