// Rules from a word to one or several gestures: what is changed here is kept by Save, and forgotten by Cancel.
import {signal} from "@preact/signals";
import {ServerError, wordsOf} from "../api/ask.ts";
import {putByRules} from "../actions/rule_gestures.ts";
import {plainWord, type Rule} from "../model/rules.ts";
import {library} from "../state/library.ts";
import {complain, say} from "../state/messages.ts";
import {keepRules, loadRules, rules} from "../state/rules.ts";
import {edit, studioDocument} from "../state/store.ts";
import {DamagedNote} from "./damaged_note.tsx";
import {Dialog} from "./dialog.tsx";
import {IconButton} from "./icon_button.tsx";

const open = signal(false);
const past = signal<readonly (readonly Rule[])[]>([]);  // before each change, the last one last
const draft = signal<readonly Rule[]>([]);
const problem = signal("");
const conflict = signal(false);

const isSame = (a: readonly Rule[], b: readonly Rule[]) => JSON.stringify(a) === JSON.stringify(b);
const changed = () => !isSame(draft.value, rules.value?.rules ?? []);

export async function openRules(): Promise<void> {
  try {
    draft.value = (await loadRules()).rules;
    past.value = [];
    typedIn = null;
    problem.value = "";
    conflict.value = false;
    open.value = true;
  } catch (wrong) {
    complain(wordsOf(wrong));
  }
}

let typedIn: string | null = null;  // the field of the last change, if that was typed: its letters are undone together

function change(next: readonly Rule[], field: string | null = null): void {
  if (field === null || field !== typedIn) past.value = [...past.value, draft.value];
  typedIn = field;
  draft.value = next;
  problem.value = "";
}
function undoChange(): void {
  const before = past.value.at(-1);
  if (!before) return;
  past.value = past.value.slice(0, -1);
  typedIn = null;
  draft.value = before;
}
const changeRule = (k: number, rule: Rule, field: string | null = null) => change(draft.value.map((one, i) => i === k ? rule : one), field);

// What is wrong with them, as it is told; empty where nothing is.
function wrongWith(all: readonly Rule[]): string {
  const words = all.map(rule => plainWord(rule.word));
  const twice = words.find((word, k) => word !== "" && words.indexOf(word) !== k);
  if (twice !== undefined) return `“${twice}” has two rules: put all its gestures into one.`;
  if (words.some(word => /\s/.test(word))) return "A rule is of one word.";
  if (all.some((rule, k) => words[k] === "" || rule.motions.length === 0)) return "Each rule needs a word and a gesture.";
  return "";
}

async function save(): Promise<boolean> {
  problem.value = wrongWith(draft.value);
  if (problem.value !== "") return false;
  try {
    await keepRules(draft.value.map(rule => ({...rule, word: plainWord(rule.word)})));
    open.value = false;
    return true;
  } catch (wrong) {
    conflict.value = wrong instanceof ServerError && wrong.status === 412;
    problem.value = conflict.value ? "Somebody else has changed the rules since you opened them." : wordsOf(wrong);
    return false;
  }
}

// Theirs are read, so that mine are a change to them; or taken in place of mine, which undo brings back.
async function settleConflict(mine: boolean): Promise<void> {
  try {
    const kept = await loadRules();
    conflict.value = false;
    problem.value = "";
    if (mine) void save();
    else change(kept.rules);
  } catch (wrong) {
    problem.value = wordsOf(wrong);
  }
}

