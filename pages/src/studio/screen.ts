// What a processor draws: fewer points while something moves, more than the screen has when all is still.
// The canvas keeps its size, for to change it waits until all that was drawn is done.
import * as THREE from "three";

export class Screen {
  private readonly target = new THREE.WebGLRenderTarget(1, 1, { stencilBuffer: true, colorSpace: THREE.SRGBColorSpace });

  constructor(private readonly renderer: THREE.WebGLRenderer) {
    Object.assign(this.target, { isXRRenderTarget: true }); // so that colours are as on the canvas
    this.target.texture.internalFormat = "RGBA8";
  }

  /** Draws a scene with so many points along a side of each of the canvas's. */
  show(scale: number, drawn: (width: number, height: number) => void): void {
    const { renderer, target } = this, { width, height } = renderer.domElement;
    const wide = Math.max(1, Math.round(scale * width)), high = Math.max(1, Math.round(scale * height));
    if (target.width !== wide || target.height !== high) target.setSize(wide, high);
    renderer.setRenderTarget(target);
    drawn(wide, high);
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const buffer = (renderer.properties.get(target) as { __webglFramebuffer: WebGLFramebuffer }).__webglFramebuffer;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, buffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.disable(gl.SCISSOR_TEST);
    gl.blitFramebuffer(0, 0, wide, high, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.LINEAR);
    renderer.setRenderTarget(null);
  }

  /** The part of it that is drawn on from now on, from so many points on. */
  part(left: number, width: number, height: number): void {
    this.target.viewport.set(left, 0, width, height);
    this.target.scissor.set(left, 0, width, height);
    this.target.scissorTest = true;
    this.renderer.setRenderTarget(this.target);
  }

  whole(): void {
    this.target.viewport.set(0, 0, this.target.width, this.target.height);
    this.target.scissor.set(0, 0, this.target.width, this.target.height);
    this.target.scissorTest = false;
  }
}
