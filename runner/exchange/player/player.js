// Plays a motion: poses of every body at equal times, drawn by three.js. z is up, metres and seconds throughout.
(() => {
"use strict";
const $ = (id) => document.getElementById(id);
const motion = JSON.parse($("motion").textContent);
const trouble = (text) => { $("trouble").textContent = text; $("trouble").hidden = false; };

const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
const floats = (text) => new Float32Array(bytes(text));
const track = (side) => side && { position: floats(side.position), rotation: floats(side.rotation) };
const tracks = { after: track(motion.after), before: track(motion.before) };
const { count, fps, bodies } = motion;
const duration = (count - 1) / fps;
const turn = new THREE.Quaternion();

let renderer;
try {
  renderer = new THREE.WebGLRenderer({ canvas: $("view"), antialias: true });
} catch (error) {
  trouble("This browser cannot draw in three dimensions: WebGL 2 is missing or switched off.");
  return;
}
renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = THREE.PCFShadowMap;
renderer.toneMapping = THREE.NeutralToneMapping;

// What surrounds the figure
const scene = new THREE.Scene();
const haze = new THREE.Color().setRGB(0.9, 0.915, 0.93, THREE.SRGBColorSpace);
const zenith = new THREE.Color().setRGB(0.6, 0.69, 0.78, THREE.SRGBColorSpace);
const extent = Math.max(2, motion.extent);
scene.background = haze;
scene.fog = new THREE.Fog(haze, 4 + 2 * extent, 22 + 6 * extent);
{
  const dome = new THREE.SphereGeometry(150 + 20 * extent, 32, 24).rotateX(Math.PI / 2);
  const place = dome.attributes.position, colours = new Float32Array(place.count * 3), colour = new THREE.Color();
  for (let i = 0; i < place.count; i++) {
    const up = Math.max(0, place.getZ(i)) / dome.parameters.radius;
    colour.copy(haze).lerp(zenith, Math.min(1, 1.3 * up)).toArray(colours, 3 * i);
  }
  dome.setAttribute("color", new THREE.BufferAttribute(colours, 3));
  const paint = new THREE.MeshBasicMaterial({ vertexColors: true, side: THREE.BackSide, fog: false, toneMapped: false });
  scene.add(new THREE.Mesh(dome, paint));
}
scene.add(new THREE.HemisphereLight(0xf4f8ff, 0xb9ab9a, 1.9));
const sun = new THREE.DirectionalLight(0xfff4e2, 2.3);
sun.castShadow = true;
sun.shadow.mapSize.set(2048, 2048);
sun.shadow.bias = -0.0004;
sun.shadow.normalBias = 0.012;
sun.shadow.radius = 2.5;
Object.assign(sun.shadow.camera, { left: -2.6, right: 2.6, top: 2.6, bottom: -2.6, near: 0.5, far: 16 });
const fill = new THREE.DirectionalLight(0xdfe9ff, 0.5);
fill.position.set(-2, 3, 2.5);
scene.add(sun, sun.target, fill);

// Geometries by what they are, so that like geoms share one
const known = new Map();
const corners = (radius) => Math.min(40, Math.max(10, 4 * Math.ceil(Math.PI / Math.sqrt(0.0012 / radius) / 4)));
const shape = (piece) => {
  const key = piece.kind + piece.size + (piece.mesh ?? "") + (piece.repeat ?? "");
  if (!known.has(key)) known.set(key, make(piece));
  return known.get(key);
};
const make = ({ kind, size, mesh, repeat }) => {
  const [a, b, c] = size;
  switch (kind) {
    case "plane": {
      const flat = new THREE.PlaneGeometry(2 * a, 2 * b);
      if (repeat) {
        const place = flat.attributes.position, uv = flat.attributes.uv;
        for (let i = 0; i < 4; i++) uv.setXY(i, place.getX(i) * repeat[0], place.getY(i) * repeat[1]);
      }
      return flat;
    }
    case "box": return new THREE.BoxGeometry(2 * a, 2 * b, 2 * c);
    case "sphere": return new THREE.SphereGeometry(a, corners(a), corners(a) / 2).rotateX(Math.PI / 2);
    case "ellipsoid": {
      const fine = corners(Math.max(a, b, c));
      return new THREE.SphereGeometry(1, fine, fine / 2).rotateX(Math.PI / 2).scale(a, b, c);
    }
    case "capsule": return new THREE.CapsuleGeometry(a, 2 * b, corners(a) / 4, corners(a)).rotateX(Math.PI / 2);
    case "cylinder": return new THREE.CylinderGeometry(a, a, 2 * b, corners(a)).rotateX(Math.PI / 2);
    default: {
      const given = motion.meshes[mesh], geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(floats(given.points), 3));
      geometry.setAttribute("normal", new THREE.BufferAttribute(floats(given.normals), 3));
      geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytes(given.faces)), 1));
      return geometry;
    }
  }
};

