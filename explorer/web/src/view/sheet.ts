// A flat sheet of samples, coloured: a layer of a grid, or a plane.
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  FloatType,
  GLSL3,
  Mesh,
  RGFormat,
  ShaderMaterial,
  Vector2,
  Vector3,
} from 'three';
import { Drawn } from '../field';
import { scaleShader } from '../maps';
import type { Box } from '../server';
import { blindShader, scaleUniforms } from './uniforms';

const vertexShader = /* glsl */ `
out vec2 at;
out vec3 place;
void main() {
  at = uv;
  place = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;

/** Values blend between the samples that have one; what lies nearest to a sample that has
 * none is hatched: blind is never drawn as good. */
const fragmentShader = /* glsl */ `
precision highp float;
precision highp sampler2D;
uniform sampler2D samples;  // value, Drawn
uniform vec2 counts;
uniform bool blend, raised;
uniform vec3 low, high;  // of what it is shown within, metres
in vec2 at;
in vec3 place;
out vec4 colour;
${scaleShader}
${blindShader}
void main() {
  if (any(lessThan(place, low)) || any(greaterThan(place, high))) discard;
  vec2 s = clamp(at, 0.0, 1.0) * (counts - 1.0);
  ivec2 last = ivec2(counts) - 1;
  vec2 nearest = texelFetch(samples, min(ivec2(s + 0.5), last), 0).xy;
  if (nearest.y < 0.5 || nearest.y > 1.5) {
    colour = vec4(withoutValue(nearest.y), 1.0);
    return;
  }
  if (raised) discard;  // it stands above
  float value = nearest.x;
  if (blend) {
    ivec2 low = ivec2(s);
    vec2 part = s - vec2(low);
    float sum = 0.0, weights = 0.0;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        vec2 corner = texelFetch(samples, min(low + ivec2(i, j), last), 0).xy;
        float w = (i == 1 ? part.x : 1.0 - part.x) * (j == 1 ? part.y : 1.0 - part.y);
        if (corner.y > 0.5 && corner.y < 1.5) {
          sum += w * corner.x;
          weights += w;
        }
      }
    value = sum / weights;
  }
  colour = vec4(colourOf(value), 1.0);
  // Where there is no difference runs a line.
  float slope = fwidth(value);
  if (difference && slope > 0.0 && abs(value) < slope) colour.rgb *= 0.25;
}
`;

/** Samples of a sheet, the first direction fastest. */
export interface SheetData {
  origin: Vector3;
  u: Vector3;
  v: Vector3;
  counts: [number, number];
  /** Index among the field's samples of each. */
  index: (i: number, j: number) => number;
}

export class Sheet {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  data: SheetData | null = null;

  constructor() {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      side: DoubleSide,
      uniforms: {
        ...scaleUniforms(),
        samples: { value: null },
        counts: { value: new Vector2(1, 1) },
        blend: { value: true },
        raised: { value: false },
        low: { value: new Vector3() },
        high: { value: new Vector3() },
      },
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.mesh = new Mesh(new BufferGeometry(), material);
  }

  /** @param within what of it is shown; null: all
   *  @param raised what has values stands above it, and isn't drawn on it */
  show(data: SheetData, values: Float32Array, mask: Uint8Array, blend: boolean, within: Box | null, raised: boolean): void {
    this.data = data;
    const { low, high } = this.mesh.material.uniforms;
    const all = 1e30;
    low!.value.set(...(within?.min ?? [-all, -all, -all])).addScalar(-1e-6);
    high!.value.set(...(within?.max ?? [all, all, all])).addScalar(1e-6);
    const [nu, nv] = data.counts;
    const texels = new Float32Array(2 * nu * nv);
    for (let j = 0, k = 0; j < nv; ++j)
      for (let i = 0; i < nu; ++i) {
        const sample = data.index(i, j);
        const drawn = mask[sample]!;
        texels[k++] = drawn === Drawn.value ? values[sample]! : 0;
        texels[k++] = drawn;
      }
    const texture = new DataTexture(texels, nu, nv, RGFormat, FloatType);
    texture.needsUpdate = true;
    const { uniforms } = this.mesh.material;
    uniforms.samples!.value?.dispose();
    uniforms.samples!.value = texture;
    uniforms.counts!.value.set(nu, nv);
    uniforms.blend!.value = blend;
    uniforms.raised!.value = raised;
    this.place(data);
  }

  /** The sample nearest to a point of the sheet. @param uv of the hit */
  nearest(uv: Vector2): number {
    const [nu, nv] = this.data!.counts;
    return this.data!.index(
      Math.round(Math.min(1, Math.max(0, uv.x)) * (nu - 1)),
      Math.round(Math.min(1, Math.max(0, uv.y)) * (nv - 1)),
    );
  }

  private place({ origin, u, v }: SheetData): void {
    const corners = [
      origin,
      origin.clone().add(u),
      origin.clone().add(u).add(v),
      origin.clone().add(v),
    ];
    const geometry = new BufferGeometry().setFromPoints(corners);
    geometry.setAttribute('uv', new BufferAttribute(new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }
}
