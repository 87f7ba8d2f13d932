// What all that is drawn by values shares: the scale, and how no value looks.
import { Color, ShaderMaterial, Vector2, Vector3 } from 'three';
import { maps } from '../maps';
import type { Scale } from '../scale';

/** Colours of what has no value; the page's theme sets them. */
export const blindColours = {
  a: new Color('#5b6270'),
  b: new Color('#2b303b'),
  solid: new Color('#14161c'),
  gained: new Color('#2f7fd0'),
  lost: new Color('#d0691f'),
};

/** Hatched is blind, and, of a difference, what only one of the two sees; the numbers are
 * those of `Drawn`. */
export const blindShader = /* glsl */ `
uniform vec3 blindA, blindB, solid, gained, lost;
vec3 withoutValue(float drawn) {
  if (drawn > 1.5 && drawn < 2.5) return solid;
  float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.0);
  vec3 a = drawn < 0.5 ? blindA : drawn < 3.5 ? gained : lost;
  return stripe < 5.0 ? a : blindB;
}
`;

export function scaleUniforms() {
  return {
    range: { value: new Vector2(0, 1) },
    logarithmic: { value: false },
    brightIsLarge: { value: false },
    difference: { value: false },
    powers: { value: maps.viridis.map((c) => new Vector3(...c)) },
    blindA: { value: blindColours.a },
    blindB: { value: blindColours.b },
    solid: { value: blindColours.solid },
    gained: { value: blindColours.gained },
    lost: { value: blindColours.lost },
  };
}

export function applyScale({ uniforms }: ShaderMaterial, scale: Scale): void {
  uniforms.range!.value.set(scale.min, scale.max);
  uniforms.logarithmic!.value = scale.logarithmic;
  uniforms.brightIsLarge!.value = scale.brightIsLarge;
  uniforms.difference!.value = scale.difference;
  maps[scale.map].forEach((c, k) => uniforms.powers!.value[k].set(...c));
}
