// A live table of all drones in a terminal, until Ctrl-C:  npx tsx examples/live-table.ts
import type { DroneView } from '@dronemap/client';
import { connected } from './connected.js';

const drones = new Map<string, DroneView>();
const stop = new AbortController();
process.once('SIGINT', () => stop.abort());

await using dronemap = await connected();
try {
  for await (const change of dronemap.changes({ rate: 2, signal: stop.signal })) {
    if (change.type === 'drones') {
      drones.clear();
      change.drones.forEach((drone) => drones.set(drone.id, drone));
    } else if (change.type === 'drone') {
      drones.set(change.drone.id, change.drone);
    } else if (change.type === 'droneRemoved') {
      drones.delete(change.id);
    }
    show();
  }
} catch (thrown) {
  if (!stop.signal.aborted) {
    throw thrown;
  }
}

function show(): void {
  const rows = [...drones.values()]
    .sort((one, other) => one.name.localeCompare(other.name))
    .map((drone) => [
      drone.name,
      drone.link.state,
      drone.mode ?? '?',
      drone.flight ?? '?',
      metres(drone.position?.altitudeAboveHome),
      percent(drone.battery?.percent),
      drone.control.holder ?? '–',
    ]);
  const table = [['name', 'link', 'mode', 'flight', 'height', 'battery', 'control'], ...rows];
  const widths = (table[0] ?? []).map((_, column) =>
    Math.max(...table.map((row) => row[column]?.length ?? 0)),
  );
  const lines = table.map((row) => row.map((cell, column) => cell.padEnd(widths[column] ?? 0)).join('  '));
  process.stdout.write(`\u001B[2J\u001B[H${lines.join('\n')}\n`);
}

function metres(height: number | null | undefined): string {
  return height === null || height === undefined ? '?' : `${height.toFixed(1)} m`;
}

function percent(value: number | null | undefined): string {
  return value === null || value === undefined ? '?' : `${Math.round(value)} %`;
}
