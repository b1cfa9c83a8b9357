import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { Problem } from '../api/problem';
import { STATION, Station } from '../state/station.svelte';
import Register from './Register.svelte';

async function fill(invitation: string | null, station: Station): Promise<() => void> {
  const onback = vi.fn();
  render(Register, { props: { invitation, onback }, context: new Map([[STATION, station]]) });
  await fireEvent.input(screen.getByLabelText('User name'), { target: { value: ' carol ' } });
  await fireEvent.input(screen.getByLabelText('Password'), { target: { value: 'long enough' } });
  return onback;
}

afterEach(cleanup);

describe('registration', () => {
  it('says that an administrator decides', async () => {
    const station = new Station();
    const register = vi
      .spyOn(station.rest.accounts, 'register')
      .mockResolvedValue({ name: 'carol', role: 'viewer', state: 'waiting' });
    await fill(null, station);

    await fireEvent.click(screen.getByRole('button', { name: 'Ask for an account' }));

    expect((await screen.findByRole('status')).textContent).toContain(
      'When an administrator has approved it',
    );
    expect(register).toHaveBeenCalledWith('carol', 'long enough', null);
  });

  it('signs in whoever was invited', async () => {
    const station = new Station();
    vi.spyOn(station.rest.accounts, 'register').mockResolvedValue({
      name: 'carol',
      role: 'operator',
      state: 'active',
    });
    const signIn = vi.spyOn(station, 'signIn').mockResolvedValue();
    const onback = await fill('code', station);

    await fireEvent.click(screen.getByRole('button', { name: 'Create account' }));

    await vi.waitFor(() => expect(signIn).toHaveBeenCalledWith('carol', 'long enough'));
    expect(onback).toHaveBeenCalled();
  });

  it('says what is wrong', async () => {
    const station = new Station();
    vi.spyOn(station.rest.accounts, 'register').mockRejectedValue(
      new Problem({ status: 409, detail: 'The name carol is taken; choose another one.' }),
    );
    await fill(null, station);

    await fireEvent.click(screen.getByRole('button', { name: 'Ask for an account' }));

    expect((await screen.findByRole('alert')).textContent).toContain('taken');
  });
});
