import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { tick } from 'svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { Role } from '../api/accounts';
import type { Control } from '../api/control';
import { Problem } from '../api/problem';
import { STATION, Station } from '../state/station.svelte';
import { aCloudLoss, aDrone, anOutlook } from '../testing';
import ControlLease from './ControlLease.svelte';

function held(change: Partial<Control> = {}): Control {
  return { state: 'held', holder: 'ann', explicit: true, since: null, epoch: 7, requests: [], ...change };
}

function station(role: Role = 'operator'): Station {
  const made = new Station();
  made.connection.up();
  made.session = { name: 'olga', role, mustChangePassword: false, organisation: null };
  return made;
}

function show(made: Station, control: Control) {
  const props = { drone: aDrone({ control }) };
  return render(ControlLease, { props, context: new Map([[STATION, made]]) });
}

afterEach(cleanup);

describe('control line', () => {
  it('takes control that nobody has, and can give it back', async () => {
    const made = station();
    const mine = held({ holder: 'olga' });
    vi.spyOn(made.rest.control, 'take').mockResolvedValue(mine);
    const release = vi.spyOn(made.rest.control, 'release').mockResolvedValue(held({ state: 'free' }));
    const { rerender } = show(made, held({ state: 'free', holder: null, explicit: false }));
    expect(screen.getByText('Nobody has control')).toBeDefined();

    await fireEvent.click(screen.getByRole('button', { name: 'Take control' }));
    await rerender({ drone: aDrone({ control: mine }) });
    expect(screen.getByText('You have control')).toBeDefined();
    await fireEvent.click(screen.getByRole('button', { name: 'Give back' }));

    expect(release).toHaveBeenCalledWith('d1');
  });

  it('asks the holder, and leaves taking over to supervisors who say why', async () => {
    const made = station();
    const request = vi.spyOn(made.rest.control, 'request').mockResolvedValue(held());
    show(made, held());
    expect(screen.getByText('ann has control')).toBeDefined();
    expect(screen.queryByRole('button', { name: 'Take over' })).toBeNull();
    await fireEvent.click(screen.getByRole('button', { name: 'Ask for control' }));
    expect(request).toHaveBeenCalledWith('d1', '');
    cleanup();

    show(station('supervisor'), held());
    await fireEvent.click(screen.getByRole('button', { name: 'Take over' }));
    const take = screen.getByRole('button', { name: 'Take control from ann' });
    expect(take.getAttribute('aria-disabled')).toBe('true');
    await fireEvent.input(screen.getByLabelText('Why you take control from ann'), {
      target: { value: 'smoke' },
    });
    expect(take.getAttribute('aria-disabled')).toBe('false');
  });

  it('shows who asks for control, to grant or refuse', async () => {
    const made = station();
    const grant = vi.spyOn(made.rest.control, 'grant').mockResolvedValue(held());
    const detail = 'bob does not ask for control (any more).';
    vi.spyOn(made.rest.control, 'refuse').mockRejectedValue(new Problem({ status: 409, detail }));
    show(made, held({ holder: 'olga', requests: [{ by: 'bob', reason: 'my survey', at: '' }] }));

    expect(screen.getByText('bob').closest('p')?.textContent).toContain('asks for control: my survey');
    await fireEvent.click(screen.getByRole('button', { name: 'Refuse' }));
    expect(await screen.findByText(detail)).toBeDefined();
    await fireEvent.click(screen.getByRole('button', { name: 'Grant' }));
    expect(grant).toHaveBeenCalledWith('d1', 'bob');
  });

  it('counts down beside the button that stops it, and tells where the drone comes down', async () => {
    const made = station();
    made.clock.now = Date.parse('2026-01-01T12:00:00Z');
    const take = vi.spyOn(made.rest.control, 'take').mockResolvedValue(held({ holder: 'olga' }));
    const nobody = held({ state: 'free', holder: null, explicit: false });
    const drone = aDrone({ control: nobody, outlook: anOutlook() });
    const { rerender } = render(ControlLease, { props: { drone }, context: new Map([[STATION, made]]) });

    expect(screen.getByRole('timer').textContent).toBe('Brought home in 12 s');
    expect(screen.getByText('Brought home within 20 s unless somebody takes control.').role).toBe('status');
    expect(screen.getByText(anOutlook().then)).toBeDefined();
    expect(screen.getByText(/home, 500 m away/)).toBeDefined();
    expect(screen.getByText(/until about .* \(32 min\)/)).toBeDefined();

    made.clock.now += 3000;
    await tick();
    expect(screen.getByRole('timer').textContent).toBe('Brought home in 9 s');
    await fireEvent.click(screen.getByRole('button', { name: 'Take control' }));
    expect(take).toHaveBeenCalledWith('d1');

    await rerender({ drone: aDrone({ control: nobody, outlook: null }) });
    expect(screen.queryByRole('timer')).toBeNull();
    expect(screen.queryByRole('group', { name: 'Outlook' })).toBeNull();
  });

  it('shows what happens when the holder is gone, and counts nothing', () => {
    const then = 'When ann gives no sign for 6 s, it is brought home 30 s later.';
    const sentence = 'When it does not hear the cloud any more, it returns home after 20 s.';
    const outlook = anOutlook({ then, returnsAt: null });
    const drone = aDrone({ control: held(), outlook, cloudLoss: aCloudLoss({ sentence }) });
    render(ControlLease, { props: { drone }, context: new Map([[STATION, station()]]) });

    expect(screen.getByText(then)).toBeDefined();
    expect(screen.getByText(sentence)).toBeDefined();
    expect(screen.queryByRole('timer')).toBeNull();
  });

  it('promises no end of 30 s to whoever flies', () => {
    const mine = held({ holder: 'olga', explicit: false });
    show(station(), mine);
    expect(screen.getByText('You have control · ends 30 s after your last command')).toBeDefined();
    cleanup();

    const drone = aDrone({ control: mine, outlook: anOutlook({ returnsAt: null }) });
    render(ControlLease, { props: { drone }, context: new Map([[STATION, station()]]) });
    expect(screen.getByText('You have control')).toBeDefined();
  });

  it('counts nothing down without a connection', () => {
    const made = station();
    made.connection.down();
    const drone = aDrone({ control: held({ state: 'free' }), outlook: anOutlook() });
    render(ControlLease, { props: { drone }, context: new Map([[STATION, made]]) });

    expect(screen.queryByRole('timer')).toBeNull();
  });

  it('offers viewers nothing to press', () => {
    show(station('viewer'), held());

    expect(screen.queryAllByRole('button')).toHaveLength(0);
  });
});
