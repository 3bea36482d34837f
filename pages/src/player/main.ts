// Plays a motion: poses of every body at equal times. z is up, metres and seconds throughout.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Figure, veil } from "../scene/figure";
import { Path } from "../scene/path";
import { COARSE, FINE, floats, Shapes, type Drawn } from "../scene/shapes";
import { drawingOn, Surroundings, type Drawing } from "../scene/surroundings";
import { VIEWS } from "../scene/views";

interface Track { position: string; rotation: string; }
interface Motion extends Drawn {
  name: string; fps: number; count: number; keys: { time: number; partial: boolean }[]; bodies: string[];
  after: Track; before: Track | null; extent: number; size: number;
}
type Which = "before" | "both" | "after";

const $ = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;
const PLAY = "M7 4.500v15l12.500-7.500z", PAUSE = "M6 4.500h4.200v15H6zM13.800 4.500H18v15h-4.200z";
const NEAR = 1e-4; // [s] nearer to it, one is at a keyframe

const begin = (): void => {
  const motion = JSON.parse($("motion").textContent!) as Motion;
  const { count, fps, bodies } = motion, duration = (count - 1) / fps;
  let drawing: Drawing;
  try {
    drawing = drawingOn($<HTMLCanvasElement>("view"));
  } catch {
    $("trouble").textContent = "This browser cannot draw in three dimensions: WebGL 2 is missing or switched off.";
    $("trouble").hidden = false;
    return;
  }

  const { renderer, software } = drawing;

  // The figure, and the raw spline's as a ghost
  const extent = Math.max(2, motion.extent);
  const around = new Surroundings(extent, undefined, software);
  const wake = (): void => { if (!awake) requestAnimationFrame(tick); awake = true; };
  const draw = (): void => { wanted = true; wake(); };
  const shapes = new Shapes(motion, software ? 1 : renderer.capabilities.getMaxAnisotropy(), draw, software ? COARSE : FINE);
  const moving = motion.pieces.filter((piece) => !piece.still);
  const still = new Figure(bodies, motion.pieces.filter((piece) => piece.still), shapes);
  const solid = new Figure(bodies, moving, shapes);
  const ghost = motion.before && new Figure(bodies, moving, shapes, veil(0xd9603b, 0.42));
  around.scene.add(still.root, solid.root);
  if (ghost) around.scene.add(ghost.root);

  // The middle of what moves, smoothed over half a second, for a camera that goes along
  const middle = (position: Float32Array): Float32Array => {
    const parts = [...new Set(moving.map((piece) => piece.body))];
    const raw = Array.from({ length: count }, (_, i) => [0, 1, 2].map((k) =>
      parts.reduce((sum, body) => sum + position[3 * (i * bodies.length + body) + k], 0) / (parts.length || 1)));
    const wide = Math.max(1, Math.round(0.25 * fps)), out = new Float32Array(3 * count);
    raw.forEach((_, i) => [0, 1, 2].forEach((k) => {
      let sum = 0, weight = 0;
      for (let j = Math.max(0, i - 2 * wide); j <= Math.min(count - 1, i + 2 * wide); j++) {
        const w = Math.exp(-0.5 * ((j - i) / wide) ** 2);
        sum += w * raw[j][k];
        weight += w;
      }
      out[3 * i + k] = sum / weight;
    }));
    return out;
  };
  const path = (track: Track): Path => {
    const position = floats(track.position);
    return new Path(0, duration, fps, count, bodies.length, position, floats(track.rotation), middle(position));
  };
  const paths = { after: path(motion.after), before: motion.before && path(motion.before) };
  still.put(paths.after.at(0));

  // The camera
  const camera = new THREE.PerspectiveCamera(32, 1, 0.05, 600 + 40 * extent);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, $("view"));
  Object.assign(controls, { enableDamping: true, dampingFactor: 0.12, minDistance: 0.3, maxDistance: 60 + 4 * extent, maxPolarAngle: 0.96 * Math.PI });
  let centre = new THREE.Vector3();
  const middleAt = (time: number): THREE.Vector3 => new THREE.Vector3(...paths.after.centreAt(time));
  const aim = (name: string): void => {
    $<HTMLSelectElement>("camera").value = name;
    centre = middleAt(now);
    controls.target.copy(centre);
    const away = (2.9 * Math.max(1, motion.size)) / Math.min(1, camera.aspect * 0.9);
    camera.position.copy(centre).addScaledVector(new THREE.Vector3(...VIEWS[name]).normalize(), away);
    controls.update();
    draw();
  };
  controls.addEventListener("start", () => { $<HTMLSelectElement>("camera").value = "free"; });
  controls.addEventListener("change", draw);

  // Time
  let now = 0, playing = true, then: number | null = null, wanted = true, awake = false, which: Which = "after", drawn = "";
  const setPlaying = (yes: boolean): void => {
    if (yes && now >= duration) now = 0;
    playing = yes && duration > 0;
    $("icon").setAttribute("d", playing ? PAUSE : PLAY);
    then = null;
    wake();
  };
  const seek = (time: number): void => { now = Math.min(Math.max(time, 0), duration); draw(); };
  const step = (by: number): void => { setPlaying(false); seek((Math.round(now * fps) + by) / fps); };
  const toKey = (way: number): void => {
    setPlaying(false);
    const times = motion.keys.map((key) => key.time);
    seek((way > 0 ? times.find((t) => t > now + NEAR) : times.findLast((t) => t < now - NEAR)) ?? (way > 0 ? duration : 0));
  };
  const setWhich = (name: Which): void => {
    which = paths.before ? name : "after";
    for (const input of document.querySelectorAll<HTMLInputElement>("[name=which]")) input.checked = input.value === which;
    draw();
  };

  const render = (): void => {
    solid.put((which === "before" && paths.before ? paths.before : paths.after).at(now));
    if (ghost && paths.before) {
      ghost.root.visible = which === "both";
      if (ghost.root.visible) ghost.put(paths.before.at(now));
    }
    const here = middleAt(now);
    if ($<HTMLInputElement>("follow").checked) {
      const moved = here.clone().sub(centre);
      camera.position.add(moved);
      controls.target.add(moved);
    }
    centre = here;
    around.follow(here);
    renderer.render(around.scene, camera);
    drawn = `${now} ${which}`;
    $<HTMLInputElement>("scrub").value = String(duration ? now / duration : 0);
    $("scrub").style.setProperty("--done", `${duration ? (100 * now) / duration : 0}%`);
    $("clock").innerHTML = `<b>${now.toFixed(2)}</b> / ${duration.toFixed(2)} s &ensp;frame ${Math.round(now * fps)}`;
  };
  const tick = (stamp: number): void => {
    awake = false;
    if (playing) {
      if (then !== null) {
        now += Math.min(0.25, (stamp - then) / 1000) * Number($<HTMLSelectElement>("speed").value);
        if (now > duration && $<HTMLInputElement>("loop").checked) now %= duration;
        else if (now >= duration) { now = duration; setPlaying(false); }
      }
      then = playing ? stamp : null;
      draw();
    }
    controls.update();
    if (wanted) { wanted = false; render(); }
  };
  const resize = (): void => {
    const { innerWidth: width, innerHeight: height } = window;
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.setViewOffset(width, height, 0, 0.45 * $("bar").offsetHeight, width, height);
    camera.updateProjectionMatrix();
    draw();
  };

  // The bar
  $("about").textContent = `${duration.toFixed(2)} s, ${count} samples at ${+fps.toFixed(3)} a second, ${motion.keys.length} keyframes`;
  $("which").hidden = !paths.before;
  $("marks").classList.toggle("crowded", motion.keys.length > 60);
  for (const key of motion.keys) {
    const mark = document.createElement("button");
    mark.style.left = `${duration ? (100 * key.time) / duration : 0}%`;
    mark.className = key.partial ? "partial" : "";
    mark.title = `${key.partial ? "partial keyframe" : "keyframe"} at ${key.time.toFixed(3)} s`;
    mark.tabIndex = -1;
    mark.addEventListener("click", () => { setPlaying(false); seek(key.time); });
    $("marks").append(mark);
  }
  $("play").addEventListener("click", () => setPlaying(!playing));
  $("previous").addEventListener("click", () => toKey(-1));
  $("next").addEventListener("click", () => toKey(1));
  $("scrub").addEventListener("input", () => { setPlaying(false); seek(Number($<HTMLInputElement>("scrub").value) * duration); });
  $("camera").addEventListener("change", () => aim($<HTMLSelectElement>("camera").value));
  $("follow").addEventListener("change", draw);
  for (const input of document.querySelectorAll<HTMLInputElement>("[name=which]")) input.addEventListener("change", () => setWhich(input.value as Which));
  window.addEventListener("resize", resize);
  $("view").addEventListener("webglcontextrestored", draw);
  window.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || (event.target as HTMLElement).tagName === "SELECT") return;
    const speed = $<HTMLSelectElement>("speed");
    const faster = (by: number): void => { speed.selectedIndex = Math.min(Math.max(speed.selectedIndex + by, 0), speed.length - 1); };
    const deeds: Record<string, () => void> = {
      " ": () => setPlaying(!playing), ArrowLeft: () => step(-1), ArrowRight: () => step(1), PageUp: () => toKey(-1),
      PageDown: () => toKey(1), Home: () => seek(0), End: () => seek(duration), f: () => $("follow").click(),
      l: () => $("loop").click(), "+": () => faster(1), "-": () => faster(-1), 1: () => setWhich("before"),
      2: () => setWhich("both"), 3: () => setWhich("after"),
    };
    if (!(event.key in deeds)) return;
    event.preventDefault();
    deeds[event.key]();
  });

  // For pages that embed this one, and for tests
  Object.assign(window, {
    player: {
      seek: (time: number) => { setPlaying(false); seek(time); }, show: setWhich, aim, play: setPlaying,
      get time() { return now; }, get playing() { return playing; }, get which() { return which; },
      get settled() { return !awake && drawn === `${now} ${which}`; },
      place: (name: string) => solid.groups[bodies.indexOf(name)].getWorldPosition(new THREE.Vector3()).toArray(),
    },
  });
  resize();
  aim("quarter");
  setPlaying(true);
};

begin();
