import { describe, expect, it } from 'vitest';
import { mayAct, ROLES } from './accounts';

describe('roles', () => {
  it('each may do all that the ones before it may', () => {
    for (const [index, role] of ROLES.entries()) {
      for (const [other, needed] of ROLES.entries()) {
        expect(mayAct(role, needed)).toBe(index >= other);
      }
    }
  });

  it('nobody may nothing', () => {
    expect(mayAct(undefined, 'reporter')).toBe(false);
  });
});
