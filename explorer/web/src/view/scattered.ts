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
uniform bool ringed;
void main() {
  value = sampleValue;
  valid = sampleDrawn == 1.0 ? 1.0 : 0.0;
  drawn = sampleDrawn;
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  toEye = eye.xyz;
  gl_PointSize = size;
  gl_Position = projectionMatrix * eye;
  if (ringed) gl_Position.z -= 2e-3 * gl_Position.w;  // before what they lie on
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

/** Discs; rings where there is no value. Ringed, they are seen on what has their colour. */
const pointShader = /* glsl */ `
${head}
uniform bool ringed;
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5 || (valid < 0.5 && r < 0.28)) discard;
  if (ringed && r > 0.38) {
    colour = vec4(blindB, 1.0);
    return;
  }
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

/** @param ringed points on a surface of their colours */
export function scatteredObject(
  field: Field,
  part: PointsPart | SurfacePart,
  ringed = false,
): Object3D & { material: ShaderMaterial; geometry: BufferGeometry } {
  const surface = part.kind === 'surface';
  const points = (part.count > 2000 ? 5 : 9) + (ringed ? 2 : 0);
  const material = paint(
    `samples ${part.kind} ${points} ${ringed}`,
    () =>
      new ShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader: surface ? surfaceShader : pointShader,
        side: DoubleSide,
        uniforms: { ...scaleUniforms(), size: { value: points }, ringed: { value: ringed } },
      }),
  );
  const geometry = geometryOf(field, part);
  return surface ? new Mesh(geometry, material) : new Points(geometry, material);
}
