// A stand-in for the studio's server, for tests of the page alone: the routes of /v1 that the page uses, with speech that is
// tones and motion that swings the arms. Refuses what the contract refuses.
//   node stand_in.mjs FOLDER AVATAR PORT
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import {pathToFileURL} from "node:url";
import {keeping, Refusal} from "./stand_in_kept.mjs";

const fps = 15;
const types = {".html": "text/html; charset=utf-8", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".txt": "text/plain"};
const policy = "default-src 'self'; media-src 'self' blob:; worker-src 'self' blob:";

const wordsOf = text => text.split(/\s+/).map(word => word.replace(/^[^\p{L}\p{N}]+|[^\p{L}\p{N}]+$/gu, "")).filter(Boolean);

function speechOf(text) {
  let at = 0.12;
  const words = wordsOf(text).map(word => {
    const one = {word, start_s: at, end_s: at + 0.12 + 0.045 * word.length};
    at = one.end_s + 0.03;
    return one;
  });
  const accents = words.flatMap((one, k) => one.word.length > 4 ? [{start_s: one.start_s + 0.02, end_s: one.start_s + 0.14,
    strength: Math.min(1, one.word.length / 9), word: k}] : []);
  return {words, accents, duration_s: at + 0.2};
}

function wavOf({words, duration_s}) {
  const rate = 16000;
  const count = Math.round(duration_s * rate);
  const bytes = Buffer.alloc(44 + 2 * count);
  bytes.write("RIFF", 0, "latin1");
  bytes.writeUInt32LE(36 + 2 * count, 4);
  bytes.write("WAVEfmt ", 8, "latin1");
  for (const [value, at, size] of [[16, 16, 4], [1, 20, 2], [1, 22, 2], [rate, 24, 4], [2 * rate, 28, 4], [2, 32, 2], [16, 34, 2]])
    bytes.writeUIntLE(value, at, size);
  bytes.write("data", 36, "latin1");
  bytes.writeUInt32LE(2 * count, 40);
  words.forEach((word, k) => {
    for (let i = Math.round(word.start_s * rate); i < word.end_s * rate; ++i) {
      const t = i / rate;
      const swell = Math.sin(Math.PI * (t - word.start_s) / (word.end_s - word.start_s)) ** 0.6;
      const syllable = 0.55 + 0.45 * Math.sin(2 * Math.PI * 9 * t);
      const sound = Math.sin(2 * Math.PI * (120 + 12 * (k % 4)) * t) + 0.5 * Math.sin(2 * Math.PI * 690 * t) + 0.25 * Math.sin(2 * Math.PI * 1800 * t);
      bytes.writeInt16LE(Math.round(9000 * swell * syllable * sound), 44 + 2 * i);
    }
  });
  return bytes;
}

const unit = ([x, y, z]) => { const n = Math.hypot(x, y, z); return [x / n, y / n, z / n]; };
const arm = (side, raise, out, bend) => {
  const upper = unit([side * (0.16 + 0.5 * out), -1 + 0.7 * raise, 0.1 + 0.5 * raise]);
  const fore = unit([side * (0.1 + 0.5 * out) - side * 0.25 * bend, -0.9 + 1.5 * raise, 0.25 + bend]);
  return [...unit([side, -0.08, 0.02]), ...upper, ...fore];
};
export function poseOf({left = 0, right = 0, out = 0, bend = 0.3, nod = 0}) {
  return [...unit([0, 1, 0.02]), ...unit([0, 1, 0.55 + nod]), ...unit([0, 1, -0.25 + nod]), ...arm(1, left, out, bend), ...arm(-1, right, out, bend)]
      .map(number => Math.round(1e5 * number) / 1e5);
}

const gestures = [
  ["raise-right", "Raise the right hand", "asks for attention", "emblem", t => ({right: t})], ["raise-left", "Raise the left hand", "asks for attention", "emblem", t => ({left: t})],
  ["point-right", "Point right", "that one over there", "deictic", t => ({right: 0.7 * t, out: t})], ["frame", "Frame", "a thing of this size", "iconic", t => ({left: 0.6 * t, right: 0.6 * t, out: 0.3 * t})],
  ["spread", "Spread the arms", "everything, all of it", "metaphoric", t => ({left: 0.7 * t, right: 0.7 * t, out: t})], ["beat", "Beat", "this word counts", "beat", t => ({right: 0.5 * t, bend: 0.3 + 0.4 * t})],
  ["offer", "Offer", "here is an idea", "metaphoric", t => ({left: 0.35 * t, right: 0.35 * t, bend: 0.3 + 0.7 * t})], ["weigh", "Weigh", "one or the other", "metaphoric", t => ({left: 0.5 * t, right: 0.3 * t, out: 0.4})],
].map(([id, name, meaning, kind, at]) => ({id, name, meaning, class: kind, fps, own: false,
  frames: Array.from({length: 21}, (_, k) => poseOf(at(Math.sin(Math.PI * k / 20) ** 0.7)))}));

const limits = {speed: 3, space: 3, handedness: 3};

