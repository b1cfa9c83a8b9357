import { cleanup, fireEvent, render, screen, within } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { User } from '../api/accounts';
import { Problem } from '../api/problem';
import { STATION, Station } from '../state/station.svelte';
import Users from './Users.svelte';

function user(name: string, more: Partial<User> = {}): User {
  return { name, role: 'operator', state: 'active', mustChangePassword: false, onlyGranted: false, ...more };
}

function show(list: User[]): Station {
  const station = new Station();
  station.session = { name: 'root', role: 'administrator', mustChangePassword: false, organisation: null };
  vi.spyOn(station.rest.accounts, 'users').mockResolvedValue(list);
  render(Users, { context: new Map([[STATION, station]]) });
  return station;
}

afterEach(cleanup);

describe('users', () => {
  it('shows who waits first, and lets them in', async () => {
    const station = show([user('ann'), user('carol', { role: 'viewer', state: 'waiting' })]);
    const change = vi.spyOn(station.rest.accounts, 'change').mockResolvedValue(user('carol'));
    await screen.findByText('carol', { selector: 'strong' });
    const [first] = screen.getAllByRole('listitem');
    expect(first?.textContent).toContain('waits for approval');

    await fireEvent.click(screen.getByRole('button', { name: /Approve/ }));

    expect(change).toHaveBeenCalledWith('carol', { state: 'active' });
  });

  it('changes a role and says why when that is refused', async () => {
    const station = show([user('ann')]);
    const change = vi
      .spyOn(station.rest.accounts, 'change')
      .mockRejectedValue(new Problem({ status: 403, detail: 'You are no longer an administrator.' }));
    const select = await screen.findByRole('combobox', { name: 'Role of ann' });

    await fireEvent.change(select, { target: { value: 'viewer' } });

    expect(change).toHaveBeenCalledWith('ann', { role: 'viewer' });
    expect((await screen.findByRole('alert')).textContent).toBe('You are no longer an administrator.');
  });

  it('shows a one-time password once', async () => {
    const station = show([user('ann')]);
    vi.spyOn(station.rest.accounts, 'resetPassword').mockResolvedValue({
      name: 'ann',
      password: 'abcde-fghij',
    });
    await fireEvent.click(await screen.findByRole('button', { name: 'More for ann' }));

    await fireEvent.click(screen.getByRole('button', { name: 'New one-time password' }));

    expect(await screen.findByText('abcde-fghij')).toBeDefined();
  });

  it('offers nothing against oneself', async () => {
    show([user('root', { role: 'administrator' })]);
    await screen.findByText(/this is you/);
    const row = within(screen.getByRole('list'));
    expect(row.queryByRole('button')).toBeNull();
    expect(row.queryByRole('combobox')).toBeNull();
  });
});
