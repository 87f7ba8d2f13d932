// Everything that can be changed of one device.
import { h } from '../dom';
import type { Box, Description, Device, ParamSpec, ParamValue, Setting } from '../server';
import type { Place } from '../gizmo';
import { anglesOf, quaternionOf } from '../rotation';
import { NumberField } from './number';

export type Change = (settings: Setting[], gesture: string) => void;

const axes = ['x', 'y', 'z'];
const components = {
  '': [],
  aim: axes,
  rpy: ['roll', 'pitch', 'yaw'],
  quaternion_wxyz: ['w', 'x', 'y', 'z'],
};
const headings = { aim: 'looks at', rpy: 'turned by', quaternion_wxyz: 'turned by', '': '' };

const metres = { name: 'm', factor: 1 };

interface Field {
  element: HTMLElement;
  update: (device: Device) => void;
}

function numberField(
  read: (device: Device) => number,
  device: Device,
  path: string,
  change: Change,
  spec: Omit<ConstructorParameters<typeof NumberField>[0], 'set'>,
): Field {
  const set = (value: string, gesture: string) => change([{ path, value }], gesture);
  const field = new NumberField({ ...spec, set }, read(device));
  return { element: field.element, update: (d) => field.update(read(d)) };
}

const text = (value: ParamValue): string =>
  Array.isArray(value)
    ? `[${value.map((v) => text(v as ParamValue)).join(', ')}]`
    : String(value ?? '');

/** A choice, or a list of numbers as a text. */
function textField(spec: ParamSpec, device: Device, path: string, change: Change): Field {
  const id = `text-${path}`;
  const onchange = () => change([{ path, value: input.value }], '');
  const input =
    spec.kind === 'choice'
      ? h(
          'select',
          { id, onchange },
          ...spec.choices!.split('|').map((word) => h('option', { value: word }, word)),
        )
      : h('input', { id, type: 'text', spellcheck: false, autocomplete: 'off', onchange });
  const update = (d: Device) => {
    if (document.activeElement !== input || spec.kind === 'choice')
      input.value = text(d.params[spec.name]!);
  };
  update(device);
  const label = h('label', { htmlFor: id, title: spec.help }, spec.name);
  return { element: h('div', { className: 'number wide' }, label, input), update };
}

function parameter(spec: ParamSpec, device: Device, change: Change): Field {
  const path = `devices.${device.name}.params.${spec.name}`;
  if (spec.kind !== 'number') return textField(spec, device, path, change);
  return numberField((d) => d.params[spec.name] as number, device, path, change, {
    label: spec.name,
    help: spec.help,
    unit: spec.unit,
    lower: spec.lower,
    upper: spec.upper,
    // Sizes are steered by factors, whatever a search would do.
    logarithmic: spec.scale === 'log' || spec.upper === null || spec.lower === 0,
  });
}

/** Where it stands, in the frame that its scene says it in. */
function placeFields(device: Device, room: Box, change: Change): Field[] {
  const path = `devices.${device.name}`;
  const size = Math.max(...room.max.map((x, k) => x - room.min[k]!), 1e-3);
  const near = (value: number) => ({ lower: value - size / 2, upper: value + size / 2 });
  if (device.coordinates)
    return device.coordinates.map((_, k) =>
      numberField((d) => d.coordinates![k]!, device, `${path}.coordinates.${k}`, change, {
        label: `${device.surface} ${k}`,
        help: 'Where on its surface it is mounted, from 0 to 1',
        unit: '1',
        lower: 0,
        upper: 1,
        logarithmic: false,
      }),
    );
  return axes.map((axis, k) =>
    numberField((d) => d.at[k]!, device, `${path}.at.${axis}`, change, {
      label: axis,
      help: `Its place along ${axis}${device.group ? `, in the frame of ${device.group}` : ''}`,
      unit: 'm',
      display: metres,
      ...near(device.at[k]!),
      logarithmic: false,
    }),
  );
}