function framesOf(speech, seed, styles = []) {
  const count = Math.max(1, Math.ceil(speech.duration_s * fps));
  return Array.from({length: count}, (_, k) => {
    const t = k / fps;
    const style = styles.find(one => k >= one.start_frame && k < one.start_frame + one.frame_count) ?? {};
    const wave = (rate, phase) => 0.5 + 0.5 * Math.sin((1 + 0.2 * (style.speed ?? 0)) * rate * t + phase + seed);
    return poseOf({left: 0.55 * wave(2.1, 0), right: 0.6 * wave(2.7, 1), out: 0.3 + 0.1 * (style.space ?? 0), nod: 0.06 * wave(3, 2)});
  });
}

// Rotations that take the arms from the rest pose's, which spreads them, to their directions: nothing of twist.
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const dot = (p, q) => p.reduce((sum, one, k) => sum + one * q[k], 0);
const times = ([ax, ay, az, aw], [bx, by, bz, bw]) => [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
  aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz];
const inverse = ([x, y, z, w]) => [-x, -y, -z, w];
function arc(from, to) {
  const q = [...cross(from, to), 1 + dot(from, to)];
  const n = Math.hypot(...q);
  return q.map(one => one / n);
}
function tracksOf(frames) {
  const bones = ["head", "leftUpperArm", "leftLowerArm", "rightUpperArm", "rightLowerArm"];
  const rotations = frames.map(frame => {
    const at = bone => unit(frame.slice(3 * bone, 3 * bone + 3));
    const row = [...arc(unit([0, 1, 0.55]), at(1))];
    for (const [side, upper] of [[1, 4], [-1, 7]]) {
      const q = arc([side, 0, 0], at(upper));
      row.push(...q, ...times(inverse(q), arc([side, 0, 0], at(upper + 1))));
    }
    return row.map(number => Math.round(1e5 * number) / 1e5);
  });
  return {fps, bones, rotations};
}

const speeches = new Map();
function speechFor(request) {
  if (request.speech_id !== undefined) {
    const speech = speeches.get(request.speech_id);
    if (!speech) throw new Refusal("speech_id", "there is no such speech");
    return speech;
  }
  if (typeof request.text !== "string" || wordsOf(request.text).length === 0) throw new Refusal("text", "has no words that can be spoken");
  const speech = {id: `s${speeches.size + 1}`, ...speechOf(request.text)};
  speeches.set(speech.id, speech);
  return speech;
}

const pitchOf = ({words, duration_s}) => Array.from({length: Math.round(100 * duration_s)}, (_, k) => {
  const word = words.findIndex(one => k / 100 >= one.start_s && k / 100 < one.end_s);
  return word < 0 ? 0 : 120 + 12 * (word % 4) + 15 * Math.sin(k / 6);
});
const answerOf = speech => ({speech_id: speech.id, words: speech.words, accents: speech.accents, duration_s: speech.duration_s,
  pitch: pitchOf(speech), pitch_fps: 100, sound: `/v1/speech/${speech.id}.wav`});

const fields = new Set(["text", "speech_id", "voice", "seed", "format", "system", "pose_controls", "style_controls", "keep", "exact",
  "fade", "still", "relaxed_fingers", "variety"]);
const finish = ["fade", "still", "relaxed_fingers"];
const systems = [{system: "model", takes: ["pose_controls", "style_controls", "keep", "exact", "variety", ...finish]},
  {system: "rules", takes: ["pose_controls", "style_controls", "keep", "exact", ...finish]}, {system: "keyframes", takes: ["pose_controls", ...finish]}];

// The arm that is nearer goes straight to the target.
function pointed({target_m, side = "auto", pose}) {
  const left = side === "left" || side === "auto" && target_m[0] > 0;
  const shoulder = [left ? 0.18 : -0.18, 1.4, 0];
  const away = target_m.map((one, k) => one - shoulder[k]);
  if (Math.hypot(...away) < 0.3) throw new Refusal("target_m", "is nearer than 0.3 m to the shoulder");
  const frame = [...pose ?? poseOf({})];
  for (const bone of left ? [4, 5] : [7, 8]) frame.splice(3 * bone, 3, ...unit(away));
  return {frame, side: left ? "left" : "right", off_deg: 0};
}
const kept = keeping(gestures, pointed);
function generate(request) {
  for (const name of Object.keys(request)) if (!fields.has(name)) throw new Refusal(name, `${name} is not a field of this request`);
  const system = systems.find(one => one.system === (request.system ?? "model"));
  for (const name of [...systems[0].takes])
    if (request[name] !== undefined && !system.takes.includes(name)) throw new Refusal(name, `${name} is not for ${system.system}`);
  if ((request.style_controls ?? []).length > 1000) throw new Refusal("style_controls", "are more than 1000");
  const speech = speechFor(request);
  const total = Math.ceil(speech.duration_s * fps);
  for (const style of request.style_controls ?? [])
    for (const [name, limit] of Object.entries(limits))
      if (style[name] !== undefined && !(Math.abs(style[name]) <= limit)) throw new Refusal("style_controls", `${name} is out of range`);
  const frames = framesOf(speech, request.seed ?? 1, request.style_controls);
  for (const control of request.pose_controls ?? []) {
    if (control.start_frame + control.frames.length > total) throw new Refusal("pose_controls", "reaches over the speech's end");
    control.frames.forEach((frame, k) => { frames[control.start_frame + k] = frame; });
  }
  const {keep} = request;
  if (keep) keep.frames.forEach((frame, k) => { if (k < keep.from_frame || k >= keep.to_frame) frames[k] = frame; });
  return {speech_id: speech.id, words: speech.words, accents: speech.accents, duration_s: speech.duration_s, fps, frames, tracks: tracksOf(frames),
    sound: `/v1/speech/${speech.id}.wav`, system: system.system === "model" ? "stand-in" : system.system, synthetic: true};
}

