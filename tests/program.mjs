// The program as its users start it, for the tests that do: PLICA (the program), WORK (a folder).
import { spawnSync } from 'node:child_process';
import { mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';

export const plica = process.env.PLICA;

// An empty folder of that name.
export function folder(name) {
  const path = join(process.env.WORK, name);
  rmSync(path, { recursive: true, force: true });
  mkdirSync(path, { recursive: true });
  return path;
}

// run(cwd, ...args): how the program ended, what it said and printed. `timeout` in ms.
export const runner = (timeout) => (cwd, ...args) => {
  const { status, stdout, stderr } = spawnSync(plica, args, { cwd, encoding: 'utf8', timeout, maxBuffer: 1e8 });
  return { status, said: stderr, printed: stdout };
};
