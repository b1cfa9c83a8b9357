import { describe, expect, it } from 'vitest';
import type { AccessKey } from '../api/access-keys';
import { scopesOf, scopeText, usageText } from './key-text';

const NOW = Date.parse('2026-05-01T12:00:00Z');

function key(more: Partial<AccessKey> = {}): AccessKey {
  return {
    id: 'k1',
    label: 'script',
    role: 'operator',
    operations: ['view', 'command'],
    drones: null,
    area: null,
    floor: null,
    ceiling: null,
    altitudeReference: null,
    expiresAt: null,
    parent: null,
    createdAt: '2026-04-01T12:00:00Z',
    key: null,
    lastUsedAt: null,
    ...more,
  };
}

describe('the lines of a key', () => {
  it('show the scope', () => {
    expect(scopeText(key(), (id) => id)).toBe('operator: view, command · all drones');
    expect(scopeText(key({ drones: ['a', 'b'] }), (id) => `Copter ${id}`)).toBe(
      'operator: view, command · Copter a, Copter b',
    );
    expect(scopeText(key({ drones: ['a', 'b', 'c', 'd'] }), (id) => id)).toContain('4 drones');
    expect(scopeText(key({ ceiling: 50, altitudeReference: 'home' }), (id) => id)).toBe(
      'operator: view, command · all drones · up to 50 m above home',
    );
  });

  it('say until when it serves and when it did', () => {
    expect(usageText(key(), NOW)).toBe('not used yet');
    const line = usageText(
      key({ expiresAt: '2026-06-01T00:00:00Z', lastUsedAt: '2026-05-01T11:55:00Z' }),
      NOW,
    );
    expect(line).toMatch(/^until .* · used 5 min ago$/);
    expect(usageText(key({ expiresAt: '2026-04-01T00:00:00Z' }), NOW)).toMatch(/^ended /);
  });

  it('offer no more than the owner may', () => {
    expect(scopesOf('viewer').map((scope) => scope.label)).toEqual(['only look']);
    expect(scopesOf('supervisor')).toHaveLength(3);
    expect(scopesOf('administrator')).toHaveLength(4);
  });
});