/** Roll, pitch and yaw of what stands in the world, whatever its scene says it by. */
function turnFields(device: Device, place: Place): Field[] {
  const read = (d: Device) => anglesOf(d.pose!.R);
  return components.rpy.map((name, k) => {
    const field: NumberField = new NumberField(
      {
        label: name,
        help: `${headings.rpy}, ${name}`,
        unit: 'rad',
        lower: -Math.PI,
        upper: Math.PI,
        logarithmic: false,
        set: (text, gesture) => {
          const degrees = /^\s*(\S+)\s*deg\s*$/.exec(text);
          const angle = degrees ? (Number(degrees[1]) * Math.PI) / 180 : Number(text);
          if (!Number.isFinite(angle)) return field.update(read(now)[k]!);
          const angles = read(now);
          angles[k] = angle;
          place({ q: quaternionOf(angles) }, gesture);
        },
      },
      read(device)[k]!,
    );
    let now = device;
    const update = (d: Device) => field.update(read((now = d))[k]!);
    return { element: field.element, update };
  });
}

function facingFields(device: Device, room: Box, change: Change, place: Place): Field[] {
  const key = device.facing;
  if (key === '') return [];
  if (key === 'quaternion_wxyz' && device.pose) return turnFields(device, place);
  const size = Math.max(...room.max.map((x, k) => x - room.min[k]!), 1e-3);
  const bounds = {
    aim: (v: number) => [v - size, v + size],
    rpy: () => [-Math.PI, Math.PI],
    quaternion_wxyz: () => [-1, 1],
  }[key];
  return components[key].map((name, k) => {
    const [lower, upper] = bounds(device.value[k]!);
    return numberField((d) => d.value[k]!, device, `devices.${device.name}.${key}.${name}`, change, {
      label: name,
      help: `${headings[key]}, ${name}`,
      unit: { aim: 'm', rpy: 'rad', quaternion_wxyz: '1' }[key],
      ...(key === 'aim' ? { display: metres } : {}),
      lower: lower!,
      upper: upper!,
      logarithmic: false,
    });
  });
}

const section = (title: string, fields: Field[]) =>
  fields.length > 0 &&
  h('section', { className: 'fields' }, h('h3', {}, title), ...fields.map((f) => f.element));

export class Inspector {
  readonly element = h('div', { className: 'inspector' });
  private fields: Field[] = [];
  private shown = '';

  constructor(
    private readonly change: Change,
    private readonly place: Place,
  ) {}

  show(description: Description, name: string | null): void {
    const device = description.devices.find((d) => d.name === name);
    // The same device with the same fields keeps its elements, and the focus in them.
    const key = device ? `${device.name} ${device.type} ${device.facing} ${description.name}` : '';
    if (key !== '' && key === this.shown) {
      for (const field of this.fields) field.update(device!);
      return;
    }
    this.shown = key;
    if (!device) {
      this.fields = [];
      this.element.replaceChildren(
        h('p', { className: 'hint' }, 'Choose a device in the list or in the picture to change it.'),
      );
      return;
    }
    const type = description.types[device.type]!;
    const place = placeFields(device, description.room, this.change);
    const facing = facingFields(device, description.room, this.change, this.place);
    const rate = numberField((d) => d.rate, device, `devices.${device.name}.rate`, this.change, {
      label: 'rate',
      help: 'Updates a second',
      unit: '1/s',
      lower: null,
      upper: null,
      logarithmic: true,
    });
    const params = type.params.map((spec) => parameter(spec, device, this.change));
    this.fields = [...place, ...facing, rate, ...params];
    this.element.replaceChildren(
      h('header', {}, h('h2', {}, device.name), h('p', { className: 'type' }, type.id)),
      h('p', { className: 'summary' }, type.summary),
      section(device.mount === 'target' ? 'Place on the target' : 'Place', place) || '',
      section(headings[device.facing], facing) || '',
      section('Readings', [rate, ...params]) || '',
    );
  }
}