const json = (response, status, body) => {
  response.writeHead(status, {"Content-Type": "application/json", "Cache-Control": "no-store", "Content-Security-Policy": policy});
  response.end(status === 204 ? undefined : JSON.stringify(body));
};

function refused(response, problem) {
  json(response, problem.status ?? 500, {error: {message: problem.message, field: problem.field ?? null}});
}

function answer(request, response, body, log, session) {
  const {pathname: address, searchParams} = new URL(request.url, "http://local");
  const route = `${request.method} ${address}`;
  const asked = body === "" ? null : body.startsWith("{") ? JSON.parse(body) : {text: /name="text"\r\n\r\n([^\r]*)/.exec(body)?.[1], form: body};
  if (asked) log.push({route, asked});
  if (route === "GET /v1/health")
    return json(response, 200, {status: "ok", version: "0", commit: "0", systems: ["stand-in"], synthetic: true, folder: true, gestures: systems,
      voices: [{name: "first", language: "en"}, {name: "second", language: "de"}], other_languages: true, mean_pose: poseOf({}),
      ...(session && {session: session.of})});
  const during = session?.route(request.method, address, searchParams, asked);
  if (during) return void during.then(made => json(response, 200, made), problem => refused(response, problem));
  if (route === "POST /v1/generate") return json(response, 200, generate(asked));
  if (route === "POST /v1/speech") {
    const speech = speechFor(asked);
    return json(response, 200, answerOf(speech));
  }
  if (route === "POST /v1/motions/read") {
    if (!body.includes("HIERARCHY")) throw new Refusal("clip", "found no motion in it");
    return json(response, 200, {format: "BVH", fps, frames: gestures[3].frames, remarks: ["It has no fingers."]});
  }
  if (route === "POST /v1/tracks") return json(response, 200, {tracks: tracksOf(asked.frames)});
  if (route === "POST /v1/export") {
    response.writeHead(200, {"Content-Type": "text/plain"});
    return response.end(`HIERARCHY\nMOTION\nFrames: ${asked.frames.length}\n`);
  }
  const other = kept(request.method, address, asked, request.headers["if-match"]);
  if (other) return json(response, ...other);
  const sound = /^\/v1\/speech\/(\w+)\.wav$/.exec(address);
  if (sound && speeches.has(sound[1])) {
    response.writeHead(200, {"Content-Type": "audio/wav"});
    return response.end(wavOf(speeches.get(sound[1])));
  }
  return null;
}

// A project as it may be given to an author: with what it says but not its sound, and with a motion or without any.
export function givenProject(text, {moving = false, system = null} = {}) {
  const speech = speechOf(text);
  const frames = framesOf(speech, 1);
  return {format: "deixis-studio", version: 2, fps, log: [], document: {name: "Given", text, voice: null, recording: null, seed: 1,
    speech: {text, voice: null, recording: null, ...speech, pitch: pitchOf(speech), pitch_fps: 100, wav: ""},
    motion: moving ? {frames, tracks: tracksOf(frames), system: "stand-in", synthetic: true, madeFrom: ""} : null,
    poseControls: [], styleControls: [], range: null, bypass: {pose: false, style: false}, exact: false, system, variety: 0,
    finish: {fade: false, still: false, relaxedFingers: true}, byRules: false}};
}

// Answers {server, log}: what was posted, in order. `session`: a study's that it runs.
export function standIn(folder, avatar, port, session = null) {
  const log = [];
  const server = http.createServer((request, response) => {
    let body = "";
    request.on("data", part => { body += part; });
    request.on("end", () => {
      try {
        if (answer(request, response, body, log, session) !== null) return;
        const address = new URL(request.url, "http://local").pathname;
        const file = address === "/avatar.glb" ? avatar : path.join(folder, address === "/" ? "index.html" : path.basename(address));
        if (!fs.existsSync(file)) return json(response, 404, {error: {message: `there is no ${address}`, field: null}});
        response.writeHead(200, {"Content-Type": types[path.extname(file)] ?? "model/gltf-binary", "Content-Security-Policy": policy,
          "X-Content-Type-Options": "nosniff"});
        response.end(fs.readFileSync(file));
      } catch (problem) {
        refused(response, problem);
      }
    });
  });
  return new Promise(resolve => server.listen(port, "127.0.0.1", () => resolve({server, log})));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [folder, avatar, port] = process.argv.slice(2);
  await standIn(folder, avatar, Number(port));
}
