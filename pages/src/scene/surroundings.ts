// What surrounds a figure: sky, haze, sun with its shadow, light from above and from the side.
import * as THREE from "three";

export interface Mood { haze: [number, number, number]; zenith: [number, number, number]; ground: number; sky: number; bright: number; }

export const DAY: Mood = { haze: [0.9, 0.915, 0.93], zenith: [0.6, 0.69, 0.78], ground: 0xb9ab9a, sky: 0xf4f8ff, bright: 1 };
export const DUSK: Mood = { haze: [0.17, 0.185, 0.21], zenith: [0.07, 0.08, 0.1], ground: 0x8d8478, sky: 0xdfe8f5, bright: 0.78 };

export interface Drawing { canvas: HTMLCanvasElement; renderer: THREE.WebGLRenderer; software: boolean; }

/** The renderer on a canvas, and whether it runs in software, which limits detail; throws without
 * WebGL 2. The canvas may be another one in its place: smooth edges are for those who do not draw by the processor. */
export const drawingOn = (given: HTMLCanvasElement): Drawing => {
  const wishes = { alpha: false, antialias: false, stencil: false, powerPreference: "high-performance" } as const;
  const about = (gl: WebGL2RenderingContext): boolean => {
    const known = gl.getExtension("WEBGL_debug_renderer_info");
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(gl.getParameter(known ? known.UNMASKED_RENDERER_WEBGL : gl.RENDERER)));
  };
  let canvas = given, context = given.getContext("webgl2", wishes) as WebGL2RenderingContext | null;
  if (!context) throw new Error("no WebGL 2");
  const software = about(context);
  if (!software) {
    canvas = given.cloneNode() as HTMLCanvasElement;
    given.replaceWith(canvas);
    context.getExtension("WEBGL_lose_context")?.loseContext();
    context = canvas.getContext("webgl2", { ...wishes, antialias: true }) as WebGL2RenderingContext;
  }
  const renderer = new THREE.WebGLRenderer({ canvas, context });
  renderer.debug.checkShaderErrors = false; // they are known to be right, and to ask waits for each of them
  if (!software) renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2)); // one to begin with
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = software ? THREE.BasicShadowMap : THREE.PCFShadowMap;
  renderer.toneMapping = THREE.NeutralToneMapping;
  return { canvas, renderer, software };
};

const SUN = new THREE.Vector3(2.6, -3.2, 5.2); // [m] relative to the camera's target
const FILL = new THREE.Vector3(-2, 3, 2.5);

export class Surroundings {
  readonly scene = new THREE.Scene();
  private readonly sun = new THREE.DirectionalLight(0xfff4e2, 2.3);
  private readonly sky = new THREE.HemisphereLight(0xf4f8ff, 0xb9ab9a, 1.9);
  private readonly fill = new THREE.DirectionalLight(0xdfe9ff, 0.5);
  private readonly dome: THREE.SphereGeometry;

  /** extent [m]: how far the motion goes */
  constructor(extent: number, mood: Mood = DAY, software = false) {
    this.dome = new THREE.SphereGeometry(150 + 20 * extent, 32, 24).rotateX(Math.PI / 2);
    this.dome.setAttribute("color", new THREE.BufferAttribute(new Float32Array(this.dome.attributes.position.count * 3), 3));
    const paint = { vertexColors: true, side: THREE.BackSide, fog: false, toneMapped: false };
    const sky = new THREE.Mesh(this.dome, new THREE.MeshBasicMaterial(paint));
    sky.renderOrder = 1; // after everything that hides it
    this.scene.add(sky);
    this.scene.fog = new THREE.Fog(0, 4 + 2 * extent, 22 + 6 * extent);
    const { sun } = this;
    sun.castShadow = true;
    sun.shadow.mapSize.setScalar(software ? 1024 : 2048);
    Object.assign(sun.shadow, { bias: -0.0004, normalBias: 0.012, radius: 2.5 });
    Object.assign(sun.shadow.camera, { left: -2.6, right: 2.6, top: 2.6, bottom: -2.6, near: 0.5, far: 16 });
    this.fill.position.copy(FILL);
    this.scene.add(this.sky, sun, sun.target, this.fill);
    this.light(mood);
  }

  light(mood: Mood): void {
    const haze = new THREE.Color().setRGB(...mood.haze, THREE.SRGBColorSpace);
    const zenith = new THREE.Color().setRGB(...mood.zenith, THREE.SRGBColorSpace);
    this.scene.background = haze;
    (this.scene.fog as THREE.Fog).color.copy(haze);
    this.sun.intensity = 2.3 * (0.4 + 0.6 * mood.bright);
    this.sky.intensity = 1.9 * mood.bright;
    this.sky.color.set(mood.sky);
    this.sky.groundColor.set(mood.ground);
    const place = this.dome.attributes.position, colours = this.dome.attributes.color, colour = new THREE.Color();
    for (let i = 0; i < place.count; i++) {
      const up = Math.max(0, place.getZ(i)) / this.dome.parameters.radius;
      colour.copy(haze).lerp(zenith, Math.min(1, 1.3 * up)).toArray(colours.array, 3 * i);
    }
    colours.needsUpdate = true;
  }

  /** The sun follows the camera's target, so that the shadow stays in view. */
  follow(here: THREE.Vector3): void {
    this.sun.target.position.copy(here);
    this.sun.position.copy(here).add(SUN);
  }

  /** Whether objects in the sun cast a visible shadow. */
  set shadows(yes: boolean) { this.sun.castShadow = yes; }

  /** The light on level ground, by which colours there are multiplied. */
  onGround(): THREE.Color {
    const shining = (lamp: THREE.DirectionalLight, from: THREE.Vector3) => lamp.color.clone().multiplyScalar(lamp.intensity * from.z / from.length());
    const { sky } = this, up = 0.5 + 0.5 * sky.position.clone().normalize().z;
    const light = sky.groundColor.clone().lerp(sky.color, up).multiplyScalar(sky.intensity).add(shining(this.fill, FILL));
    return light.add(shining(this.sun, SUN)).multiplyScalar(1 / Math.PI);
  }
}
