// Surfaces and bodies that the server made, coloured by their values, and the cells of an octree.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GLSL3,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  ShaderMaterial,
} from 'three';
import { scaleShader } from '../maps';
import type { Scale } from '../scale';
import type { MadeMesh, Shapes } from '../shapes';
import { paint } from './paint';
import { applyScale, scaleUniforms } from './uniforms';

const vertexShader = /* glsl */ `
in float sampleValue;
out float value;
out vec3 toEye, across;
void main() {
  value = sampleValue;
  across = normalMatrix * normal;
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  toEye = eye.xyz;
  gl_Position = projectionMatrix * eye;
}
`;

/** Lit from the eye: what is seen from the side is darker. */
const fragmentShader = /* glsl */ `
precision highp float;
uniform bool facets;
in float value;
in vec3 toEye, across;
out vec4 colour;
${scaleShader}
void main() {
  vec3 normal = facets || dot(across, across) < 1e-6 ? cross(dFdx(toEye), dFdy(toEye)) : across;
  float light = 0.45 + 0.55 * abs(normalize(normal).z);
  colour = vec4(light * colourOf(value), 1.0);
}
`;

const material = (facets: boolean) =>
  paint(
    `shape ${facets}`,
    () =>
      new ShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader,
        side: DoubleSide,
        uniforms: { ...scaleUniforms(), facets: { value: facets } },
      }),
  );

export function shapeObject(made: MadeMesh, scale: Scale): Mesh<BufferGeometry, ShaderMaterial[]> {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(made.positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(made.normals, 3));
  geometry.setAttribute('sampleValue', new BufferAttribute(made.values, 1));
  geometry.setIndex(new BufferAttribute(made.triangles, 1));
  const { length } = made.triangles;
  if (made.caps > 0) geometry.addGroup(0, made.caps, 0);
  if (made.caps < length) geometry.addGroup(made.caps, length - made.caps, 1);
  const materials = [material(false), material(true)];
  for (const one of materials) applyScale(one, scale);
  return new Mesh(geometry, materials);
}

export function leavesObject({ positions }: NonNullable<Shapes['leaves']>, colour: string): LineSegments {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return new LineSegments(
    geometry,
    paint(`cells ${colour}`, () => new LineBasicMaterial({ color: colour, transparent: true, opacity: 0.35, depthWrite: false })),
  );
}