const pictures = motion.pictures.map((source) => {
  const texture = new THREE.Texture(new Image());
  Object.assign(texture, { wrapS: THREE.RepeatWrapping, wrapT: THREE.RepeatWrapping, colorSpace: THREE.SRGBColorSpace,
    anisotropy: renderer.capabilities.getMaxAnisotropy() });
  texture.image.onload = () => { texture.needsUpdate = true; draw(); };
  texture.image.src = source;
  return texture;
});
const looks = new Map();
const look = (piece) => {
  const key = JSON.stringify([piece.colour, piece.gloss, piece.picture]);
  if (!looks.has(key)) {
    const [r, g, b, alpha] = piece.colour;
    looks.set(key, new THREE.MeshStandardMaterial({
      color: new THREE.Color().setRGB(r, g, b, THREE.SRGBColorSpace), roughness: Math.max(0.3, 1 - 0.75 * piece.gloss),
      transparent: alpha < 1, opacity: alpha, map: pictures[piece.picture] ?? null,
      side: piece.kind === "hfield" ? THREE.DoubleSide : THREE.FrontSide,
    }));
  }
  return looks.get(key);
};

const put = (mesh, piece) => {
  mesh.position.fromArray(piece.position);
  mesh.quaternion.fromArray(piece.rotation);
  return mesh;
};
const cast = (side, pieces, ghost) => {
  const groups = Array.from({ length: bodies.length }, (_, i) => Object.assign(new THREE.Group(), { name: bodies[i] }));
  const veil = ghost && [
    new THREE.MeshBasicMaterial({ colorWrite: false }),
    new THREE.MeshStandardMaterial({ color: 0xd9603b, transparent: true, opacity: 0.42, depthWrite: false, roughness: 0.9 }),
  ];
  for (const piece of pieces) {
    if (!ghost) {
      const mesh = put(new THREE.Mesh(shape(piece), look(piece)), piece);
      mesh.castShadow = piece.kind !== "plane" && piece.colour[3] === 1;
      mesh.receiveShadow = true;
      groups[piece.body].add(mesh);
      continue;
    }
    // First where the ghost is nearest, then its colour there only: its inner parts do not shine through
    veil.forEach((paint, order) => {
      const mesh = put(new THREE.Mesh(shape(piece), paint), piece);
      mesh.renderOrder = 1 + order;
      groups[piece.body].add(mesh);
    });
    veil[0].transparent = true;
  }
  const figure = new THREE.Group();
  figure.add(...groups);
  scene.add(figure);
  return { figure, groups, side };
};
const moving = motion.pieces.filter((piece) => !piece.still);
cast("after", motion.pieces.filter((piece) => piece.still), false).groups.forEach((group, body) => pose(group, tracks.after, body, 0));
const solid = cast("after", moving, false);
const ghost = tracks.before && cast("before", moving, true);

function pose(group, side, body, at) {
  const first = Math.min(Math.floor(at), count - 1), second = Math.min(first + 1, count - 1), share = at - first;
  const a = first * bodies.length + body, b = second * bodies.length + body, p = side.position;
  group.position.set(...[0, 1, 2].map((k) => p[3 * a + k] + share * (p[3 * b + k] - p[3 * a + k])));
  group.quaternion.fromArray(side.rotation, 4 * a).slerp(turn.fromArray(side.rotation, 4 * b), share);
}

