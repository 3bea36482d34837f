// The stage: figure, ghosts, camera. It draws when something has changed, and every image while it plays.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Figure, UNSEEN, veil, type Pose } from "../scene/figure";
import type { Path } from "../scene/path";
import { COARSE, FINE, Shapes } from "../scene/shapes";
import { DAY, DUSK, drawingOn, Surroundings } from "../scene/surroundings";
import { VIEWS } from "../scene/views";
import { $ } from "./dom";
import { changed, isAwaiting, isChanging } from "./link";
import { model } from "./model";

const MOST_GHOSTS = 14;
const SLOW = 45; // [ms] an image while something moves, from which on it has fewer points
const FAST = 18; // [ms] from which on, so many times in a row, it has more again
const SURE = 30;
const REST = 220; // [ms] after the last movement until it is drawn with all of them
const REST_SEARCHING = 900; // by a processor that loads or searches meanwhile
const LEAVE = 90; // [ms] from one image to the next that a processor which draws leaves to the search while it plays
const LEAVE_STILL = 130; // while it does not: only better paths change the view
const SCALES = [0.4, 0.55, 0.75, 1]; // of the pixels along either side: few steps, because each change allocates a new canvas
const MERGED = 240; // triangles of a body that a processor draws
const GHOSTLY = 80; // of a ghost's
const ROUGH = 0.75; // up to which the figure itself has fewer triangles, too
const MARGIN = 1.12; // of the distance from which the figure just fits
const LOWEST = 0.05; // [m] of the camera above the ground
const KEPT = "dynsplines-view"; // of this tab, also after it is loaded again
const SHARP = 1.4; // of them when all is still, by a processor: edges are smooth

type Side = { figure: Figure; path: () => Path | null };

