import { cleanup, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { Problem } from '../api/problem';
import { STATION, Station } from '../state/station.svelte';
import SignIn from './SignIn.svelte';

function show(station: Station): void {
  render(SignIn, {
    props: { onpassword: () => undefined, onregister: () => undefined },
    context: new Map([[STATION, station]]),
  });
}

function answering(type: string, detail: string): Station {
  const station = new Station();
  vi.spyOn(station.rest.accounts, 'registrationOptions').mockResolvedValue({
    policy: 'invitation',
    signInWith: null,
  });
  vi.spyOn(station.rest, 'session').mockRejectedValue(new Problem({ status: 401, type, detail }));
  return station;
}

afterEach(cleanup);

describe('sign-in', () => {
  it('says why somebody was signed out who did not wish it', async () => {
    const station = answering('urn:dronemap:problem:session-ended', 'The stored data were restored.');
    await station.resume();
    show(station);
    expect(screen.getByRole('status').textContent).toBe(
      'You were signed out. The stored data were restored.',
    );
  });

  it('says nothing to somebody who comes for the first time', async () => {
    const station = answering('urn:dronemap:problem:not-signed-in', 'Sign in first.');
    await station.resume();
    show(station);
    expect(screen.queryByRole('status')).toBeNull();
  });

  it('offers to ask for an account only where that is possible', async () => {
    const station = answering('urn:dronemap:problem:not-signed-in', 'Sign in first.');
    show(station);
    await vi.waitFor(() => expect(station.rest.accounts.registrationOptions).toHaveBeenCalled());
    expect(screen.queryByRole('button', { name: /Ask for one/ })).toBeNull();

    cleanup();
    vi.spyOn(station.rest.accounts, 'registrationOptions').mockResolvedValue({
      policy: 'approval',
      signInWith: null,
    });
    show(station);
    expect(await screen.findByRole('button', { name: /Ask for one/ })).toBeTruthy();
  });

  it('offers the provider only where there is one', async () => {
    const station = answering('urn:dronemap:problem:not-signed-in', 'Sign in first.');
    show(station);
    await vi.waitFor(() => expect(station.rest.accounts.registrationOptions).toHaveBeenCalled());
    expect(screen.queryByRole('link', { name: /Sign in with/ })).toBeNull();

    cleanup();
    vi.spyOn(station.rest.accounts, 'registrationOptions').mockResolvedValue({
      policy: 'off',
      signInWith: 'Fleet login',
    });
    show(station);
    const link = await screen.findByRole('link', { name: 'Sign in with Fleet login' });
    expect(link.getAttribute('href')).toBe('/api/v1/session/oidc');
  });
});
