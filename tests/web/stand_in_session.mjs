// A stand-in for a study's session: boards, as the program lays them out, and trials of authoring, one after the other. What
// the page does is kept, for tests to look at; they can make things happen in between.
import fs from "node:fs";
import {Refusal} from "./stand_in_kept.mjs";

const boards = JSON.parse(fs.readFileSync(new URL("session_boards.json", import.meta.url), "utf8"));
const several = new Set([1200]);  // the first option of questions with more than one answer
const questionOf = id => id >= 1000 && id < 5000 ? id - id % 100 : null;

export class StandInSession {
  // `steps`: names of boards, and tasks ({system, project, limit_s, ...}), in order; the last one is a board.
  constructor(steps, {language = "en"} = {}) {
    this.of = {participant: "P01", study: "stand-in", language};
    this.steps = steps;
    this.at = -1;
    this.revision = 0;
    this.paused = false;
    this.notice = "";
    this.works = [];    // each that the page sent
    this.answers = [];  // of boards, and of trials
    this.presses = [];
    this.refused = 0;   // with 409
    this.waiting = new Set();
    this.next();
  }

  get step() { return this.steps[this.at]; }
  get task() { return typeof this.step === "object" ? this.step : null; }

  changed() {
    ++this.revision;
    for (const tell of [...this.waiting]) tell();
  }

  next() {
    clearTimeout(this.timer);
    ++this.at;
    if (this.task) {
      this.work = null;
      this.used_ms = 0;
      this.go();
    } else {
      this.board = structuredClone(boards[this.step]);
    }
    this.changed();
  }

  // The clock of a trial goes on, or stands.
  go() {
    this.since = Date.now();
    this.timer = setTimeout(() => this.answered("time"), Math.max(0, 1000 * this.left()));
  }
  left() {
    return Math.max(0, this.task.limit_s - (this.used_ms + (this.paused ? 0 : Date.now() - this.since)) / 1000);
  }
  // So that so many seconds are left.
  leave(seconds) {
    clearTimeout(this.timer);
    this.used_ms = 1000 * (this.task.limit_s - seconds);
    this.go();
    this.changed();
  }
  // Another board, of which the page has not heard yet.
  nextUnheard() {
    const waiting = this.waiting;
    this.waiting = new Set();
    this.next();
    this.waiting = waiting;
  }
  pause() {
    if (this.paused) return;
    clearTimeout(this.timer);
    if (this.task) this.used_ms += Date.now() - this.since;
    this.paused = true;
    this.changed();
  }
  resume() {
    this.paused = false;
    if (this.task) this.go();
    this.changed();
  }
  tell(notice) {
    this.notice = notice;
    this.changed();
  }

  answered(by) {
    this.answers.push({task: this.task, by, project: this.work?.project ?? this.task.project});
    this.next();
  }

  now() {
    const last = this.at === this.steps.length - 1;
    const tasks = this.steps.filter(one => typeof one === "object");
    const {project, system, keyframes_only = false, practice = false, question = "Make gestures that go with the speech.", limit_s, may_end_early = false} = this.task ?? {};
    return {revision: this.revision, state: this.paused ? "paused" : this.task ? "authoring" : "page", stage: this.task ? "making" : this.step, notice: this.notice, over: last,
      panel: this.paused ? boards.paused : this.task ? null : this.board,
      authoring: this.task && {trial: tasks.indexOf(this.task) + 1, of: tasks.length, practice, system, keyframes_only, question, project: this.work?.project ?? project,
        limit_s, left_s: this.left(), may_end_early}};
  }

  async get(after) {
    if (after !== null && Number(after) === this.revision)
      await new Promise(resolve => {
        const tell = () => {
          clearTimeout(timer);
          this.waiting.delete(tell);
          resolve();
        };
        const timer = setTimeout(tell, 10_000);
        this.waiting.add(tell);
      });
    return this.now();
  }

  check(revision) {
    if (revision === this.revision) return;
    ++this.refused;
    throw new Refusal("revision", "another board is shown by now", 409);
  }
  checkTrial(trial) {
    if (this.task && trial === this.now().authoring.trial) return;
    ++this.refused;
    throw new Refusal("trial", "another trial is under way", 409);
  }

  async press({revision, button}) {
    this.check(revision);
    await new Promise(done => setTimeout(done, 30));
    const board = this.paused ? boards.paused : this.board;
    const one = board?.buttons.find(each => each.id === button);
    if (!one?.enabled) throw new Refusal("button", "it cannot be pressed now", 409);
    this.presses.push({step: this.step, label: one.label});
    if (this.paused) {
      this.resume();
    } else if (one.role === "option") {
      const question = questionOf(button);
      const was = one.chosen;
      if (!several.has(question)) for (const other of board.buttons) if (questionOf(other.id) === question) other.chosen = false;
      one.chosen = several.has(question) ? !was : true;
      this.changed();
    } else {
      const open = [...new Set(board.buttons.map(each => questionOf(each.id)))].filter(id => id !== null && !several.has(id))
          .some(id => !board.buttons.some(each => questionOf(each.id) === id && each.chosen)) || board.sliders.some(each => each.value === null);
      if (one.role === "go_on" && open) {
        this.tell("Please answer all questions.");
      } else {
        this.notice = "";
        this.answers.push({board: this.step, chosen: board.buttons.filter(each => each.chosen).map(each => each.id), values: board.sliders.map(each => each.value),
          texts: board.fields.map(each => each.text)});
        this.next();
      }
    }
    return {revision: this.revision};
  }

  async slide({revision, slider, value}) {
    this.check(revision);
    this.board.sliders.find(each => each.id === slider).value = value;
    this.changed();
    return {revision: this.revision};
  }
  async type({revision, field, text}) {
    this.check(revision);
    await new Promise(done => setTimeout(done, 30));
    this.check(revision);
    this.board.fields.find(each => each.id === field).text = text;
    this.changed();
    return {revision: this.revision};
  }
  async put(work) {
    this.checkTrial(work.trial);
    this.work = work;
    this.works.push(work);
    return {left_s: this.left()};
  }
  async finish(work) {
    this.checkTrial(work.trial);
    if (!this.task.may_end_early) throw new Refusal("trial", "it lasts until its time is over", 409);
    this.work = work;
    this.works.push(work);
    this.answered("finish");
    return {revision: this.revision};
  }
  async halt() {
    this.pause();
    return {revision: this.revision};
  }

  // A promise of the answer's body; null: it is no route of these.
  route(method, address, query, asked) {
    switch (`${method} ${address}`) {
      case "GET /v1/session": return this.get(query.get("after"));
      case "POST /v1/session/press": return this.press(asked);
      case "POST /v1/session/slide": return this.slide(asked);
      case "POST /v1/session/type": return this.type(asked);
      case "PUT /v1/session/work": return this.put(asked);
      case "POST /v1/session/finish": return this.finish(asked);
      case "POST /v1/session/pause": return this.halt();
      default: return null;
    }
  }
}
