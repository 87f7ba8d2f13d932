// Places and turns that are typed: "G, X, 0.25, Enter" moves by 25 cm along x.
import { Quaternion, Vector3 } from 'three';
import { newGesture } from './gesture';
import type { Place } from './gizmo';
import { anglesOf, quaternionOf } from './rotation';
import type { Device } from './server';

/** What is held: something that stands in the world. */
export type Held = Pick<Device, 'pose'>;

export interface Hand {
  place: Place;
  /** Take back what this movement has done. */
  back: () => void;
  /** What is being typed, in words; empty: nothing. */
  say: (text: string) => void;
}

const axes = ['x', 'y', 'z'];

export class TypedMove {
  private mode: 'translate' | 'rotate' | null = null;
  private device: Held | null = null;
  private axis = 0;
  private constrained = false;
  private local = false;
  private text = '';
  private gesture = '';
  private changed = false;

  constructor(private readonly hand: Hand) {}

  /** Begin where a device stands now. */
  begin(mode: 'translate' | 'rotate', device: Held | null): void {
    this.end();
    if (!device?.pose) return;
    [this.mode, this.device, this.text, this.changed] = [mode, device, '', false];
    this.axis = mode === 'translate' ? 0 : 2;
    this.local = this.constrained = false;
    this.gesture = newGesture();
    this.show();
  }

  end(): void {
    if (this.mode) this.hand.say('');
    this.mode = null;
  }

  /** @returns whether the key was for it */
  take({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
    if (!this.mode || ctrlKey || metaKey || altKey) return false;
    const axis = axes.indexOf(key.toLowerCase());
    if (axis >= 0) this.constrain(axis);
    else if (/^[-\d.]$/.test(key)) this.type(this.text + key);
    else if (key === 'Backspace') this.type(this.text.slice(0, -1));
    else if (key === 'Enter') this.end();
    else if (key === 'Escape') this.cancel();
    else return false;
    return true;
  }

  private constrain(axis: number): void {
    this.local = axis === this.axis && this.constrained && !this.local;
    this.constrained = true;
    this.axis = axis;
    this.type(this.text);
  }

  private cancel(): void {
    if (this.changed) this.hand.back();
    this.end();
  }

  private type(text: string): void {
    this.text = text;
    this.show();
    const amount = Number(text);
    if (text === '' || !Number.isFinite(amount)) return;
    this.changed = true;
    const { p, R } = this.device!.pose!;
    const way = this.local ? new Vector3(...(R.map((row) => row[this.axis]!) as [number, number, number])) : new Vector3().setComponent(this.axis, 1);
    if (this.mode === 'translate') {
      const to = new Vector3(...p).addScaledVector(way, amount).toArray();
      return this.hand.place({ p: to.map((x) => Number(x.toFixed(6))) }, this.gesture);
    }
    const turn = new Quaternion().setFromAxisAngle(way, (amount * Math.PI) / 180);
    const { w, x, y, z } = turn.multiply(orientationOf(this.device!));
    this.hand.place({ q: [w, x, y, z] }, this.gesture);
  }

  private show(): void {
    const what = this.mode === 'translate' ? 'Move along' : 'Turn about';
    const unit = this.mode === 'translate' ? 'm' : '°';
    const frame = this.local ? ' of the device' : '';
    this.hand.say(`${what} ${axes[this.axis]}${frame}: ${this.text || '…'} ${unit}   X, Y, Z choose the axis, twice for the device's own; Enter, Esc`);
  }
}

function orientationOf(device: Held): Quaternion {
  const [w, x, y, z] = quaternionOf(anglesOf(device.pose!.R)) as [number, number, number, number];
  return new Quaternion(x, y, z, w);
}