// The middle of what moves, smoothed over half a second, for a camera that goes along
const parts = [...new Set(moving.map((piece) => piece.body))];
const middle = (() => {
  const raw = Array.from({ length: count }, (_, i) => [0, 1, 2].map((k) =>
    parts.reduce((sum, body) => sum + tracks.after.position[3 * (i * bodies.length + body) + k], 0) / (parts.length || 1)));
  const wide = Math.max(1, Math.round(0.25 * fps));
  return raw.map((_, i) => [0, 1, 2].map((k) => {
    let sum = 0, weight = 0;
    for (let j = Math.max(0, i - 2 * wide); j <= Math.min(count - 1, i + 2 * wide); j++) {
      const w = Math.exp(-0.5 * ((j - i) / wide) ** 2);
      sum += w * raw[j][k];
      weight += w;
    }
    return sum / weight;
  }));
})();
const middleAt = (at) => {
  const first = Math.min(Math.floor(at), count - 1), second = Math.min(first + 1, count - 1);
  return new THREE.Vector3(...middle[first]).lerp(new THREE.Vector3(...middle[second]), at - first);
};

// The camera
const camera = new THREE.PerspectiveCamera(32, 1, 0.05, 600 + 40 * extent);
camera.up.set(0, 0, 1);
const controls = new THREE.OrbitControls(camera, $("view"));
Object.assign(controls, { enableDamping: true, dampingFactor: 0.12, minDistance: 0.3, maxDistance: 60 + 4 * extent,
  maxPolarAngle: 0.96 * Math.PI, zoomToCursor: false });
const VIEWS = { quarter: [0.62, -1, 0.32], side: [0, -1, 0.08], left: [0, 1, 0.08], front: [1, 0, 0.08], back: [-1, 0, 0.08],
  top: [-0.001, 0, 1] };
let centre = new THREE.Vector3();
const aim = (name) => {
  $("camera").value = name;
  centre = middleAt(now * fps);
  controls.target.copy(centre);
  const away = 2.9 * Math.max(1, motion.size) / Math.min(1, camera.aspect * 0.9);
  camera.position.copy(centre).addScaledVector(new THREE.Vector3(...VIEWS[name]).normalize(), away);
  controls.update();
  wanted = true;
};
controls.addEventListener("start", () => { $("camera").value = "free"; });
controls.addEventListener("change", () => { wanted = true; });

// Time
let now = 0, playing = true, then = null, wanted = true, which = "after", drawn = "";
const PLAY = "M7 4.500v15l12.500-7.500z", PAUSE = "M6 4.500h4.200v15H6zM13.800 4.500H18v15h-4.200z";
const setPlaying = (yes) => {
  if (yes && now >= duration) now = 0;
  playing = yes && duration > 0;
  $("icon").setAttribute("d", playing ? PAUSE : PLAY);
  then = null;
};
const seek = (time) => { now = Math.min(Math.max(time, 0), duration); wanted = true; };
const step = (by) => { setPlaying(false); seek((Math.round(now * fps) + by) / fps); };
const toKey = (way) => {
  setPlaying(false);
  const times = motion.keys.map((key) => key.time), near = 1e-4;
  seek((way > 0 ? times.find((t) => t > now + near) : times.findLast((t) => t < now - near)) ?? (way > 0 ? duration : 0));
};
const setWhich = (name) => {
  which = tracks.before ? name : "after";
  for (const input of document.querySelectorAll("[name=which]")) input.checked = input.value === which;
  wanted = true;
};

