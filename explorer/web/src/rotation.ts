// Rotations as scenes write them: R = Rz(yaw)·Ry(pitch)·Rx(roll).
import { Euler, Matrix4, Quaternion } from 'three';
import type { Vec3 } from './server';

/** @param R rows @returns roll, pitch, yaw, radians */
export function anglesOf(R: [Vec3, Vec3, Vec3]): Vec3 {
  const [x, y, z] = R;
  const matrix = new Matrix4().set(...x, 0, ...y, 0, ...z, 0, 0, 0, 0, 1);
  const euler = new Euler().setFromRotationMatrix(matrix, 'ZYX');
  return [euler.x, euler.y, euler.z];
}

/** @returns w, x, y, z */
export function quaternionOf([roll, pitch, yaw]: Vec3): number[] {
  const { w, x, y, z } = new Quaternion().setFromEuler(new Euler(roll, pitch, yaw, 'ZYX'));
  return [w, x, y, z];
}
