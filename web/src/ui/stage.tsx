// Where the avatar is seen: turned by mouse, by arrow keys, or to one of its sides.
import {computed, effect, signal} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {wordsOf} from "../api/ask.ts";
import {complain} from "../state/messages.ts";
import {preview} from "../state/preview.ts";
import {playhead, playing, studioDocument} from "../state/store.ts";
import {ball, chosenCamera} from "../state/stage.ts";
import type {AvatarView} from "../view/avatar_view.ts";
import {colour, scheme} from "../state/screen.ts";
import {trial} from "../state/posing.ts";
import {Handles} from "./handles.tsx";
import {BallHandle} from "./pointing.tsx";
import {StageTools, TrialBar} from "./stage_tools.tsx";

export const stageView = signal<AvatarView | null>(null);
const stepAround = Math.PI / 18;

function turnByKey(event: KeyboardEvent, view: AvatarView | null): void {
  const step = {ArrowLeft: [-stepAround, 0], ArrowRight: [stepAround, 0], ArrowUp: [0, stepAround], ArrowDown: [0, -stepAround]}[event.key];
  if (step) view?.turn(step[0]!, step[1]!);
  else if (event.key === "+" || event.key === "=") view?.turn(0, 0, 1.15);
  else if (event.key === "-") view?.turn(0, 0, 1 / 1.15);
  else return;
  event.preventDefault();
  event.stopPropagation();
}

async function start(canvas: HTMLCanvasElement, stopped: () => boolean): Promise<AvatarView | null> {
  try {
    const {AvatarView: View} = await import("../view/avatar_view.ts");
    if (stopped()) return null;
    const view = new View(canvas);
    await view.load("/avatar.glb");
    return view;
  } catch (problem) {
    complain(`The avatar cannot be shown: ${wordsOf(problem)}`);
    return null;
  }
}

const shownName = computed(() => preview.value?.name ?? null);

// Which gesture the avatar shows, where that is not the motion.
function Shown() {
  return shownName.value === null ? null : <p class="shown">Shown: {shownName.value}</p>;
}

export function Stage() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const view = useRef<AvatarView | null>(null);
  useEffect(() => {
    const place = canvas.current!;
    let stopped = false;
    const endings: (() => void)[] = [() => { stopped = true; }];
    void start(place, () => stopped).then(made => {
      if (!made || stopped) return;
      view.current = made;
      stageView.value = made;
      performance.mark("avatar");
      const watch = new ResizeObserver(() => made.setSize(place.clientWidth, place.clientHeight));
      watch.observe(place);
      endings.push(() => watch.disconnect(), () => made.dispose(),
          effect(() => {
            if (preview.value) made.show(preview.value.tracks, preview.value.time_s);
            else made.show(studioDocument.value.motion?.tracks ?? null, playhead.value, playing.value);
          }),
          effect(() => made.look(chosenCamera.value.camera)),
          effect(() => made.showBall(ball.value)),
          effect(() => {
            void scheme.value;
            made.setColours(colour("--wall"), colour("--ground"));
          }));
    });
    return () => endings.forEach(end => end());
  }, []);
  const {motion} = studioDocument.value;
  return <section class="stage" aria-label="Avatar">
    <canvas ref={canvas} tabIndex={0} role="application" aria-roledescription="3D view" class={stageView.value ? "ready" : ""}
        aria-label="The avatar. Arrow keys turn the view, plus and minus come closer and go away."
        onKeyDown={event => turnByKey(event, view.current)} />
    {stageView.value && <Handles view={stageView.value} />}
    {!stageView.value && <p class="stage-note">The avatar is coming …</p>}
    {stageView.value && ball.value && <BallHandle view={stageView.value} />}
    <StageTools />
    <div class="chips">
      {motion && <p class="made-by">{motion.synthetic ? "Synthetic motion" : "Motion"}{motion.system ? `, made by ${motion.system}` : ""}</p>}
      {!trial.value && <Shown />}
      <TrialBar />
    </div>
  </section>;
}
