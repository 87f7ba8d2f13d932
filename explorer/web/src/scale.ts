// From values to colours.

/** A channel each; powers of t from 0 to 6. The same polynomial as the program's pictures.
 *
 * Source: van der Walt & Smith, viridis, matplotlib 1.5 (2015), CC0; fitted by Zucker
 *         (2019), https://www.shadertoy.com/view/WlfXRN, CC0.
 */
const coefficients: [number, number, number][] = [
  [0.2777273272234177, 0.005407344544966578, 0.3340998053353061],
  [0.1050930431085774, 1.404613529898575, 1.384590162594685],
  [-0.3308618287255563, 0.214847559468213, 0.09509516302823659],
  [-4.634230498983486, -5.799100973351585, -19.33244095627987],
  [6.228269936347081, 14.17993336680509, 56.69055260068105],
  [4.776384997670288, -13.74514537774601, -65.35303263337234],
  [-5.435455855934631, 4.645852612178535, 26.3124352495832],
];

/** Dark violet at 0, bright yellow at 1; each channel in [0, 1], sRGB. */
export function viridis(t: number): [number, number, number] {
  const x = Math.min(1, Math.max(0, t));
  const channel = (k: number) =>
    Math.min(
      1,
      Math.max(0, coefficients.reduceRight((sum, c) => sum * x + c[k]!, 0)),
    );
  return [channel(0), channel(1), channel(2)];
}

const vector = (c: [number, number, number]) => `vec3(${c.map((x) => x.toFixed(9)).join(', ')})`;

/** The same, and how values reach it, for shaders. */
export const scaleShader = /* glsl */ `
uniform vec2 range;
uniform bool logarithmic;
uniform bool brightIsLarge;
vec3 colourOf(float value) {
  float t = logarithmic
      ? log(max(value, range.x) / range.x) / max(log(range.y / range.x), 1e-20)
      : (value - range.x) / max(range.y - range.x, 1e-30);
  t = clamp(brightIsLarge ? t : 1.0 - t, 0.0, 1.0);
  vec3 c = ${vector(coefficients[6]!)};
  ${[5, 4, 3, 2, 1, 0].map((i) => `c = c * t + ${vector(coefficients[i]!)};`).join('\n  ')}
  return clamp(c, 0.0, 1.0);
}
`;

/** Where in the range a value is, and which colour it has: bright is always good. */
export class Scale {
  constructor(
    readonly min: number,
    readonly max: number,
    readonly logarithmic: boolean,
    readonly brightIsLarge: boolean,
  ) {}

  /** 0 at the least value, 1 at the greatest. */
  part(value: number): number {
    if (!(this.max > this.min)) return 0.5;
    return this.logarithmic
      ? Math.log(value / this.min) / Math.log(this.max / this.min)
      : (value - this.min) / (this.max - this.min);
  }
  /** The value at a part of the range. */
  at(part: number): number {
    return this.logarithmic
      ? this.min * (this.max / this.min) ** part
      : this.min + part * (this.max - this.min);
  }
  colour(value: number): [number, number, number] {
    const t = this.part(value);
    return viridis(this.brightIsLarge ? t : 1 - t);
  }
  /** A colour for CSS. */
  css(value: number): string {
    return `rgb(${this.colour(value).map((c) => Math.round(255 * c)).join(' ')})`;
  }

  /** Round values to label. @param factor display units per SI unit */
  ticks(factor: number): number[] {
    const low = this.min * factor;
    const high = this.max * factor;
    if (!(high > low)) return [this.min];
    const rounded: number[] = [];
    if (this.logarithmic && high / low > 8) {
      for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); ++e)
        for (const m of high / low > 1e3 ? [1] : [1, 2, 5]) rounded.push(m * 10 ** e);
    } else {
      const rough = (high - low) / 5;
      const decade = 10 ** Math.floor(Math.log10(rough));
      const step = [1, 2, 5, 10].find((m) => m * decade >= rough)! * decade;
      for (let k = Math.ceil(low / step); k * step <= high; ++k) rounded.push(k * step);
    }
    return rounded.filter((x) => x >= low && x <= high).map((x) => x / factor);
  }
}
