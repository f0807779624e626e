// The rules from words to gestures, as the server keeps them.
import {signal} from "@preact/signals";
import {rules as askRules, putRules, type KeptRules} from "../api/kept.ts";

export const rules = signal<KeptRules | null>(null);  // null: not asked for yet

export async function loadRules(): Promise<KeptRules> {
  const kept = await askRules();
  rules.value = kept;
  return kept;
}

// Throws a ServerError, of status 412 where somebody else has changed them meanwhile.
export async function keepRules(wanted: KeptRules["rules"]): Promise<void> {
  rules.value = await putRules(wanted, rules.value?.revision ?? "");
}
