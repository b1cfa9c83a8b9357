/** Packs the client, puts it alone into a folder as npm would, and says whether Node runs it and TypeScript knows its types. */
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const HERE = fileURLToPath(new URL('..', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'dronemap-client-'));

/** What is said is shown only when it fails. */
const run = (program: string, ...given: string[]): string =>
  execFileSync(program, given, { cwd: folder, encoding: 'utf8' });

/** Types of Node, and none of a browser: who uses the client there has no others. */
const OPTIONS = ['--strict', '--module', 'nodenext', '--target', 'es2022', '--types', 'node', '--noEmit'];
const LIBRARIES = ['--lib', 'es2023,esnext.disposable'];

const PROGRAM = `
import { Dronemap, Problem, VERSION, type DroneView } from '@dronemap/client';

export async function watch(dronemap: Dronemap): Promise<DroneView | undefined> {
  const drone = await dronemap.drone('Copter 1');
  await using control = await drone.control({ onExit: 'land' });
  for await (const state of drone.states({ rate: 2, signal: control.signal })) {
    return state;
  }
  return undefined;
}

const refused: unknown = await Dronemap.connect({ url: 'http://127.0.0.1:1', key: 'none' }).catch((thrown: unknown) => thrown);
console.log(VERSION, refused instanceof Problem);
`;

try {
  execFileSync('npm', ['pack', '--silent', '--pack-destination', folder], { cwd: HERE, encoding: 'utf8' });
  const client = join(folder, 'node_modules', '@dronemap', 'client');
  mkdirSync(client, { recursive: true });
  run('sh', '-c', `tar -xzf dronemap-client-*.tgz --strip-components=1 -C '${client}'`);
  symlinkSync(join(HERE, 'node_modules', '@types'), join(folder, 'node_modules', '@types'));
  symlinkSync(join(HERE, 'node_modules', 'undici-types'), join(folder, 'node_modules', 'undici-types'));
  writeFileSync(join(folder, 'package.json'), '{"type":"module"}');
  writeFileSync(join(folder, 'program.ts'), PROGRAM);
  const tsc = join(HERE, 'node_modules', '.bin', 'tsc');
  run(tsc, ...OPTIONS, ...LIBRARIES, 'program.ts');
  run(tsc, '--module', 'nodenext', '--target', 'es2022', '--types', 'node', '--skipLibCheck', 'program.ts');
  console.log(run(process.execPath, 'program.js').trim());
} catch (thrown) {
  const { stdout = '', stderr = '' } = thrown as { stdout?: string; stderr?: string };
  console.error(`The packed client does not serve alone: ${String(thrown)}\n${stdout}${stderr}`);
  process.exitCode = 1;
} finally {
  rmSync(folder, { recursive: true, force: true });
}
