import { cleanup, fireEvent, render, screen, within } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { User } from '../api/accounts';
import { STATION, Station } from '../state/station.svelte';
import Administration from './Administration.svelte';

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

const user = (name: string): User => ({
  name,
  role: 'operator',
  state: 'active',
  mustChangePassword: false,
  onlyGranted: false,
});

describe('the administration', () => {
  it('offers a user who was added a moment ago in every list of users', async () => {
    vi.stubGlobal('fetch', () => Promise.reject(new Error('no server here')));
    const station = new Station();
    station.session = { name: 'root', role: 'administrator', mustChangePassword: false, organisation: null };
    station.connection.up();
    const kept = [user('root'), user('ann')];
    vi.spyOn(station.rest.accounts, 'users').mockImplementation(() => Promise.resolve([...kept]));
    vi.spyOn(station.rest.accounts, 'add').mockImplementation(({ name }) => {
      const added = user(name ?? '');
      kept.push(added);
      return Promise.resolve(added);
    });
    vi.spyOn(station.rest.grants, 'all').mockResolvedValue([]);
    vi.spyOn(station.rest.grants, 'groups').mockResolvedValue([]);
    vi.spyOn(station.rest.grants, 'fleets').mockResolvedValue([]);
    render(Administration, { context: new Map([[STATION, station]]) });
    const users = within(await screen.findByRole('region', { name: 'Users' }));
    await users.findByText('ann', { selector: 'strong' });

    await fireEvent.input(users.getByLabelText('Name of the new user'), { target: { value: 'carol' } });
    await fireEvent.input(users.getByLabelText(/First password/), { target: { value: 'long enough it is' } });
    await fireEvent.click(users.getByRole('button', { name: 'Add user' }));

    await users.findByText('carol', { selector: 'strong' });
    const grants = within(screen.getByRole('region', { name: 'Grants' }));
    expect(await grants.findByRole('option', { name: 'carol' })).toBeDefined();
    const groups = within(screen.getByRole('region', { name: 'Groups' }));
    expect(groups.getByRole('checkbox', { name: 'carol' })).toBeDefined();
  });
});
