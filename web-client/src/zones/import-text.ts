import type { ZoneLeftOutView } from '@dronemap/client';
import type { ZoneImport } from '../api/zones';
import { counted } from '../ui/format';

/** How many zones a file gave, and how much of it was left out. */
export function importText({ zones, leftOut, leftOutTotal }: ZoneImport): string {
  const added = `${counted(zones.length, 'zone')} added.`;
  if (leftOutTotal === 0) {
    return added;
  }
  const shown = leftOut.length < leftOutTotal ? `, the first ${leftOut.length} here` : '';
  return `${added} Left out: ${counted(leftOutTotal, 'thing')} of the file${shown}.`;
}

/** Where it stands in the file, and why it is no zone. */
export function leftOutText({ at, name, why }: ZoneLeftOutView): string {
  return `${(name ?? null) === null ? at : `${name} (${at})`}: ${why}`;
}
