import type { Prospect, Prospects } from '../api/virtual';
import { counted } from '../ui/format';

/** The first in turn that the drone could serve is the one that it is sent to fly. */
export function nextFlight({ waiting }: Prospects): Prospect | null {
  return waiting.find((one) => one.flies) ?? null;
}

export function prospectText({ name, owner, waypoints }: Prospect): string {
  const what =
    name === null ? 'a virtual drone of somebody else' : `“${name}”${owner === null ? '' : ` of ${owner}`}`;
  return `${what} (${counted(waypoints, 'waypoint')})`;
}

/** The other waiting missions: those that it flies later, and those that it cannot fly. */
export function laterFlights(prospects: Prospects): string[] {
  const first = nextFlight(prospects);
  return prospects.waiting
    .filter((one) => one !== first)
    .map((one) =>
      one.flies ? `Then ${prospectText(one)}.` : `Not for ${prospectText(one)}: ${one.why ?? ''}`,
    );
}

/** The same drone would set off for the same. */
export function sameFlights(before: Prospects, now: Prospects): boolean {
  return JSON.stringify(nextFlight(before)) === JSON.stringify(nextFlight(now));
}
