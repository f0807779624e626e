// What the server has. It may be older than the page: what it lacks is not offered.
import {computed, signal} from "@preact/signals";
import {wordsOf} from "../api/ask.ts";
import {health, routes, type Health} from "../api/client.ts";
import {complain} from "./messages.ts";
import {offers} from "./mode.ts";
import {studioDocument} from "./store.ts";

export const served = signal<Health | null>(null);
const known = signal<ReadonlySet<string>>(new Set());

const keeps = (...needed: string[]) => computed(() => offers("kept") && served.value?.folder === true && needed.every(route => known.value.has(route)));

export const keepsMotions = keeps("POST /v1/motions", "DELETE /v1/motions/{}");
export const keepsRules = keeps("GET /v1/rules", "PUT /v1/rules");
export const keepsProjects = keeps("GET /v1/projects", "POST /v1/projects", "GET /v1/projects/{}", "PUT /v1/projects/{}");
export const readsClips = computed(() => known.value.has("POST /v1/motions/read"));
export const points = computed(() => known.value.has("POST /v1/point"));

export const keyframes = "keyframes";  // the system that joins poses alone: MANUAL

// What makes the gestures: as chosen, or the server's first; null where it says nothing of a choice.
export const system = computed(() => {
  const all = served.value?.gestures ?? [];
  return all.find(one => one.system === studioDocument.value.system) ?? all[0] ?? null;
});
export const isManual = computed(() => system.value?.system === keyframes);

// Servers that say nothing of systems take what they always took.
const always = new Set(["pose_controls", "style_controls", "keep", "exact"]);
const ofSketches = new Set(["variety", "fade", "still"]);
export const takes = (field: string): boolean => (offers("sketch") || !ofSketches.has(field)) &&
    (system.value ? system.value.takes.includes(field) : always.has(field));

// Whether what is shown and exported has relaxed fingers, or stretched ones; null: there is no choice.
export const relaxes = computed(() => takes("relaxed_fingers") ? studioDocument.value.finish.relaxedFingers : null);

export async function askServer(): Promise<void> {
  try {
    const asked = routes().catch(() => new Set<string>()).then(all => { known.value = all; });
    served.value = await health();
    await asked;
  } catch (problem) {
    complain(wordsOf(problem));
  }
}
