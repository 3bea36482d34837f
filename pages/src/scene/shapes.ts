// Geoms of a model as three.js draws them: geometries shared by what is alike, materials by how it looks.
import * as THREE from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";

export interface Piece {
  name: string;
  body: number;
  kind: string;
  size: number[];
  position: number[];
  rotation: number[];
  colour: number[];
  gloss: number;
  still: boolean;
  mesh?: number;
  picture?: number;
  repeat?: number[];
}

export interface Drawn {
  pieces: Piece[];
  meshes: { points: string; normals: string; faces: string }[];
  pictures: string[];
}

const bytes = (text: string): ArrayBuffer => {
  const binary = atob(text), out = new Uint8Array(binary.length);
  for (let i = 0; i < out.length; i++) out[i] = binary.charCodeAt(i); // Uint8Array.from takes seconds for large meshes
  return out.buffer;
};
export const floats = (text: string): Float32Array => new Float32Array(bytes(text));

/** Tessellation of curved surfaces: maximum deviation [m] of the surface, and corners of a circle. */
export interface Fineness { sag: number; least: number; most: number; faces: number; plain: boolean; }
export const FINE: Fineness = { sag: 0.0006, least: 10, most: 40, faces: 40_000, plain: false };
export const COARSE: Fineness = { sag: 0.004, least: 6, most: 12, faces: 1000, plain: true };

/** A mesh of fewer triangles, about so many: corners that lie in one cell of a grid become one (Rossignac, Borrel 1993),
 * if they have the same colour. */
export const clustered = (points: Float32Array, faces: Uint32Array, most: number, colours?: ArrayLike<number>): THREE.BufferGeometry => {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  points.forEach((value, i) => { low[i % 3] = Math.min(low[i % 3], value); high[i % 3] = Math.max(high[i % 3], value); });
  const sides = high.map((value, k) => Math.max(value - low[k], 1e-6));
  const [x, y, z] = sides, cell = Math.sqrt((2 * (x * y + y * z + z * x) * 2) / most); // two triangles a cell of its hull
  const found = new Map<number, number>(), sums: number[] = [], counts: number[] = [], painted: number[] = [];
  const shades = new Map<number, number>();
  const shade = (i: number): number => { // of its colour, a number of its own
    if (!colours) return 0;
    const mixed = (Math.round(1000 * colours[i]) * 1024 + Math.round(1000 * colours[i + 1])) * 1024 + Math.round(1000 * colours[i + 2]);
    let number = shades.get(mixed);
    if (number === undefined) shades.set(mixed, (number = shades.size));
    return number;
  };
  const along = sides.map((side) => Math.floor(side / cell) + 1), of = new Uint32Array(points.length / 3);
  for (let n = 0, i = 0; i < points.length; n++, i += 3) {
    const u = Math.floor((points[i] - low[0]) / cell), v = Math.floor((points[i + 1] - low[1]) / cell);
    const w = Math.floor((points[i + 2] - low[2]) / cell), key = ((shade(i) * along[2] + w) * along[1] + v) * along[0] + u;
    let at = found.get(key);
    if (at === undefined) {
      at = found.size;
      found.set(key, at);
      sums.push(0, 0, 0);
      counts.push(0);
      if (colours) painted.push(colours[i], colours[i + 1], colours[i + 2]);
    }
    for (let k = 0; k < 3; k++) sums[3 * at + k] += points[i + k];
    counts[at] += 1;
    of[n] = at;
  }
  const kept: number[] = [];
  for (let i = 0; i < faces.length; i += 3) {
    const [a, b, c] = [of[faces[i]], of[faces[i + 1]], of[faces[i + 2]]];
    if (a !== b && b !== c && c !== a) kept.push(a, b, c);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(Float32Array.from(sums, (sum, i) => sum / counts[Math.floor(i / 3)]), 3));
  if (colours) geometry.setAttribute("color", new THREE.BufferAttribute(Float32Array.from(painted), 3));
  geometry.setIndex(kept);
  geometry.computeVertexNormals();
  return geometry;
};

