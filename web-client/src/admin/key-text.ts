import type { AccessKey, KeyOperation } from '../api/access-keys';
import { mayAct, type Role } from '../api/accounts';
import { age, counted } from '../ui/format';
import { boundsText } from './key-bounds';

/** Scopes that a key can have, least first; each needs a role of its owner. */
export const KEY_SCOPES: readonly { label: string; operations: KeyOperation[]; needs: Role }[] = [
  { label: 'only look', operations: ['view'], needs: 'viewer' },
  { label: 'look and plan', operations: ['view', 'plan'], needs: 'planner' },
  { label: 'look, plan and command', operations: ['view', 'plan', 'command'], needs: 'operator' },
  { label: 'all that I may', operations: ['view', 'plan', 'command', 'administer'], needs: 'administrator' },
];

export function scopesOf(role: Role | undefined): typeof KEY_SCOPES {
  return KEY_SCOPES.filter((scope) => mayAct(role, scope.needs));
}

/** The scope of a key, in one line. */
export function scopeText(key: AccessKey, nameOf: (drone: string) => string): string {
  const drones =
    key.drones === null
      ? 'all drones'
      : key.drones.length > 3
        ? counted(key.drones.length, 'drone')
        : key.drones.map(nameOf).join(', ');
  const parts = [`${key.role}: ${key.operations.join(', ')}`, drones, boundsText(key)];
  return parts.filter((part) => part !== '').join(' · ');
}

/** The expiry and last use of a key. */
export function usageText(key: AccessKey, now: number): string {
  const used = key.lastUsedAt === null ? 'not used yet' : `used ${age(now - Date.parse(key.lastUsedAt))}`;
  if (key.expiresAt === null) {
    return used;
  }
  const ends = Date.parse(key.expiresAt);
  const day = new Date(ends).toLocaleDateString();
  return `${ends <= now ? `ended ${day}` : `until ${day}`} · ${used}`;
}
