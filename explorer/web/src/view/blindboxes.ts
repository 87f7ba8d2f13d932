// Where the field is blind: a box around each region.
import { Box3, Box3Helper, Color, Group, Vector3 } from 'three';
import { CSS2DObject } from 'three/addons/renderers/CSS2DRenderer.js';
import type { BlindRegions } from '../server';

export function blindBoxes({ regions }: BlindRegions, colour: string): Group {
  const group = new Group();
  regions.forEach(({ box, why }, k) => {
    const bounds = new Box3(new Vector3(...box.min), new Vector3(...box.max)).expandByScalar(1e-3);
    group.add(new Box3Helper(bounds, new Color(colour)));
    const element = document.createElement('div');
    element.className = 'tag blind';
    element.textContent = `${k + 1}`;
    element.title = why;
    const label = new CSS2DObject(element);
    label.position.copy(bounds.getCenter(new Vector3()));
    group.add(label);
  });
  return group;
}