/** Pieces of one body that look alike, in one geometry with the body's axes. */
export interface Part {
  body: number; geometry: THREE.BufferGeometry; material: THREE.Material; casts: boolean;
  joined: boolean; // with its colours at its points
  plain?: THREE.MeshBasicMaterial; // a plane's, in whatever light there is
}

/** Makes meshes of pieces. Lengths are metres, z is up. */
export class Shapes {
  private readonly known = new Map<string, THREE.BufferGeometry>();
  private readonly looks = new Map<string, THREE.Material>();
  private readonly pictures: THREE.Texture[];
  private readonly joined = new Map<string, Part[]>();

  constructor(private readonly drawn: Drawn, anisotropy: number, loaded: () => void, private readonly fineness = FINE) {
    this.pictures = drawn.pictures.map((source) => {
      const texture = new THREE.Texture(new Image());
      Object.assign(texture, {
        wrapS: THREE.RepeatWrapping, wrapT: THREE.RepeatWrapping, colorSpace: THREE.SRGBColorSpace, anisotropy,
      });
      const image = texture.image as HTMLImageElement;
      image.onload = () => { texture.needsUpdate = true; loaded(); };
      image.src = source;
      return texture;
    });
  }

  /** Pieces as few meshes: all of a body that are as glossy, but for those that are seen through or have a picture. */
  parts(pieces: Piece[]): Part[] {
    const sorted = new Map<string, Piece[]>();
    for (const piece of pieces) {
      const alone = piece.colour[3] < 1 || piece.picture !== undefined || piece.kind === "hfield" || piece.kind === "plane";
      const key = `${piece.body}|${alone ? piece.name : Math.round(2 * piece.gloss)}`;
      sorted.set(key, [...(sorted.get(key) ?? []), piece]);
    }
    const whole = [...sorted.values()].map((some) => some.map((piece) => piece.name).join()).join("|");
    let found = this.joined.get(whole);
    if (!found) this.joined.set(whole, (found = [...sorted.values()].map((some) => this.part(some))));
    return found;
  }

  private part(pieces: Piece[]): Part {
    const first = pieces[0], casts = first.kind !== "plane" && first.colour[3] === 1;
    const single = first.colour[3] < 1 || first.picture !== undefined || first.kind === "hfield" || first.kind === "plane";
    if (single) {
      const material = this.look(first), geometry = this.moved(first, true);
      const map = (material as THREE.MeshLambertMaterial).map;
      const plain = first.kind === "plane" && first.colour[3] === 1 ? new THREE.MeshBasicMaterial({ map: map && this.cheaper(map) }) : undefined;
      if (plain) plain.userData.own = (material as THREE.MeshLambertMaterial).color;
      return { body: first.body, geometry, material, casts, joined: false, plain };
    }
    const geometry = mergeGeometries(pieces.map((piece) => this.moved(piece, false)))!;
    const roughness = Math.max(0.3, 1 - 0.75 * (pieces.reduce((sum, piece) => sum + piece.gloss, 0) / pieces.length));
    const key = `joined|${roughness.toFixed(1)}`;
    let material = this.looks.get(key);
    if (!material) this.looks.set(key, (material = this.painted({ vertexColors: true }, roughness)));
    return { body: first.body, geometry, material, casts, joined: true };
  }

  /** A picture of which a point is found in one of its sizes, where two are half of what a floor costs a processor. */
  private cheaper(map: THREE.Texture): THREE.Texture {
    const image = map.image as HTMLImageElement, found = map.clone();
    found.minFilter = THREE.LinearMipmapNearestFilter;
    if (image.complete) found.needsUpdate = true;
    else image.addEventListener("load", () => { found.needsUpdate = true; });
    this.pictures.push(found);
    return found;
  }

