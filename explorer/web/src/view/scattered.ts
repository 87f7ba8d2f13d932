// Samples without a grid, coloured: points, and the vertices of surfaces.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GLSL3,
  Mesh,
  Object3D,
  Points,
  ShaderMaterial,
} from 'three';
import { Drawn, type Field, type PointsPart, type SurfacePart } from '../field';
import { scaleShader } from '../maps';
import { paint } from './paint';
import { blindShader, scaleUniforms } from './uniforms';

const vertexShader = /* glsl */ `
in float sampleValue;
in float sampleDrawn;
out float value, valid;
flat out float drawn;
out vec3 toEye;
uniform float size;
void main() {
  value = sampleValue;
  valid = sampleDrawn == 1.0 ? 1.0 : 0.0;
  drawn = sampleDrawn;
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  toEye = eye.xyz;
  gl_PointSize = size;
  gl_Position = projectionMatrix * eye;
}
`;

const head = /* glsl */ `
precision highp float;
in float value, valid;
flat in float drawn;
in vec3 toEye;
out vec4 colour;
${scaleShader}
${blindShader}
`;

/** Discs; rings where there is no value. */
const pointShader = /* glsl */ `
${head}
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5 || (valid < 0.5 && r < 0.28)) discard;
  colour = vec4(valid < 0.5 ? (drawn < 0.5 ? blindA : withoutValue(drawn)) : colourOf(value), 1.0);
}
`;

/** Triangles with a blind corner are hatched as far as that is the nearest. */
const surfaceShader = /* glsl */ `
${head}
void main() {
  vec3 normal = normalize(cross(dFdx(toEye), dFdy(toEye)));
  float light = 0.78 + 0.22 * abs(normal.z);
  if (valid < 0.999) {
    colour = vec4(light * withoutValue(drawn == 1.0 ? 0.0 : drawn), 1.0);
  } else {
    colour = vec4(light * colourOf(value), 1.0);
  }
}
`;

function geometryOf(field: Field, part: PointsPart | SurfacePart): BufferGeometry {
  const end = part.first + part.count;
  const drawn = Float32Array.from(field.mask.subarray(part.first, end));
  const values = field.values.slice(part.first, end);
  // Not a number would spread over a triangle, wherever it is hatched.
  for (let i = 0; i < values.length; ++i) if (drawn[i] !== Drawn.value) values[i] = 0;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(part.positions, 3));
  geometry.setAttribute('sampleValue', new BufferAttribute(values, 1));
  geometry.setAttribute('sampleDrawn', new BufferAttribute(drawn, 1));
  if (part.kind === 'surface') geometry.setIndex(new BufferAttribute(part.triangles, 1));
  return geometry;
}

/** @param points how large they are drawn, pixels */
export function scatteredObject(
  field: Field,
  part: PointsPart | SurfacePart,
  points: number,
): Object3D & { material: ShaderMaterial; geometry: BufferGeometry } {
  const surface = part.kind === 'surface';
  const material = paint(
    `samples ${part.kind} ${points}`,
    () =>
      new ShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader: surface ? surfaceShader : pointShader,
        side: DoubleSide,
        uniforms: { ...scaleUniforms(), size: { value: points } },
      }),
  );
  const geometry = geometryOf(field, part);
  return surface ? new Mesh(geometry, material) : new Points(geometry, material);
}
