// Colours of a part of a range: maps in which equal steps look equal.

export type Rgb = [number, number, number];

/** A channel each; powers of t from 0 to 6. That of viridis is the program's pictures', too.
 *
 * Source: van der Walt & Smith, viridis, plasma, inferno, magma, matplotlib 1.5 (2015), CC0;
 *         fitted by Zucker (2019), https://www.shadertoy.com/view/WlfXRN, CC0.
 */
export const maps = {
  viridis: [
    [0.2777273272234177, 0.005407344544966578, 0.3340998053353061],
    [0.1050930431085774, 1.404613529898575, 1.384590162594685],
    [-0.3308618287255563, 0.214847559468213, 0.09509516302823659],
    [-4.634230498983486, -5.799100973351585, -19.33244095627987],
    [6.228269936347081, 14.17993336680509, 56.69055260068105],
    [4.776384997670288, -13.74514537774601, -65.35303263337234],
    [-5.435455855934631, 4.645852612178535, 26.3124352495832],
  ],
  plasma: [
    [0.05873234392399702, 0.02333670892565664, 0.5433401826748754],
    [2.176514634195958, 0.2383834171260182, 0.7539604599784036],
    [-2.689460476458034, -7.455851135738909, 3.110799939717086],
    [6.130348345893603, 42.3461881477227, -28.51885465332158],
    [-11.10743619062271, -82.66631109428045, 60.13984767418263],
    [10.02306557647065, 71.41361770095349, -54.07218655560067],
    [-3.658713842777788, -22.93153465461149, 18.19190778539828],
  ],
  inferno: [
    [0.0002189403691192265, 0.001651004631001012, -0.01948089843709184],
    [0.1065134194856116, 0.5639564367884091, 3.932712388889277],
    [11.60249308247187, -3.972853965665698, -15.9423941062914],
    [-41.70399613139459, 17.43639888205313, 44.35414519872813],
    [77.162935699427, -33.40235894210092, -81.80730925738993],
    [-71.31942824499214, 32.62606426397723, 73.20951985803202],
    [25.13112622477341, -12.24266895238567, -23.07032500287172],
  ],
  magma: [
    [-0.002136485053939582, -0.000749655052795221, -0.005386127855323933],
    [0.2516605407371642, 0.6775232436837668, 2.494026599312351],
    [8.353717279216625, -3.577719514958484, 0.3144679030132573],
    [-27.66873308576866, 14.26473078096533, -13.64921318813922],
    [52.17613981234068, -27.94360607168351, 12.94416944238394],
    [-50.76852536473588, 29.04658282127291, 4.23415299384598],
    [18.65570506591883, -11.48977351997711, -5.601961508734096],
  ],
} satisfies Record<string, Rgb[]>;
export type MapName = keyof typeof maps;

const bounded = (x: number) => Math.min(1, Math.max(0, x));

/** Dark at 0, bright at 1; each channel in [0, 1], sRGB. */
export function sequential(map: MapName, t: number): Rgb {
  const x = bounded(t);
  return [0, 1, 2].map((k) => bounded(maps[map].reduceRight((sum, c) => sum * x + c[k]!, 0))) as Rgb;
}

/** Ends and middle of the map of differences: orange and blue, which the colour-blind tell
 * apart, equally dark, and what isn't different pale. */
export const poles: { worse: Rgb; same: Rgb; better: Rgb } = {
  worse: [0.7, 0.35, 0.02],
  same: [0.94, 0.94, 0.94],
  better: [0.05, 0.38, 0.68],
};

/** The worst at 0, no difference at ½, the best at 1. */
export function diverging(t: number): Rgb {
  const x = bounded(t);
  const [far, part] = x < 0.5 ? [poles.worse, 1 - 2 * x] : [poles.better, 2 * x - 1];
  return poles.same.map((c, k) => c + part * (far[k]! - c)) as Rgb;
}

const vector = (c: Rgb) => `vec3(${c.map((x) => x.toFixed(6)).join(', ')})`;

/** The same for shaders, and how values reach it. */
export const scaleShader = /* glsl */ `
uniform vec2 range;
uniform bool logarithmic;
uniform bool brightIsLarge;
uniform bool difference;
uniform vec3 powers[7];
float partOf(float value) {
  float t = logarithmic
      ? log(max(value, range.x) / range.x) / max(log(range.y / range.x), 1e-20)
      : (value - range.x) / max(range.y - range.x, 1e-30);
  return clamp(t, 0.0, 1.0);
}
vec3 colourOf(float value) {
  float t = partOf(value);
  t = brightIsLarge ? t : 1.0 - t;
  if (difference) {
    vec3 far = t < 0.5 ? ${vector(poles.worse)} : ${vector(poles.better)};
    return mix(${vector(poles.same)}, far, abs(2.0 * t - 1.0));
  }
  vec3 c = powers[6];
  for (int i = 5; i >= 0; --i) c = c * t + powers[i];
  return clamp(c, 0.0, 1.0);
}
`;