function RuleRow({rule, k}: {rule: Rule; k: number}) {
  const all = library.value ?? [];
  const left = all.filter(motion => !rule.motions.includes(motion.id));
  const word = rule.word || `rule ${k + 1}`;
  return <li class="rule">
    <input aria-label={`Word of rule ${k + 1}`} placeholder="word" value={rule.word} maxLength={60} spellcheck={false}
        onInput={event => changeRule(k, {...rule, word: event.currentTarget.value}, `word ${k}`)} />
    <div class="rule-gestures">
      {rule.motions.map(id => {
        const name = all.find(motion => motion.id === id)?.name ?? id;
        return <span class="chip" key={id}>{name}
          <IconButton icon="close" name={`${name}: not for “${word}”`} onClick={() => changeRule(k, {...rule, motions: rule.motions.filter(one => one !== id)})} /></span>;
      })}
      <select class="quiet" aria-label={`Add a gesture for “${word}”`} value="" onKeyDown={event => {
        // Else each arrow would add one: it opens the list instead.
        if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
        event.preventDefault();
        event.currentTarget.showPicker();
      }} onChange={event => {
        const id = event.currentTarget.value;
        event.currentTarget.value = "";
        if (id) changeRule(k, {...rule, motions: [...rule.motions, id]});
      }}>
        <option value="" disabled>{rule.motions.length === 0 ? "Choose a gesture" : "Add another"}</option>
        {left.map(motion => <option key={motion.id} value={motion.id}>{motion.name}</option>)}
      </select>
    </div>
    <IconButton icon="bin" name={`Delete the rule for “${word}”`} onClick={() => change(draft.value.filter((_, i) => i !== k))} />
  </li>;
}

function addRule(): void {
  const said = studioDocument.value.speech?.words.map(word => plainWord(word.word)) ?? [];
  const known = new Set(draft.value.map(rule => plainWord(rule.word)));
  const suggestion = [...said].sort((a, b) => b.length - a.length).find(word => word.length > 3 && !known.has(word));
  change([...draft.value, {word: suggestion ?? "", motions: []}]);
  requestAnimationFrame(() => (document.querySelector(".rule:last-child input") as HTMLInputElement | null)?.select());
}

export function RulesDialog() {
  const close = () => {
    if (!changed() || past.value.length === 0) return true;
    problem.value = "Not saved yet: save the rules, or cancel to forget the changes.";
    return false;
  };
  return <Dialog open={open} id="rules" title="Rules: which gestures a word gets" mayClose={close}>
    <form onSubmit={event => {
      event.preventDefault();
      void save().then(saved => { if (saved) say("Rules saved."); });
    }} onKeyDown={event => {
      if (event.key !== "z" || !event.ctrlKey || (event.target as Element).matches("input")) return;
      event.preventDefault();
      undoChange();
    }}>
      <p class="note">Of several gestures one is drawn, by the project's version number. It is centred on its word, where there is room.</p>
      <DamagedNote damaged={rules.value?.damaged ?? []} />
      {draft.value.length === 0 ? <p class="note">There are no rules yet.</p> : <ul class="rules" aria-label="Rules">
        {draft.value.map((rule, k) => <RuleRow key={k} rule={rule} k={k} />)}
      </ul>}
      <div class="fields">
        <IconButton icon="plus" name="Add a rule" onClick={addRule}>Add a rule</IconButton>
        <IconButton icon="undo" name="Undo the last change of the rules" keys="Ctrl+Z" disabled={past.value.length === 0} onClick={undoChange} />
      </div>
      <label class="check"><input type="checkbox" checked={studioDocument.value.byRules} onChange={event => {
        const on = event.currentTarget.checked;
        edit(on ? "Put gestures by rules at each Generate" : "Put no gestures by rules", changing => { changing.byRules = on; });
      }} />Put gestures by rules whenever all is generated</label>
      <p class="problem-words" role="alert">{problem.value}</p>
      <div class="ends-with">
        {conflict.value ? <>
          <p class="note">Nothing of yours is lost.</p>
          <button type="button" class="button small" onClick={() => void settleConflict(false)}>Take theirs</button>
          <button type="button" class="button small" onClick={() => void settleConflict(true)}>Save mine over theirs</button>
        </> : <>
          <span class="spring" />
          <button type="button" class="button small" onClick={() => { open.value = false; }}>Cancel</button>
          <button type="submit" class="button small">Save</button>
          <button type="button" class="button primary" disabled={!studioDocument.value.speech} onClick={() =>
            void save().then(saved => saved ? putByRules() : undefined)}>Save and put gestures</button>
        </>}
      </div>
    </form>
  </Dialog>;
}
