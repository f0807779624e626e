// Generates gestures, for all of the speech or inside the marked range only.
import {current} from "immer";
import {ServerError, wordsOf} from "../api/ask.ts";
import {generate, soundOf, speak, type Generated, type GenerateRequest} from "../api/client.ts";
import {posesOf} from "../model/controls.ts";
import {stylePieces} from "../model/curves.ts";
import {fingerprint, fps, frameCountOf, type Speech, type StudioDocument, type Word} from "../model/document.ts";
import {following} from "../model/following.ts";
import {isOfRules} from "../model/rules.ts";
import {base64Of, bytesOf} from "../playback/base64.ts";
import {play, warmUp} from "../playback/player.ts";
import {placedByRules} from "./rule_gestures.ts";
import {complain, say} from "../state/messages.ts";
import {loadRules, rules} from "../state/rules.ts";
import {keepsRules, relaxes, system, takes} from "../state/server.ts";
import {beginnings, busy, edit, playhead, studioDocument} from "../state/store.ts";

// What is said and by whom.
const sayingOf = ({text, voice, recording}: StudioDocument) => ({text: text.trim(), voice, recording: recording?.id ?? null});
const same = (a: ReturnType<typeof sayingOf>, b: ReturnType<typeof sayingOf>) =>
    a.text === b.text && a.voice === b.voice && a.recording === b.recording;

// Whether the speech in hand is what the text and the voice say.
export const sameSpeech = (document: StudioDocument): boolean =>
    document.speech !== null && document.speech.wav !== "" && same(document.speech, sayingOf(document));

// The speech that the server keeps for us, by its name there. Its sound comes while gestures are generated.
interface Kept extends ReturnType<typeof sayingOf> {
  readonly id: string;
  readonly duration_s: number;
  readonly words: readonly Word[];
  readonly speech: Promise<Speech>;
}
let kept: Kept | null = null;

async function spoken(document: StudioDocument): Promise<Kept> {
  const saying = sayingOf(document);
  const {recording} = document;
  const answer = await speak(recording ? {text: saying.text, sound: new Blob([bytesOf(recording.wav) as BlobPart], {type: "audio/wav"})}
      : {text: saying.text, ...(saying.voice !== null && {voice: saying.voice})});
  const {speech_id, duration_s, words, accents, pitch, pitch_fps, sound} = answer;
  const speech = soundOf(sound).then(bytes => ({...saying, duration_s, words, accents, pitch, pitch_fps, wav: base64Of(new Uint8Array(bytes))}));
  speech.catch(() => { kept = null; });  // who waits for it is told
  return {...saying, id: speech_id, duration_s, words, speech};
}

// A project that is given may leave it to its voice to say it: with the sound, and its words.
export async function withSpeech(document: StudioDocument): Promise<StudioDocument> {
  if (document.speech && document.speech.wav !== "") return document;
  kept = await spoken(document);
  const speech = await kept.speech;
  return {...document, speech: document.speech ? {...document.speech, wav: speech.wav} : speech};
}

// What is chosen, as far as the system takes it.
function choicesOf({variety, finish}: StudioDocument): Partial<GenerateRequest> {
  return {...(system.value && {system: system.value.system}), ...(takes("variety") && {variety}),
    ...(finish.fade && takes("fade") && {fade: true as const}), ...(finish.still && takes("still") && {still: true as const}),
    ...(relaxes.value !== null && {relaxed_fingers: relaxes.value})};
}

function controlsFor({poseControls, styleControls, bypass, exact}: StudioDocument): Partial<GenerateRequest> {
  const poses = bypass.pose ? [] : poseControls.map(control => ({start_frame: control.start, frames: posesOf(control)}));
  const styles = bypass.style || !takes("style_controls") ? [] : stylePieces(styleControls);
  return {...(poses.length > 0 && {pose_controls: poses, ...(exact && takes("exact") && {exact: true as const})}), ...(styles.length > 0 && {style_controls: styles})};
}

// A server that was started anew does not know the speech any more: it is told it again.
async function answerTo(asked: StudioDocument, id: string, keep: Pick<GenerateRequest, "keep">): Promise<Generated> {
  const rest = {seed: asked.seed, format: "json" as const, ...choicesOf(asked), ...controlsFor(asked), ...keep};
  try {
    return await generate({speech_id: id, ...rest});
  } catch (problem) {
    if (!(problem instanceof ServerError) || problem.field !== "speech_id") throw problem;
    kept = await spoken(asked);
    return generate({speech_id: kept.id, ...rest});
  }
}

