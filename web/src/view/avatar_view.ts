// The avatar in its room, drawn when something has changed: the pose, the camera, the size or the colours.
import {AmbientLight, CircleGeometry, Color, DirectionalLight, Fog, Group, HemisphereLight, Mesh, MeshStandardMaterial, PCFShadowMap,
  PerspectiveCamera, Scene, SphereGeometry, Vector3, WebGLRenderer, type Object3D} from "three";
import {OrbitControls} from "three/examples/jsm/controls/OrbitControls.js";
import {GLTFLoader} from "three/examples/jsm/loaders/GLTFLoader.js";
import type {Tracks} from "../model/document.ts";
import type {Point} from "../model/posing.ts";
import {eyeHeight_m, places, sides, viewOf_deg, type Camera} from "./cameras.ts";
import {bonesOf, pose} from "./pose.ts";
import {Turner, type Turning} from "./turner.ts";

// Where the camera looks at, and from which distance: the upper body fills the picture.
const middle = new Vector3(0, 1.22, 0);
const distance = 2.5;
const usualView_deg = 32;
const reach = 0.01;  // whoever looks from a place looks at a point that near, and so turns on the spot
const ballRadius_m = 0.06;

// Somebody who stands at ease, until there is a motion: the avatar's rest pose spreads its arms.
const atEase: Tracks = {fps: 15, bones: ["leftUpperArm", "rightUpperArm", "leftLowerArm", "rightLowerArm"], rotations: [[
  0.04, 0, -0.6, 0.8, 0.04, 0, 0.6, 0.8, 0, -0.12, -0.06, 0.99, 0, 0.12, 0.06, 0.99]]};

export class AvatarView {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(usualView_deg, 1, 0.05, 40);
  private readonly controls: OrbitControls;
  private readonly floor: Mesh<CircleGeometry, MeshStandardMaterial>;
  private readonly sky = new HemisphereLight();
  private bones = new Map<string, Object3D>();
  private shown: {tracks: Tracks; time_s: number} = {tracks: atEase, time_s: 0};
  private waiting = 0;
  private from: Camera = "front";
  private turner: Turner | null = null;
  private readonly ball = new Mesh(new SphereGeometry(ballRadius_m, 32, 16), new MeshStandardMaterial({color: 0xd2542f, roughness: 0.5}));
  readonly drawn = new Set<() => void>();  // called when the picture has changed

