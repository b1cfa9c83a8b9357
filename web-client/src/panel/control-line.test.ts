import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { Role } from '../api/accounts';
import type { Control } from '../api/control';
import { Problem } from '../api/problem';
import { STATION, Station } from '../state/station.svelte';
import { aDrone } from '../testing';
import ControlLine from './ControlLine.svelte';

function held(change: Partial<Control> = {}): Control {
  return { state: 'held', holder: 'ann', explicit: true, since: null, epoch: 7, requests: [], ...change };
}

function station(role: Role = 'operator'): Station {
  const made = new Station();
  made.connection.up();
  made.session = { name: 'olga', role, mustChangePassword: false };
  return made;
}

function show(made: Station, control: Control) {
  const props = { drone: aDrone({ control }) };
  return render(ControlLine, { props, context: new Map([[STATION, made]]) });
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

  it('offers viewers nothing to press', () => {
    show(station('viewer'), held());

    expect(screen.queryAllByRole('button')).toHaveLength(0);
  });
});
