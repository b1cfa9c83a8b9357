import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { Role } from '../api/accounts';
import type { AuditRecord } from '../api/audit';
import { Problem } from '../api/problem';
import { STATION, Station } from '../state/station.svelte';
import Activity from './Activity.svelte';

function record(sequence: number, more: Partial<AuditRecord> = {}): AuditRecord {
  return {
    sequence,
    at: '2026-03-04T05:06:07Z',
    by: 'ann',
    accessKey: null,
    face: 'page',
    operation: 'takeOff',
    drone: 'd1',
    epoch: 7,
    command: 'c1',
    parameters: 'take off to 20 m',
    outcome: 'succeeded',
    reason: null,
    latencyMillis: 1500,
    hash: 'ab',
    ...more,
  };
}

function show(pages: { records: AuditRecord[]; next: number | null }[], role: Role = 'supervisor') {
  const station = new Station();
  station.session = { name: 'root', role, mustChangePassword: false, organisation: null };
  const page = vi.spyOn(station.rest.audit, 'page');
  for (const one of pages) {
    page.mockResolvedValueOnce(one);
  }
  render(Activity, { context: new Map([[STATION, station]]) });
  return { station, page };
}

afterEach(cleanup);

describe('activity', () => {
  it('shows who did what, and why it was refused', async () => {
    show([
      {
        records: [
          record(2, {
            by: null,
            command: null,
            operation: 'POST /api/v1/users',
            outcome: 'refused',
            reason: 'Sign in.',
          }),
          record(1),
        ],
        next: null,
      },
    ]);
    expect(await screen.findByText('take off to 20 m')).toBeDefined();
    expect(screen.getByText('nobody known')).toBeDefined();
    expect(screen.getByText('POST users')).toBeDefined();
    expect(screen.getByText('Sign in.')).toBeDefined();
    expect(screen.queryByRole('button', { name: 'Show older' })).toBeNull();
  });

  it('looks for what the fields say, goes on, and exports the same', async () => {
    const { page } = show([
      { records: [record(9)], next: null },
      { records: [record(8)], next: 8 },
      { records: [record(3)], next: null },
    ]);
    await screen.findByText(/no. 9/);
    await fireEvent.input(screen.getByLabelText('User'), { target: { value: 'ann' } });
    await fireEvent.input(screen.getByLabelText('Operation'), { target: { value: 'land' } });
    await fireEvent.click(screen.getByRole('button', { name: 'Search' }));
    await screen.findByText(/no. 8/);
    await fireEvent.click(screen.getByRole('button', { name: 'Show older' }));

    await screen.findByText(/no. 3/);
    const wanted = expect.objectContaining({ user: 'ann', operation: 'land' });
    expect(page.mock.calls.slice(1)).toEqual([
      [wanted, null],
      [wanted, 8],
    ]);
    expect(screen.getByRole('link', { name: 'Export as table' }).getAttribute('href')).toBe(
      '/api/v1/audit/file?user=ann&operation=land&form=csv',
    );
  });

  it('says that nothing fits', async () => {
    show([
      { records: [], next: null },
      { records: [], next: null },
    ]);
    expect(await screen.findByText('Nothing has been done here yet.')).toBeDefined();
    await fireEvent.input(screen.getByLabelText('User'), { target: { value: 'nobody' } });
    await fireEvent.click(screen.getByRole('button', { name: 'Search' }));
    expect(await screen.findByText('No records match; widen the filter.')).toBeDefined();
  });

  it('says why it cannot be shown', async () => {
    const station = new Station();
    vi.spyOn(station.rest.audit, 'page').mockRejectedValue(
      new Problem({ status: 403, detail: 'Only a supervisor may do this.' }),
    );
    render(Activity, { context: new Map([[STATION, station]]) });
    expect((await screen.findByRole('alert')).textContent).toBe('Only a supervisor may do this.');
  });

  it('lets administrators verify, and supervisors get a receipt', async () => {
    const { station } = show([{ records: [record(1)], next: null }], 'administrator');
    const verify = vi.spyOn(station.rest.audit, 'verify').mockResolvedValue({
      sound: false,
      records: 4,
      firstBad: 5,
      detail: 'Record 5 is missing.',
    });
    await screen.findByText(/no. 1/);
    await fireEvent.click(screen.getByRole('button', { name: 'Verify all records', hidden: true }));
    expect(await screen.findByText('Record 5 is missing.')).toBeDefined();
    expect(verify).toHaveBeenCalledWith(undefined);
    cleanup();

    show([{ records: [record(1)], next: null }]);
    await screen.findByText(/no. 1/);
    expect(screen.queryByRole('button', { name: 'Verify all records', hidden: true })).toBeNull();
    expect(screen.getByRole('link', { name: 'Get a receipt', hidden: true })).toBeDefined();
  });
});
