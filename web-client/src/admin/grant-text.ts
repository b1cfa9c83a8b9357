import type { KeyOperation } from '../api/access-keys';
import type { Fleet, Grant, Group, Subject } from '../api/grants';
import type { User } from '../api/accounts';
import { counted } from '../ui/format';

/** Operations that can be granted, least first. */
export const OPERATIONS: readonly { label: string; operations: KeyOperation[] }[] = [
  { label: 'look', operations: ['view'] },
  { label: 'look and plan', operations: ['view', 'plan'] },
  { label: 'look, plan and command', operations: ['view', 'plan', 'command'] },
  { label: 'all that their role allows', operations: ['view', 'plan', 'command', 'administer'] },
];

/** For how long, in hours. */
export const LENGTHS: readonly { label: string; hours: number | null }[] = [
  { label: 'an hour', hours: 1 },
  { label: 'a day', hours: 24 },
  { label: '7 days', hours: 168 },
  { label: '30 days', hours: 720 },
  { label: 'until revoked', hours: null },
];

/** Somebody with grants, or bound to see only those. */
export interface Holder extends Subject {
  key: string;
  name: string;
  onlyGranted: boolean;
  grants: Grant[];
}

function keyOf(subject: Subject): string {
  return subject.user === null ? `group ${subject.group ?? ''}` : `user ${subject.user}`;
}

/** Those who are bound or were granted something, the bound first. */
export function holdersOf(
  users: readonly User[],
  groups: readonly Group[],
  grants: readonly Grant[],
): Holder[] {
  const all: Holder[] = [
    ...groups.map((group) => ({
      user: null,
      group: group.id,
      name: `${group.name} (group)`,
      onlyGranted: group.onlyGranted,
    })),
    ...users.map((user) => ({
      user: user.name,
      group: null,
      name: user.name,
      onlyGranted: user.onlyGranted,
    })),
  ].map((one) => ({
    ...one,
    key: keyOf(one),
    grants: grants.filter((grant) => keyOf(grant) === keyOf(one)),
  }));
  return all
    .filter((one) => one.onlyGranted || one.grants.length > 0)
    .sort((a, b) => Number(b.onlyGranted) - Number(a.onlyGranted));
}

function dronesText(grant: Grant, fleets: readonly Fleet[], nameOf: (drone: string) => string): string {
  if (grant.fleet !== null) {
    return fleets.find((fleet) => fleet.id === grant.fleet)?.name ?? 'a fleet';
  }
  if (grant.virtual) {
    return 'their own virtual drones';
  }
  if (grant.drones === null) {
    return 'all drones';
  }
  return grant.drones.length > 3
    ? counted(grant.drones.length, 'drone')
    : grant.drones.map(nameOf).join(', ');
}

/** A grant in one line: operations, drones, end. */
export function grantText(grant: Grant, fleets: readonly Fleet[], nameOf: (drone: string) => string): string {
  const what = `${grant.operations.join(', ')} · ${dronesText(grant, fleets, nameOf)}`;
  if (grant.state === 'toCome') {
    return `${what} · from ${new Date(grant.from).toLocaleString()}`;
  }
  if (grant.until === null) {
    return what;
  }
  return `${what} · ${grant.state === 'over' ? 'ended' : 'until'} ${new Date(grant.until).toLocaleString()}`;
}
