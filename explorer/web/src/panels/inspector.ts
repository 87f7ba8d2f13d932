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
  h('section', { className: 'fields', 'aria-label': title }, h('h3', {}, title), ...fields.map((f) => f.element));

const lengths: Record<string, number> = { '': 1, m: 1, cm: 1e-2, mm: 1e-3, ft: 0.3048, in: 0.0254 };

/** "2.5", "25 cm" in metres; not a number where it is something else. */
function metresOf(text: string): number {
  const match = /^\s*([-+.\de]+)\s*([a-z]*)\s*$/i.exec(text);
  return match ? Number(match[1]) * (lengths[match[2]!] ?? NaN) : NaN;
}

/** A change of one device, for all of its type: places move by as much, all else becomes the
 * same. */
function forAll(set: Setting, device: Device, devices: Device[]): Setting[] {
  const own = `devices.${device.name}.`;
  const axis = axes.indexOf(/^at\.([xyz])$/.exec(set.path.slice(own.length))?.[1] ?? '');
  const way = axis < 0 ? NaN : metresOf(set.value) - device.at[axis]!;
  return devices
    .filter((d) => d.type === device.type)
    .map((d) => ({
      path: `devices.${d.name}.${set.path.slice(own.length)}`,
      value: Number.isFinite(way) ? String(Number((d.at[axis]! + way).toFixed(6))) : set.value,
    }));
}

/** What is done with a device as a whole. */
export interface WholeDevice {
  copy: () => void;
  array: () => void;
  mirror: (axis: 'x' | 'y') => void;
  remove: () => void;
}

export class Inspector {
  readonly element = h('div', { className: 'inspector' });
  private readonly all = h('input', { type: 'checkbox', id: 'all-of-type' });
  private description: Description | null = null;
  private device: Device | null = null;
  private fields: Field[] = [];
  private shown = '';

  constructor(
    private readonly changeOne: Change,
    private readonly place: Place,
    private readonly whole: WholeDevice,
  ) {}

  private readonly change: Change = (settings, gesture) => {
    const { device } = this;
    const all = device && this.all.checked && !/\.(aim|rpy|quaternion_wxyz|coordinates)\./.test(settings[0]!.path);
    this.changeOne(
      all ? settings.flatMap((s) => forAll(s, device, this.description!.devices)) : settings,
      gesture,
    );
  };

  show(description: Description, name: string | null): void {
    const device = description.devices.find((d) => d.name === name);
    this.description = description;
    this.device = device ?? null;
    // The same device with the same fields keeps its elements, and the focus in them.
    const key = device ? `${device.name} ${device.type} ${device.facing} ${description.name}` : '';
    if (key !== '' && key === this.shown) {
      for (const field of this.fields) field.update(device!);
      return;
    }
    this.shown = key;
    this.all.checked = false;
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
      this.actionsOn(),
      ...this.allOf(description, device),
      section(device.mount === 'target' ? 'Place on the target' : 'Place', place) || '',
      section(headings[device.facing], facing) || '',
      section('Readings', [rate, ...params]) || '',
    );
  }

  private actionsOn(): HTMLElement {
    const { copy, array, mirror, remove } = this.whole;
    const button = (text: string, title: string, onclick: () => void) => h('button', { type: 'button', title, onclick }, text);
    return h(
      'div',
      { className: 'actions', role: 'group', 'aria-label': 'This device' },
      button('Copy', 'Once more, beside it (D)', copy),
      button('Array…', 'More times, along a row or around a circle (Shift D)', array),
      button('Mirror x', 'Once more, mirrored across x through the middle of the samples (M)', () => mirror('x')),
      button('Mirror y', 'Once more, mirrored across y through the middle of the samples (Shift M)', () => mirror('y')),
      button('Remove', 'Take it away (Delete)', remove),
    );
  }

  /** One control for all of a kind. */
  private allOf(description: Description, device: Device): HTMLElement[] {
    const count = description.devices.filter((d) => d.type === device.type).length;
    if (count < 2) return [];
    const title = 'Places move by as much; rates and parameters become the same';
    return [h('label', { className: 'all', title }, this.all, `change all ${count} of this type`)];
  }
}
