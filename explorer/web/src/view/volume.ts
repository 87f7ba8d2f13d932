// The field throughout its volume, by rays: a cloud.
import {
  BackSide,
  BoxGeometry,
  BufferGeometry,
  Camera,
  Data3DTexture,
  FloatType,
  GLSL3,
  LinearFilter,
  Matrix4,
  Mesh,
  OrthographicCamera,
  RGBAFormat,
  ShaderMaterial,
  Texture,
  Vector2,
  Vector3,
} from 'three';
import { Drawn, type Field, type GridPart } from '../field';
import { scaleShader } from '../maps';
import type { Scale } from '../scale';
import { sightOf } from './eye';
import { applyScale, blindShader, scaleUniforms } from './uniforms';

const vertexShader = /* glsl */ `
out vec3 place;  // in the box, from 0 to 1
void main() {
  place = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;

/** A ray goes from where it enters the box to what is opaque. Values are blended between the
 * samples that have one, by a texture of (value, 1, 0) where there is one, (0, 0, 1) within
 * solids and (0, 0, 0) where it is blind: the first is divided by the second. Where less than
 * half of the weight has a value there is none: such places are grey. */
const fragmentShader = /* glsl */ `
precision highp float;
precision highp sampler2D;
precision highp sampler3D;
uniform sampler3D samples;
uniform sampler2D opaqueDepth;
uniform vec2 picture, corner;    // pixels
uniform vec3 counts, size;
uniform vec3 camera, sight;  // in the box: where it is, which way it looks
uniform bool parallel;       // all rays are
uniform mat4 toBox;
in vec3 place;
out vec4 colour;
${scaleShader}
${blindShader}
uniform int steps;
vec3 eye;  // where the ray begins

/** The value at a place of the box, and how much of the weight has one; less than 0: it is
 * within a solid. */
vec2 look(vec3 at) {
  vec3 s = (clamp(at, 0.0, 1.0) * (counts - 1.0) + 0.5) / counts;
  vec4 sum = texture(samples, s);
  return vec2(sum.x / max(sum.y, 1e-6), sum.z > 0.5 ? -1.0 : sum.y);
}

/** Where along the ray the opaque begins: in units of its direction. */
float opaque(vec3 direction) {
  vec2 at = (gl_FragCoord.xy - corner) / picture;
  float depth = texture(opaqueDepth, gl_FragCoord.xy / vec2(textureSize(opaqueDepth, 0))).x;
  vec4 p = toBox * vec4(2.0 * vec3(at, depth) - 1.0, 1.0);
  return dot(p.xyz / p.w - eye, direction) / dot(direction, direction);
}

void main() {
  vec3 direction = parallel ? normalize(sight) : normalize(place - camera);
  eye = parallel ? place - 2.0 * direction : camera;
  vec3 a = -eye / direction, b = (1.0 - eye) / direction;
  vec3 near = min(a, b), far = max(a, b);
  float begin = max(max(near.x, max(near.y, near.z)), 0.0);
  float end = min(min(far.x, min(far.y, far.z)), opaque(direction));
  if (end <= begin) discard;
  float stride = (end - begin) / float(steps);
  float way = length(direction * stride * size) / length(size);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < steps; ++i) {
    vec2 v = look(eye + (begin + (float(i) + 0.5) * stride) * direction);
    if (v.y < 0.0) continue;
    bool finite = v.y >= 0.5;
    float good = brightIsLarge ? partOf(v.x) : 1.0 - partOf(v.x);
    float density = finite ? 0.6 + 9.0 * pow(good, 3.0) : 1.6;
    float alpha = 1.0 - exp(-density * way);
    sum += (1.0 - sum.a) * alpha * vec4(finite ? colourOf(v.x) : blindA, 1.0);
    if (sum.a > 0.99) break;
  }
  if (sum.a < 0.004) discard;
  colour = vec4(sum.rgb / sum.a, sum.a);
}
`;

function textureOf(field: Field, part: GridPart): Data3DTexture {
  const texels = new Float32Array(4 * part.count);
  for (let i = 0; i < part.count; ++i) {
    const drawn = field.mask[part.first + i]!;
    if (drawn === Drawn.value) texels.set([field.values[part.first + i]!, 1], 4 * i);
    else if (drawn === Drawn.inside) texels[4 * i + 2] = 1;
  }
  const texture = new Data3DTexture(texels, ...part.counts);
  texture.format = RGBAFormat;
  texture.type = FloatType;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** The box from 0 to 1. */
const unit = new BoxGeometry().translate(0.5, 0.5, 0.5);

export class Volume {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly clip = new Matrix4();

  constructor() {
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      side: BackSide,
      transparent: true,
      // What is opaque is asked for; what lies behind a cloud shows.
      depthTest: false,
      depthWrite: false,
      uniforms: {
        ...scaleUniforms(),
        samples: { value: null },
        opaqueDepth: { value: null },
        picture: { value: new Vector2(1, 1) },
        corner: { value: new Vector2() },
        counts: { value: new Vector3() },
        size: { value: new Vector3(1, 1, 1) },
        camera: { value: new Vector3() },
        sight: { value: new Vector3() },
        parallel: { value: false },
        toBox: { value: new Matrix4() },
        steps: { value: 64 },
      },
    });
    this.mesh = new Mesh(unit, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1;
    this.mesh.visible = false;
  }

  hide(): void {
    this.mesh.visible = false;
  }

  show(field: Field, part: GridPart, scale: Scale): void {
    const { uniforms } = this.mesh.material;
    uniforms.samples!.value?.dispose();
    uniforms.samples!.value = textureOf(field, part);
    const size = part.counts.map((n, k) => Math.max(n - 1, 1e-3) * part.step[k]!);
    uniforms.counts!.value.set(...part.counts);
    uniforms.size!.value.set(...size);
    uniforms.steps!.value = Math.min(96, Math.max(40, 1.5 * Math.max(...part.counts)));
    applyScale(this.mesh.material, scale);
    this.mesh.position.set(...part.origin);
    this.mesh.scale.set(size[0]!, size[1]!, size[2]!);
    this.mesh.updateMatrixWorld();
    this.mesh.visible = true;
  }

  /** Before it is drawn: where the eye is, and what is opaque. @param corner, picture of the
   * part of the canvas that is drawn into, pixels */
  prepare(camera: Camera, depth: Texture, corner: Vector2, picture: Vector2): void {
    const { uniforms } = this.mesh.material;
    this.clip.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).multiply(this.mesh.matrixWorld);
    uniforms.toBox!.value.copy(this.clip).invert();
    const toMesh = this.mesh.matrixWorld.clone().invert();
    uniforms.camera!.value.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(toMesh);
    // A direction is the difference of two places.
    uniforms.sight!.value.copy(sightOf(camera)).add(this.mesh.position).applyMatrix4(toMesh);
    uniforms.parallel!.value = camera instanceof OrthographicCamera;
    uniforms.opaqueDepth!.value = depth;
    uniforms.corner!.value.copy(corner);
    uniforms.picture!.value.copy(picture);
  }
}
