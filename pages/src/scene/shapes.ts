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

export const bytes = (text: string): ArrayBuffer => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
export const floats = (text: string): Float32Array => new Float32Array(bytes(text));

/** How finely round things are drawn: how far [m] a surface may lie off its place, and corners of a circle. */
export interface Fineness { sag: number; least: number; most: number; }
export const FINE: Fineness = { sag: 0.0006, least: 10, most: 40 };
export const COARSE: Fineness = { sag: 0.004, least: 6, most: 12 };

/** Pieces of one body that look alike, in one geometry with the body's axes. */
export interface Part { body: number; geometry: THREE.BufferGeometry; material: THREE.Material; casts: boolean; }

/** Makes meshes of pieces. Lengths are metres, z is up. */
export class Shapes {
  private readonly known = new Map<string, THREE.BufferGeometry>();
  private readonly looks = new Map<string, THREE.MeshStandardMaterial>();
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
    if (single) return { body: first.body, geometry: this.moved(first, true), material: this.look(first), casts };
    const geometry = mergeGeometries(pieces.map((piece) => this.moved(piece, false)))!;
    const roughness = Math.max(0.3, 1 - 0.75 * (pieces.reduce((sum, piece) => sum + piece.gloss, 0) / pieces.length));
    const key = `joined|${roughness.toFixed(1)}`;
    let material = this.looks.get(key);
    if (!material) this.looks.set(key, (material = new THREE.MeshStandardMaterial({ vertexColors: true, roughness })));
    return { body: first.body, geometry, material, casts };
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
    const parts = [...this.joined.values()].flat().map((part) => part.geometry);
    for (const each of [...this.known.values(), ...this.looks.values(), ...this.pictures, ...parts]) each.dispose();
  }

  private shape(piece: Piece): THREE.BufferGeometry {
    const key = [piece.kind, piece.size, piece.mesh ?? "", piece.repeat ?? ""].join("|");
    let found = this.known.get(key);
    if (!found) this.known.set(key, (found = this.made(piece)));
    return found;
  }

  private look(piece: Piece): THREE.MeshStandardMaterial {
    const key = JSON.stringify([piece.colour, piece.gloss, piece.picture]);
    let found = this.looks.get(key);
    if (!found) {
      const [r, g, b, alpha] = piece.colour;
      found = new THREE.MeshStandardMaterial({
        color: new THREE.Color().setRGB(r, g, b, THREE.SRGBColorSpace),
        roughness: Math.max(0.3, 1 - 0.75 * piece.gloss),
        transparent: alpha < 1,
        opacity: alpha,
        map: piece.picture === undefined ? null : this.pictures[piece.picture],
        side: piece.kind === "hfield" ? THREE.DoubleSide : THREE.FrontSide,
      });
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
        geometry.setAttribute("position", new THREE.BufferAttribute(floats(given.points), 3));
        geometry.setAttribute("normal", new THREE.BufferAttribute(floats(given.normals), 3));
        geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytes(given.faces)), 1));
        return geometry;
      }
    }
  }
}