  /** A piece's geometry in its body's axes: with its picture's places, or its colour at every point. */
  private moved(piece: Piece, pictured: boolean): THREE.BufferGeometry {
    const geometry = this.shape(piece).clone();
    const turn = new THREE.Quaternion().fromArray(piece.rotation);
    geometry.applyMatrix4(new THREE.Matrix4().compose(new THREE.Vector3().fromArray(piece.position), turn, new THREE.Vector3(1, 1, 1)));
    if (pictured) return geometry;
    geometry.deleteAttribute("uv");
    const colour = new THREE.Color().setRGB(piece.colour[0], piece.colour[1], piece.colour[2], THREE.SRGBColorSpace);
    const colours = new Float32Array(3 * geometry.attributes.position.count);
    for (let i = 0; i < colours.length; i += 3) colour.toArray(colours, i);
    geometry.setAttribute("color", new THREE.BufferAttribute(colours, 3));
    return geometry;
  }

  dispose(): void {
    const parts = [...this.joined.values()].flat().flatMap(({ geometry, plain }) => (plain ? [geometry, plain] : [geometry]));
    for (const each of [...this.known.values(), ...this.looks.values(), ...this.pictures, ...parts]) each.dispose();
  }

  private shape(piece: Piece): THREE.BufferGeometry {
    const key = [piece.kind, piece.size, piece.mesh ?? "", piece.repeat ?? ""].join("|");
    let found = this.known.get(key);
    if (!found) this.known.set(key, (found = this.made(piece)));
    return found;
  }

  /** A material that shines, or one that costs less. */
  private painted(parameters: THREE.MeshLambertMaterialParameters, roughness: number): THREE.Material {
    return this.fineness.plain ? new THREE.MeshLambertMaterial(parameters) : new THREE.MeshStandardMaterial({ ...parameters, roughness });
  }

  private look(piece: Piece): THREE.Material {
    const key = JSON.stringify([piece.colour, piece.gloss, piece.picture]);
    let found = this.looks.get(key);
    if (!found) {
      const [r, g, b, alpha] = piece.colour;
      found = this.painted({
        color: new THREE.Color().setRGB(r, g, b, THREE.SRGBColorSpace),
        transparent: alpha < 1,
        opacity: alpha,
        map: piece.picture === undefined ? null : this.pictures[piece.picture],
        side: piece.kind === "hfield" ? THREE.DoubleSide : THREE.FrontSide,
      }, Math.max(0.3, 1 - 0.75 * piece.gloss));
      this.looks.set(key, found);
    }
    return found;
  }

  private made({ kind, size, mesh, repeat }: Piece): THREE.BufferGeometry {
    const [a, b, c] = size;
    const corners = (radius: number): number => {
      const { sag, least, most } = this.fineness;
      return Math.min(most, Math.max(least, 2 * Math.ceil(Math.PI / Math.sqrt((2 * sag) / radius) / 2)));
    };
    const quarter = Math.PI / 2;
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
      case "sphere": return new THREE.SphereGeometry(a, corners(a), corners(a) / 2).rotateX(quarter);
      case "ellipsoid": {
        const fine = corners(Math.max(a, b, c));
        return new THREE.SphereGeometry(1, fine, fine / 2).rotateX(quarter).scale(a, b, c);
      }
      case "capsule": return new THREE.CapsuleGeometry(a, 2 * b, Math.max(2, Math.floor(corners(a) / 5)), corners(a)).rotateX(quarter);
      case "cylinder": return new THREE.CylinderGeometry(a, a, 2 * b, corners(a)).rotateX(quarter);
      default: {
        const given = this.drawn.meshes[mesh ?? 0], geometry = new THREE.BufferGeometry();
        const points = floats(given.points), faces = new Uint32Array(bytes(given.faces));
        if (kind === "mesh" && faces.length > 3 * this.fineness.faces) return clustered(points, faces, this.fineness.faces);
        geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
        geometry.setAttribute("normal", new THREE.BufferAttribute(floats(given.normals), 3));
        geometry.setIndex(new THREE.BufferAttribute(faces, 1));
        return geometry;
      }
    }
  }
}
