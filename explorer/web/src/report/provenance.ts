// What computes a report again.
import { table } from './parts';

export const versions = (all: { part: string; version: string }[]) =>
  table('versions', 'Versions', ['part', 'version'], all.map((v) => [v.part, v.version]));

/** What a shell reads as one word. */
export const quoted = (word: string) => (/^[\w./=,:+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