export class Stage {
  private readonly drawing = drawingOn($<HTMLCanvasElement>("view"));
  readonly canvas = this.drawing.canvas;
  readonly software = this.drawing.software;
  readonly renderer = this.drawing.renderer;
  readonly around = new Surroundings(4, DUSK, this.software);
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.03, 900);
  readonly orbit: OrbitControls;
  readonly extra = new THREE.Group(); // of others: trails, handles
  readonly caster = new THREE.Raycaster();
  figure: Figure | null = null;
  override: Pose | null = null; // a pose that is being dragged, in place of the path's
  sights: (() => void)[] = []; // called before every image
  images = 0;
  private shapes: Shapes | null = null;
  private still: Figure | null = null;
  private sides: Record<string, Side> = {};
  private ghosts: Figure[] = [];
  private wanted = true;
  private isAwake = false; // whether an animation frame is awaited
  private step = this.software ? 1 : SCALES.length - 1; // of the scales, while something moves
  private quick = 0; // images in a row that came fast
  private drawnAt = SCALES[this.step]; // the scale of the last image, or of the first
  private box = [0, 0]; // [px] of the canvas on the page
  private stamp = 0;
  private moved = 0;
  private then: number | null = null;
  private centre = new THREE.Vector3();
  private aimed = false;
  private fitted = 0; // [m] distance that was chosen to fit; at another one the user has zoomed

  constructor() {
    const { camera } = this;
    camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(camera, this.canvas);
    Object.assign(this.orbit, { enableDamping: true, dampingFactor: 0.15, minDistance: 0.25, maxDistance: 90, maxPolarAngle: 0.97 * Math.PI });
    this.orbit.addEventListener("change", () => { this.nameView(); this.draw(); });
    window.addEventListener("pagehide", () => {
      sessionStorage[KEPT] = JSON.stringify({ at: location.search, time: model.time, range: model.range.map(String), camera: camera.position.toArray(), locks: [...model.locks], fk: [...model.fk], target: this.orbit.target.toArray() });
    });
    this.around.scene.add(this.extra);
    this.caster.layers.enable(UNSEEN);
    model.on("stage", () => this.build());
    model.on("path", () => this.arrived());
    model.on(["time", "which", "selection", "document", "joint"], () => this.draw());
    model.on("loaded", () => this.haunt());
    model.on("shown", () => this.haunt());
    model.on("theme", () => {
      this.around.light(document.documentElement.dataset.theme === "light" ? DAY : DUSK);
      this.draw();
    });
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement!);
    this.resize();
    this.wake();
  }

  draw(): void {
    this.wanted = true;
    this.wake();
  }

  private wake(): void {
    if (!this.isAwake) requestAnimationFrame(this.tick);
    this.isAwake = true;
  }

  /** Looks from a side by name, from where the figure fits, or the obstacles, too; a distance that the user has chosen stays. */
  aim(name: string, whole = false): void {
    const { orbit, camera, figure, still } = this, box = new THREE.Box3(), away = camera.position.distanceTo(orbit.target);
    if (model.now?.bodies === figure?.groups.length) figure!.put(model.now!.at(model.time)); // it may not have been drawn there yet
    for (const group of figure?.groups ?? []) box.expandByObject(group);
    for (const group of whole ? still?.groups ?? [] : []) {
      for (const mesh of group.children) if (!still!.planes.some((plane) => plane.mesh === mesh)) box.expandByObject(mesh);
    }
    this.centre.copy(this.middle());
    box.isEmpty() ? orbit.target.copy(this.centre) : box.getCenter(orbit.target);
    const radius = Math.max(0.3, box.getSize(new THREE.Vector3()).length() / 2), narrow = Math.min(1, camera.aspect);
    const fits = (MARGIN * radius) / Math.sin(Math.atan(narrow * Math.tan((camera.fov * Math.PI) / 360)));
    const stays = !whole && this.fitted > 0 && Math.abs(away - this.fitted) > 1e-3 * away;
    if (!stays) this.fitted = fits;
    camera.position.copy(orbit.target).addScaledVector(new THREE.Vector3(...VIEWS[name]).normalize(), stays ? away : fits);
    this.nameView();
    this.draw();
  }

  /** The name of the present view in the menu. */
  private nameView(): void {
    const from = this.camera.position.clone().sub(this.orbit.target).normalize();
    const found = Object.entries(VIEWS).find(([, side]) => from.dot(new THREE.Vector3(...side).normalize()) > 1 - 1e-5);
    $<HTMLSelectElement>("views").value = found?.[0] ?? "free";
  }

  /** Time and camera as they were before the page was loaded again. */
  private restored(): boolean {
    const kept = JSON.parse(sessionStorage[KEPT] ?? "null");
    if (kept?.at !== location.search) return false;
    model.seek(kept.time);
    model.range = kept.range.map(Number);
    model.tell("range");
    for (const name of kept.locks) model.locks.add(name);
    for (const name of kept.fk) model.fk.add(name);
    this.centre.copy(this.middle());
    this.orbit.target.fromArray(kept.target);
    this.camera.position.fromArray(kept.camera);
    this.fitted = Infinity;
    return true;
  }

  /** [m] the width of a pixel in a plane that faces the camera. */
  perPixel(plane: THREE.Plane): number {
    const { camera, canvas } = this;
    return (2 * Math.abs(plane.distanceToPoint(camera.position)) * Math.tan((camera.fov * Math.PI) / 360)) / canvas.clientHeight;
  }

  /** A ray through a point of the page. */
  through({ clientX, clientY }: { clientX: number; clientY: number }): THREE.Ray {
    const box = this.canvas.getBoundingClientRect();
    this.caster.setFromCamera(new THREE.Vector2(((clientX - box.left) / box.width) * 2 - 1, 1 - ((clientY - box.top) / box.height) * 2), this.camera);
    return this.caster.ray;
  }

  /** Shows a pose that the studio has answered, in place of the path's. */
  show(answer: Record<string, unknown>): void {
    this.override = { position: answer.position as number[], rotation: answer.rotation as number[] };
    this.draw();
  }

  /** Where a point of a body is shown. */
  placeOf(body: number, offset: number[]): THREE.Vector3 {
    const group = this.figure!.groups[body];
    return new THREE.Vector3().fromArray(offset).applyQuaternion(group.quaternion).add(group.position);
  }

  private build(): void {
    const { stage } = model;
    if (!stage) return;
    for (const each of [this.figure, this.still, ...Object.values(this.sides).map((s) => s.figure), ...this.ghosts]) each?.dispose();
    this.shapes?.dispose();
    const shapes = (this.shapes = new Shapes(stage, this.software ? 1 : this.renderer.capabilities.getMaxAnisotropy(), () => this.draw(), this.software ? COARSE : FINE));
    const moving = stage.pieces.filter((piece) => !piece.still), rough = this.software ? MERGED : 0;
    this.still = new Figure(stage.bodies, stage.pieces.filter((piece) => piece.still), shapes);
    this.figure = new Figure(stage.bodies, moving, shapes, undefined, rough);
    this.sides = {
      before: { figure: new Figure(stage.bodies, moving, shapes, veil(0xe0663f, 0.42), rough), path: () => model.raw },
      snapshot: { figure: new Figure(stage.bodies, moving, shapes, veil(0x4f9fe0, 0.45), rough), path: () => model.snapshot },
    };
    this.ghosts = [];
    this.around.scene.add(this.still.root, this.figure.root, ...Object.values(this.sides).map((side) => side.figure.root));
    this.haunt();
  }

  /** Ghosts of the keyframes, or of every few frames. */
  private haunt(): void {
    for (const ghost of this.ghosts) model.ghosts ? (ghost.root.visible = false) : ghost.dispose();
    if (!model.ghosts) this.ghosts = [];
    const { stage, document, now } = model;
    if (model.ghosts && stage && this.shapes && document && now) {
      const every = Number(model.ghosts) / model.fps; // [s]
      const times = model.ghosts === "keys" ? document.keys.map(({ time }) => time) : Array.from({ length: Math.floor((now.last - now.first) / every + 1e-6) + 1 }, (_, i) => now.first + i * every);
      const step = Math.ceil(times.length / (this.software ? MOST_GHOSTS / 2 : MOST_GHOSTS));
      const moving = stage.pieces.filter((piece) => !piece.still);
      times.filter((_, i) => i % step === 0).forEach((time, i) => {
        if (!this.ghosts[i]) {
          this.ghosts[i] = new Figure(stage.bodies, moving, this.shapes!, veil(0x8fb4d9, 0.2, 0.08), this.software ? GHOSTLY : 0);
          this.around.scene.add(this.ghosts[i].root);
        }
        this.ghosts[i].root.visible = true;
        this.ghosts[i].put(now.at(time));
      });
    }
    this.draw();
  }

  private arrived(): void {
    if (model.now && model.stage && !this.aimed) {
      this.aimed = true;
      if (!this.restored()) this.aim("quarter");
    }
    this.haunt();
  }

  /** The present pose: what is dragged, or the path's. */
  private pose(): Pose | null {
    const { now } = model;
    return this.override ?? (now?.bodies === this.figure?.groups.length ? now!.at(model.time) : null);
  }

  private middle(): THREE.Vector3 {
    const { now } = model;
    if (!now) return new THREE.Vector3(0, 0, 0.8);
    const [x, y, z] = now.centreAt(model.time);
    return new THREE.Vector3(x, y, z);
  }

  /** Animation frames follow each other until nothing moves and all is drawn as well as it can be. */
  private readonly tick = (stamp: number): void => {
    this.isAwake = false;
    const orbits = this.advance(stamp);
    this.stamp = stamp;
    if (orbits || model.playing || this.wanted || this.drawnAt < this.finest || stamp - this.moved < REST) this.wake();
  };

  /** Draws what has changed by now. Returns whether the camera still moves on its own. */
  private advance(stamp: number): boolean {
    if (model.playing) {
      if (this.then !== null) {
        const gap = stamp - this.then;
        const next = model.time + (Math.min(250, gap) / 1000) * model.speed;
        const [begin, end] = model.played;
        if (next > end && !model.loop) { model.playing = false; model.seek(end); }
        else model.seek(next > end ? begin + ((next - begin) % Math.max(1e-3, end - begin)) : next);
      }
      this.then = model.playing ? stamp : null;
    } else this.then = null;
    const { orbit, camera } = this, high = (LOWEST - orbit.target.z) / camera.position.distanceTo(orbit.target);
    if (this.still?.planes.length) orbit.maxPolarAngle = Math.acos(Math.min(Math.max(high, -1), 1)); // not below the ground
    const orbits = orbit.update();
    const searching = this.software && (model.status.state === "searching" || model.status.state === "loaded" || isAwaiting());
    const loading = this.software && model.status.state === "loading";
    const yields = searching && (!this.override || isChanging()) && stamp - Math.max(this.moved, changed) < (model.playing ? LEAVE : LEAVE_STILL);
    if (!this.figure || !(model.now || this.override) || yields) return orbits;
    if (this.wanted) {
      this.pace(stamp);
      this.render(SCALES[this.step]);
      this.moved = stamp;
    } else if (this.drawnAt < this.finest && stamp - this.moved > (searching || loading ? REST_SEARCHING : REST)) this.render(this.finest);
    return orbits;
  }

  private get finest(): number { return this.software ? SHARP : 1; }

  /** Fewer points while images come slowly. */
  private pace(stamp: number): void {
    const gap = stamp - this.stamp;
    if (stamp - this.moved > REST) return;
    this.quick = gap < FAST ? this.quick + 1 : 0;
    if (gap > SLOW) this.step = Math.max(0, this.step - (gap > 2.5 * SLOW ? 2 : 1));
    else if (this.quick >= SURE) {
      this.quick = 0;
      this.step = Math.min(SCALES.length - 1, this.step + 1);
    }
  }

  /** What a processor draws while something moves: no shadows, no lights on the floor; else all of it. */
  private simplified(yes: boolean): void {
    const { still, around } = this;
    if (!this.software || !still) return;
    around.shadows = !yes;
    const light = around.onGround();
    for (const { mesh, part } of still.planes) {
      part.plain!.color.copy(part.plain!.userData.own as THREE.Color).multiply(light);
      mesh.material = yes ? part.plain! : part.material;
    }
  }

  private render(scale: number): void {
    this.wanted = false;
    this.take(scale);
    const pose = this.pose();
    if (this.figure && pose) {
      this.figure.isRough = this.software && scale <= ROUGH;
      this.figure.put(pose);
      this.still?.put(pose);
      this.figure.root.visible = model.which !== "before" || this.override !== null;
      for (const [name, side] of Object.entries(this.sides)) {
        const path = side.path();
        const shown = name === "before" ? model.which === "before" || model.which === "both" : model.which === "snapshot";
        side.figure.root.visible = shown && path !== null && path.bodies === side.figure.groups.length;
        if (side.figure.root.visible) side.figure.put(path!.at(model.time));
      }
    }
    const here = this.middle();
    if (model.follow && !this.override && model.stage?.joints.some(({ kind }) => kind === "free")) { // nothing leaves a fixed base
      const moved = here.clone().sub(this.centre);
      this.camera.position.add(moved);
      this.orbit.target.add(moved);
    }
    this.centre.copy(here);
    this.around.follow(here);
    for (const sight of this.sights) sight();
    this.simplified(scale < this.finest);
    const { renderer } = this, scene = this.around.scene;
    if (model.which === "side") this.renderHalves(...renderer.getSize(new THREE.Vector2()).toArray());
    else renderer.render(scene, this.camera);
    this.images += 1;
  }

  /** Before on the left, after on the right, of so many points. */
  private renderHalves(wide: number, high: number): void {
    const { renderer, camera } = this, half = Math.floor(wide / 2);
    renderer.setScissorTest(true);
    camera.aspect = half / high;
    camera.updateProjectionMatrix();
    const before = this.sides.before?.figure, after = this.figure;
    for (const [left, first] of [[0, true], [half, false]] as [number, boolean][]) {
      renderer.setViewport(left, 0, half, high);
      renderer.setScissor(left, 0, half, high);
      if (first && before && after && model.raw) after.put(model.raw.at(model.time));
      else if (after && model.now) after.put(model.now.at(model.time));
      renderer.render(this.around.scene, camera);
    }
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, wide, high);
    camera.aspect = wide / high;
    camera.updateProjectionMatrix();
  }

  /** A canvas of so many points for each of the screen's. */
  private take(scale: number): void {
    if (scale === this.drawnAt) return;
    this.drawnAt = scale;
    this.sized();
  }

  /** Sets the canvas size, with all changes at once, because each one waits for everything drawn before. */
  private sized(): void {
    const [wide, high] = this.box, scale = this.drawnAt * (this.software ? 1 : Math.min(window.devicePixelRatio, 2));
    if (wide && high) this.renderer.setDrawingBufferSize(wide, high, scale);
  }

  private resize(): void {
    const box = this.canvas.parentElement!.getBoundingClientRect();
    if (!box.width || !box.height || (box.width === this.box[0] && box.height === this.box[1])) return;
    this.box = [box.width, box.height];
    this.sized();
    this.camera.aspect = box.width / box.height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }
}
