// Materials by what they look like, each made once: a program of the graphics card takes longer
// to compile than a field to evaluate.
import { Material } from 'three';

const made = new Map<string, Material>();

/** @param look tells materials apart; those of one look are one */
export function paint<M extends Material>(look: string, make: () => M): M {
  let material = made.get(look);
  if (!material) made.set(look, (material = make()));
  return material as M;
}