function draw() { wanted = true; }
const render = () => {
  const at = now * fps;
  const side = which === "before" ? tracks.before : tracks.after;
  solid.groups.forEach((group, body) => pose(group, side, body, at));
  if (ghost) {
    ghost.figure.visible = which === "both";
    if (which === "both") ghost.groups.forEach((group, body) => pose(group, tracks.before, body, at));
  }
  const here = middleAt(at);
  if ($("follow").checked) {
    const moved = here.clone().sub(centre);
    camera.position.add(moved);
    controls.target.add(moved);
  }
  centre = here;
  sun.target.position.copy(here);
  sun.position.copy(here).add(new THREE.Vector3(2.6, -3.2, 5.2));
  renderer.render(scene, camera);
  drawn = `${now} ${which}`;
  $("scrub").value = duration ? now / duration : 0;
  $("scrub").style.setProperty("--done", `${duration ? 100 * now / duration : 0}%`);
  $("clock").innerHTML = `<b>${now.toFixed(2)}</b> / ${duration.toFixed(2)} s &ensp;image ${Math.round(at)}`;
};
const tick = (stamp) => {
  requestAnimationFrame(tick);
  if (playing) {
    if (then !== null) {
      now += Math.min(0.25, (stamp - then) / 1000) * Number($("speed").value);
      if (now > duration && $("loop").checked) now %= duration;
      else if (now >= duration) { now = duration; setPlaying(false); }
    }
    then = playing ? stamp : null;
    wanted = true;
  }
  controls.update();
  if (wanted) { wanted = false; render(); }
};
const resize = () => {
  renderer.setSize(window.innerWidth, window.innerHeight, false);
  camera.aspect = window.innerWidth / window.innerHeight;
  camera.setViewOffset(window.innerWidth, window.innerHeight, 0, 0.45 * $("bar").offsetHeight, window.innerWidth, window.innerHeight);
  camera.updateProjectionMatrix();
  wanted = true;
};

// The bar
$("about").textContent = `${duration.toFixed(2)} s, ${count} samples at ${+fps.toFixed(3)} a second, ${motion.keys.length} keyframes`;
$("which").hidden = !tracks.before;
$("marks").classList.toggle("crowded", motion.keys.length > 60);
for (const key of motion.keys) {
  const mark = document.createElement("button");
  mark.style.left = `${duration ? 100 * key.time / duration : 0}%`;
  mark.className = key.partial ? "partial" : "";
  mark.title = `${key.partial ? "partial keyframe" : "keyframe"} at ${key.time.toFixed(3)} s`;
  mark.tabIndex = -1;
  mark.addEventListener("click", () => { setPlaying(false); seek(key.time); });
  $("marks").append(mark);
}
$("play").addEventListener("click", () => setPlaying(!playing));
$("previous").addEventListener("click", () => toKey(-1));
$("next").addEventListener("click", () => toKey(1));
$("scrub").addEventListener("input", () => { setPlaying(false); seek(Number($("scrub").value) * duration); });
$("camera").addEventListener("change", () => aim($("camera").value));
$("follow").addEventListener("change", draw);
for (const input of document.querySelectorAll("[name=which]")) input.addEventListener("change", () => setWhich(input.value));
window.addEventListener("resize", resize);
$("view").addEventListener("webglcontextrestored", draw);
window.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === "SELECT") return;
  const speed = $("speed");
  const faster = (by) => { speed.selectedIndex = Math.min(Math.max(speed.selectedIndex + by, 0), speed.length - 1); };
  const deeds = { " ": () => setPlaying(!playing), ArrowLeft: () => step(-1), ArrowRight: () => step(1),
    PageUp: () => toKey(-1), PageDown: () => toKey(1), Home: () => seek(0), End: () => seek(duration),
    f: () => $("follow").click(), l: () => $("loop").click(), "+": () => faster(1), "-": () => faster(-1),
    1: () => setWhich("before"), 2: () => setWhich("both"), 3: () => setWhich("after") };
  if (!(event.key in deeds)) return;
  event.preventDefault();
  deeds[event.key]();
});

// For pages that embed this one, and for tests
window.player = {
  seek: (time) => { setPlaying(false); seek(time); }, show: setWhich, aim, play: setPlaying,
  get time() { return now; }, get playing() { return playing; }, get which() { return which; },
  get settled() { return !wanted && drawn === `${now} ${which}`; },
  place: (name) => solid.groups[bodies.indexOf(name)].getWorldPosition(new THREE.Vector3()).toArray(),
};
resize();
aim("quarter");
setPlaying(true);
requestAnimationFrame(tick);
})();