  // Throws where the browser has no WebGL 2.
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({canvas, antialias: true, powerPreference: "high-performance"});
    this.renderer.debug.checkShaderErrors = false;  // asking for them waits for the compiler
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enablePan = false;
    this.controls.minDistance = 0.8;
    this.controls.maxDistance = 8;
    this.controls.maxPolarAngle = 0.55 * Math.PI;
    this.controls.addEventListener("change", () => this.draw());
    this.floor = new Mesh(new CircleGeometry(14, 64), new MeshStandardMaterial({roughness: 1}));
    this.floor.rotation.x = -0.5 * Math.PI;
    this.floor.receiveShadow = true;
    this.ball.castShadow = true;
    this.ball.visible = false;
    this.scene.add(this.floor, this.lights(), this.ball);
    this.look("front");
  }

  private lights(): Group {
    const key = new DirectionalLight(0xfff4e6, 2.4);
    key.position.set(1.6, 3.4, 2.6);
    key.target.position.copy(middle);
    key.castShadow = true;
    key.shadow.mapSize.set(1024, 1024);
    key.shadow.radius = 5;
    key.shadow.bias = -0.0004;
    key.shadow.normalBias = 0.02;
    Object.assign(key.shadow.camera, {left: -1.6, right: 1.6, top: 1.8, bottom: -1.8, near: 0.5, far: 9});
    const rim = new DirectionalLight(0xdfe8ff, 0.9);
    rim.position.set(-2.2, 2.4, -2.4);
    const lights = new Group();
    lights.add(this.sky, new AmbientLight(0xffffff, 0.25), key, key.target, rim);
    return lights;
  }

  async load(address: string): Promise<void> {
    const {scene} = await new GLTFLoader().loadAsync(address);
    scene.traverse(object => {
      if (!(object instanceof Mesh)) return;
      object.castShadow = true;
      object.frustumCulled = false;  // its bounds are those of the rest pose
    });
    this.scene.add(scene);
    this.bones = bonesOf(scene);
    this.apply();
  }

  // The motion at a time; null: at ease. `now`: in this frame of the screen, not the next one.
  show(tracks: Tracks | null, time_s: number, now = false): void {
    this.shown = {tracks: tracks ?? atEase, time_s};
    if (now) {
      pose(this.bones, this.shown.tracks, time_s);
      this.drawNow();
    } else {
      this.apply();
    }
  }

  private apply(): void {
    pose(this.bones, this.shown.tracks, this.shown.time_s);
    this.draw();
  }

  setColours(wall: string, ground: string): void {
    this.scene.background = new Color(wall);
    this.scene.fog = new Fog(new Color(wall), 5, 13);
    this.floor.material.color.set(ground);
    this.sky.color.set(0xffffff);
    this.sky.groundColor.set(ground);
    this.sky.intensity = 1.1;
    this.draw();
  }

  setSize(width: number, height: number, ratio = Math.min(window.devicePixelRatio, 2)): void {
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.setLens();
    this.draw();
  }

  private setLens(): void {
    this.camera.fov = places[this.from] ? viewOf_deg(this.camera.aspect) : usualView_deg;
    this.camera.updateProjectionMatrix();
  }

  look(from: Camera): void {
    this.from = from;
    const place = places[from];
    const {controls, camera} = this;
    controls.minDistance = place ? reach : 0.8;
    controls.maxDistance = place ? reach : 8;
    controls.maxPolarAngle = place ? 0.9 * Math.PI : 0.55 * Math.PI;
    controls.rotateSpeed = place ? -0.4 : 1;
    if (place) {
      const heading = place.heading_deg * Math.PI / 180;
      camera.position.set(place.viewer_m[0], eyeHeight_m, place.viewer_m[1]);
      controls.target.set(Math.sin(heading), -0.12, Math.cos(heading)).setLength(reach).add(camera.position);
    } else {
      controls.target.copy(middle);
      camera.position.set(...sides[from]!).setLength(distance).add(middle);
    }
    this.setLens();
    controls.update();
    this.draw();
  }

  // By keyboard: radians about the avatar and up; `closer` divides the distance. From a participant's place: of the head.
  turn(around: number, up: number, closer = 1): void {
    const onTheSpot = places[this.from] !== undefined;
    const fixed = onTheSpot ? this.camera.position.clone() : null;
    const from = this.camera.position.clone().sub(this.controls.target);
    const radius = Math.min(Math.max(from.length() / closer, this.controls.minDistance), this.controls.maxDistance);
    const way = onTheSpot ? -1 : 1;
    const polar = Math.min(Math.max(Math.acos(from.y / from.length()) - way * up, 0.05), this.controls.maxPolarAngle);
    const azimuth = Math.atan2(from.x, from.z) + way * around;
    from.set(Math.sin(polar) * Math.sin(azimuth), Math.cos(polar), Math.sin(polar) * Math.cos(azimuth)).multiplyScalar(radius);
    if (fixed) this.controls.target.copy(fixed).sub(from);
    else this.camera.position.copy(this.controls.target).add(from);
    this.controls.update();
    this.draw();
  }

  // As another view looks.
  lookAs(other: AvatarView): void {
    this.look(other.from);
    this.camera.position.copy(other.camera.position);
    this.controls.target.copy(other.controls.target);
    this.controls.update();
  }

  // The ball that is pointed at; null: none.
  showBall(at: Point | null): void {
    this.ball.visible = at !== null;
    if (at) this.ball.position.set(...at);
    this.draw();
  }

  // Rings that turn what hangs on a joint; none where `at` is null.
  showTurner(at: Point | null, turning: Turning | null): void {
    if (!at && !this.turner) return;
    this.turner ??= new Turner(this.camera, this.canvas, this.scene, () => this.draw(), held => { this.controls.enabled = !held; });
    this.turner.show(at, turning);
    this.draw();
  }

  // Where a bone begins, in metres; null for one that the avatar does not have.
  place(bone: string): Point | null {
    const found = this.bones.get(bone);
    if (!found) return null;
    found.updateWorldMatrix(true, false);
    return new Vector3().setFromMatrixPosition(found.matrixWorld).toArray();
  }

  // A point in px of the picture.
  seen(point: Point): {x: number; y: number} {
    const at = new Vector3(...point).project(this.camera);
    return {x: 0.5 * (1 + at.x) * this.canvas.clientWidth, y: 0.5 * (1 - at.y) * this.canvas.clientHeight};
  }

  // The point moved over the picture by px, at the depth that it has; `nearer` in metres towards the camera.
  shifted(point: Point, right_px: number, up_px: number, nearer = 0): Point {
    const at = new Vector3(...point);
    const depth = at.clone().applyMatrix4(this.camera.matrixWorldInverse).z;
    const metres = 2 * -depth * Math.tan(0.5 * this.camera.fov * Math.PI / 180) / this.canvas.clientHeight;
    const axes = [new Vector3(), new Vector3(), new Vector3()] as const;
    this.camera.matrixWorld.extractBasis(...axes);
    return at.addScaledVector(axes[0], right_px * metres).addScaledVector(axes[1], up_px * metres).addScaledVector(axes[2], nearer).toArray();
  }

  // At most once a frame of the screen.
  private draw(): void {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => this.drawNow());
  }

  private drawNow(): void {
    cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    this.canvas.dataset.time = this.shown.time_s.toFixed(3);
    this.renderer.render(this.scene, this.camera);
    this.canvas.dataset.turns = this.turner?.part ?? "";
    for (const listener of this.drawn) listener();
  }

  dispose(): void {
    cancelAnimationFrame(this.waiting);
    this.turner?.dispose();
    this.controls.dispose();
    this.renderer.dispose();
  }
}
