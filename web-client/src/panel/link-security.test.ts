import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { Problem } from '../api/problem';
import type { LinkSecurity } from '../api/link-security';
import { STATION, Station } from '../state/station.svelte';
import { aDrone } from '../testing';
import LinkSecurityPanel from './LinkSecurity.svelte';

const NONE: LinkSecurity = {
  policy: 'off',
  key: null,
  nextKey: null,
  changing: null,
  safeLink: true,
  messages: { valid: 0, unsigned: 0, badSignature: 0, replayed: 0, tooOld: 0, tooManyStreams: 0 },
};
const USED: LinkSecurity = {
  ...NONE,
  policy: 'required',
  key: { fingerprint: 'abcdef012345', inUse: true },
  safeLink: false,
  messages: { ...NONE.messages, valid: 90, unsigned: 3, replayed: 2 },
};

async function show(security: LinkSecurity): Promise<Station> {
  const station = new Station();
  station.connection.up();
  vi.spyOn(station.rest, 'linkSecurity').mockResolvedValue(security);
  render(LinkSecurityPanel, { props: { drone: aDrone() }, context: new Map([[STATION, station]]) });
  await fireEvent.click(screen.getByRole('button', { name: /Link security/ }));
  await screen.findByLabelText('Accept messages');
  return station;
}

afterEach(cleanup);

describe('link security', () => {
  it('shows a new key this once', async () => {
    const station = await show(NONE);
    const key = { fingerprint: 'abcdef012345', key: '11'.repeat(32) };
    vi.spyOn(station.rest, 'makeLinkKey').mockResolvedValue(key);

    await fireEvent.click(screen.getByRole('button', { name: 'Make a key' }));
    expect(await screen.findByText(key.key)).toBeDefined();

    await fireEvent.click(screen.getByRole('button', { name: /Link security/ }));
    await fireEvent.click(screen.getByRole('button', { name: /Link security/ }));
    expect(screen.queryByText(key.key)).toBeNull();
  });

  it('says what was refused and why', async () => {
    await show(USED);
    expect(screen.getByText(/3 unsigned, 2 sent before/)).toBeDefined();
  });

  it('asks to vouch for a link that others could listen to', async () => {
    await show(USED);
    expect(screen.getByRole('checkbox', { name: /nobody else can listen/ })).toBeDefined();
  });

  it('shows why a policy was refused', async () => {
    const station = await show({ ...NONE, key: { fingerprint: 'abcdef012345', inUse: false } });
    const detail = 'The vehicle was never heard to sign with its key.';
    vi.spyOn(station.rest, 'setLinkPolicy').mockRejectedValue(new Problem({ status: 409, detail }));

    await fireEvent.change(screen.getByLabelText('Accept messages'), { target: { value: 'required' } });
    expect((await screen.findByRole('alert')).textContent).toContain(detail);
  });
});
