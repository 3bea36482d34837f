// Geoms of a model as three.js draws them: geometries shared by what is alike, materials by how it looks.
import * as THREE from "three";

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

const SAG = 0.0006; // [m] that a round surface may lie off its true place
const corners = (radius: number): number =>
  Math.min(40, Math.max(10, 4 * Math.ceil(Math.PI / Math.sqrt((2 * SAG) / radius) / 4)));

/** Makes meshes of pieces. Lengths are metres, z is up. */
export class Shapes {
  private readonly known = new Map<string, THREE.BufferGeometry>();
  private readonly looks = new Map<string, THREE.MeshStandardMaterial>();
  private readonly pictures: THREE.Texture[];

  constructor(private readonly drawn: Drawn, anisotropy: number, loaded: () => void) {
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

  /** A piece where it is in its body, in its own material or another. */
  mesh(piece: Piece, material?: THREE.Material): THREE.Mesh {
    const mesh = new THREE.Mesh(this.shape(piece), material ?? this.look(piece));
    mesh.position.fromArray(piece.position);
    mesh.quaternion.fromArray(piece.rotation);
    mesh.name = piece.name;
    return mesh;
  }

  dispose(): void {
    for (const each of [...this.known.values(), ...this.looks.values(), ...this.pictures]) each.dispose();
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
      case "capsule": return new THREE.CapsuleGeometry(a, 2 * b, corners(a) / 4, corners(a)).rotateX(quarter);
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
