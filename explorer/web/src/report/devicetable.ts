// The chosen device: where it stands, and its parameters.
import { h } from '../dom';
import { quantity } from '../quantity';
import type { Description, Device, ParamValue } from '../server';

const metres = (p: number[]) => `${p.map((x) => Number(x.toFixed(4))).join(', ')} m`;

const written = (value: ParamValue, unit: string): string =>
  typeof value === 'number' ? quantity(value, unit, 5) : Array.isArray(value) ? `[${value.map((v) => written(v as ParamValue, '1')).join(', ')}]` : String(value ?? '');

function rows(device: Device, description: Description): [string, string][] {
  const place: [string, string] = device.pose ? ['place', metres(device.pose.p)] : ['on the target', metres(device.at)];
  const unit = (name: string) => description.types[device.type]!.params.find((p) => p.name === name)?.unit ?? '1';
  return [
    place,
    ...(device.facing === 'aim' ? [['looks at', metres(device.value)] as [string, string]] : []),
    ['rate', quantity(device.rate, '1/s', 5)],
    ...Object.entries(device.params).map(([name, value]): [string, string] => [name, written(value, unit(name))]),
  ];
}

export class DeviceTable {
  readonly element = h('section', { className: 'panel grow', id: 'chosen', 'aria-label': 'Chosen device', tabIndex: 0 });

  show(description: Description, name: string | null): void {
    const device = description.devices.find((d) => d.name === name);
    if (!device) return this.element.replaceChildren(h('p', { className: 'hint' }, 'Choose a device in the list or in the picture to read its numbers.'));
    const type = description.types[device.type]!;
    this.element.replaceChildren(
      h('h2', {}, device.name),
      h('p', { className: 'type' }, type.id),
      h('p', { className: 'summary' }, type.summary),
      h('table', {}, h('tbody', {}, ...rows(device, description).map(([key, text]) => h('tr', {}, h('th', { scope: 'row' }, key), h('td', {}, text))))),
    );
  }
}
