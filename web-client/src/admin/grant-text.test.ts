import { describe, expect, it } from 'vitest';
import type { User } from '../api/accounts';
import type { Grant, Group } from '../api/grants';
import { grantText, holdersOf } from './grant-text';

function grant(more: Partial<Grant> = {}): Grant {
  return {
    id: 'g1',
    user: 'ann',
    group: null,
    all: true,
    virtual: false,
    drones: null,
    fleet: null,
    operations: ['view', 'command'],
    from: '2026-05-01T12:00:00Z',
    until: null,
    state: 'inForce',
    by: 'root',
    at: '2026-05-01T12:00:00Z',
    ...more,
  };
}

function user(name: string, onlyGranted = false): User {
  return { name, role: 'operator', state: 'active', mustChangePassword: false, onlyGranted };
}

const CREW: Group = { id: 'c', name: 'Crew', members: ['ann'], onlyGranted: true };

describe('the text of a grant', () => {
  it('says what, with which drones and until when', () => {
    expect(grantText(grant(), [], (id) => id)).toBe('view, command · all drones');
    expect(grantText(grant({ drones: ['a', 'b'] }), [], (id) => `Copter ${id}`)).toBe(
      'view, command · Copter a, Copter b',
    );
    expect(grantText(grant({ drones: ['a', 'b', 'c', 'd'] }), [], (id) => id)).toContain('4 drones');
    const fleet = { id: 'f', name: 'Trucks', drones: [] };
    expect(grantText(grant({ fleet: 'f' }), [fleet], (id) => id)).toContain('Trucks');
    const until = '2026-05-02T12:00:00Z';
    expect(grantText(grant({ until }), [], (id) => id)).toContain('until');
    expect(grantText(grant({ until, state: 'over' }), [], (id) => id)).toContain('ended');
    expect(grantText(grant({ until, state: 'toCome' }), [], (id) => id)).toContain('from');
  });
});

describe('the holders of grants', () => {
  it('are those who are bound, then those whose grants bind nothing', () => {
    const holders = holdersOf([user('ann'), user('bob', true), user('eve')], [CREW], [grant()]);
    expect(holders.map((one) => one.name)).toEqual(['Crew (group)', 'bob', 'ann']);
    expect(holders[2]?.grants).toHaveLength(1);
    expect(holders[0]?.grants).toHaveLength(0);
  });
});
