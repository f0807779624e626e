// Rings about a joint, by which what hangs on it is turned.
import {Object3D, type Camera, type Scene} from "three";
import {TransformControls} from "three/examples/jsm/controls/TransformControls.js";
import type {Point, Turn} from "../model/posing.ts";

export interface Turning {
  readonly part: string;
  turned(turn: Turn): void;  // since the press
  ended(kept: boolean): void;
}

export class Turner {
  private readonly controls: TransformControls;
  private readonly pivot = new Object3D();
  private turning: Turning | null = null;

  constructor(camera: Camera, canvas: HTMLCanvasElement, scene: Scene, onChange: () => void, onHold: (held: boolean) => void) {
    this.controls = new TransformControls(camera, canvas);
    this.controls.setMode("rotate");
    this.controls.setSpace("world");
    this.controls.setSize(0.95);
    scene.add(this.pivot, this.controls.getHelper());
    this.controls.addEventListener("change", onChange);
    this.controls.addEventListener("dragging-changed", ({value}) => onHold(value === true));
    this.controls.addEventListener("objectChange", () => {
      if (!this.controls.dragging) return;  // put back
      const {x, y, z, w} = this.pivot.quaternion;
      this.turning?.turned([x, y, z, w]);
    });
    this.controls.addEventListener("mouseDown", () => window.addEventListener("keydown", this.escape, {capture: true}));
    this.controls.addEventListener("mouseUp", () => this.end(true));
    this.controls.enabled = false;
  }

  private readonly escape = (event: KeyboardEvent): void => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    this.controls.dragging = false;
    this.end(false);
  };

  private end(kept: boolean): void {
    window.removeEventListener("keydown", this.escape, {capture: true});
    this.turning?.ended(kept);
    this.pivot.quaternion.identity();
  }

  get part(): string { return this.turning?.part ?? ""; }

  // About a joint, or nowhere.
  show(at: Point | null, turning: Turning | null): void {
    this.turning = turning;
    this.controls.enabled = at !== null;
    if (at === null) {
      this.controls.detach();
      return;
    }
    if (!this.controls.dragging) this.pivot.position.set(...at);
    if (this.controls.object !== this.pivot) this.controls.attach(this.pivot);
  }

  dispose(): void {
    window.removeEventListener("keydown", this.escape, {capture: true});
    this.controls.dispose();
  }
}