// Controls follow their words into a new speech. Those of rules are put anew, where rules put them each time.
function carried({speech, poseControls, styleControls, seed}: StudioDocument, next: {readonly words: readonly Word[]; readonly duration_s: number}, ruled: boolean) {
  const bare = ruled ? poseControls.filter(control => !isOfRules(control)) : poseControls;
  const total = frameCountOf(next.duration_s);
  const stays = !speech || speech === next;
  const poses = stays ? bare : following(bare, speech, next, total);
  const styles = stays ? styleControls : following(styleControls, speech, next, total);
  const lost = bare.length - poses.length + styleControls.length - styles.length;
  return {controls: {poseControls: ruled ? placedByRules({poseControls: poses, seed}, next).controls : poses, styleControls: styles}, lost};
}

// What the system makes of the project that is begun, which has a speech but no motion yet.
export async function firstMotion(document: StudioDocument): Promise<StudioDocument> {
  if (!kept || !same(kept, sayingOf(document))) kept = await spoken(document);
  const {frames, tracks, system: by, synthetic} = await answerTo(document, kept.id, {});
  return {...document, motion: {frames, tracks, system: by, synthetic, madeFrom: fingerprint(document)}};
}

const inWords = (count: number) => count === 1 ? "1 control" : `${count} controls`;

// Of the whole speech, or of the marked range with the frames around it kept as they are.
export async function generateGestures(within: "all" | "range"): Promise<void> {
  if (busy.value !== null) return;
  const document = studioDocument.value;
  if (document.text.trim() === "") {
    complain("Type what is said first.");
    return;
  }
  const {motion, range} = document;
  if (within === "range" && !takes("keep")) {
    complain("Keyframes are made as a whole: there is no range only.");
    return;
  }
  const partly = within === "range" && motion !== null && range !== null && sameSpeech(document);
  if (within === "range" && !partly) {
    complain("Mark a range of the generated motion first: drag over the sound or the words.");
    return;
  }
  busy.value = partly ? "Generating the marked range" : "Generating gestures";
  const begun = beginnings.value;
  try {
    warmUp();
    const ruled = !partly && document.byRules && keepsRules.value;
    if (ruled && !rules.value) await loadRules();
    if (!kept || !same(kept, sayingOf(document))) kept = await spoken(document);
    const {speech: coming} = kept;
    const next = sameSpeech(document) ? document.speech! : kept;
    const total = frameCountOf(next.duration_s);
    const asked = {...document, ...carried(document, next, ruled).controls};
    const answer = await answerTo(asked, kept.id, partly ? {keep: {frames: motion.frames, from_frame: range.from, to_frame: range.to}} : {});
    if (answer.frames.length !== total) throw new Error(`The server answered ${answer.frames.length} frames for a speech of ${total}.`);
    const speech = sameSpeech(document) ? document.speech! : await coming;
    if (begun !== beginnings.value) return;
    const lost = put(asked, speech, answer, partly ? "Generate the marked range" : "Generate", ruled);
    say(lost > 0 ? `Gestures are ready. ${inWords(lost)} had no room in the new speech; undo brings back what was before.` : "Gestures are ready.");
    playhead.value = partly ? range.from / fps : 0;
    void play();
  } catch (problem) {
    if (begun === beginnings.value) complain(wordsOf(problem));
  } finally {
    busy.value = null;
  }
}

// How many controls did not fit any more. What was edited meanwhile stays.
function put(asked: StudioDocument, speech: Speech, answer: Generated, label: string, ruled: boolean): number {
  let lost = 0;
  edit(label, draft => {
    const total = frameCountOf(speech.duration_s);
    const after = carried(current(draft) as StudioDocument, speech, ruled);
    Object.assign(draft, after.controls);
    ({lost} = after);
    if (speech !== asked.speech) draft.speech = speech as typeof draft.speech;
    if (draft.range && draft.range.to > total) draft.range = null;
    const {frames, tracks, system, synthetic} = answer;
    draft.motion = {frames, tracks, system, synthetic, madeFrom: fingerprint(asked)} as typeof draft.motion;
  });
  return lost;
}
