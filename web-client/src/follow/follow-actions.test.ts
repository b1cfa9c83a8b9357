import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { FollowCalls, type FollowStage } from '../api/follows';
import { Follows } from '../state/follows.svelte';
import { aFollow, operationsBy } from '../testing';
import { Phone } from './phone.svelte';
import FollowActions from './FollowActions.svelte';

afterEach(cleanup);

function show(state: FollowStage): { phone: Phone; rerender: (state: FollowStage) => Promise<void> } {
  const phone = new Phone({
    follows: new Follows(new FollowCalls(operationsBy(vi.fn()))),
    sender: () => vi.fn(),
  });
  vi.spyOn(phone, 'act').mockResolvedValue();
  const shown = render(FollowActions, { props: { phone, follow: aFollow({ state }) } });
  return { phone, rerender: (next) => shown.rerender({ phone, follow: aFollow({ state: next }) }) };
}

const press = async (name: string): Promise<void> => {
  const button = screen.getByRole('button', { name });
  await fireEvent.pointerDown(button);
  await fireEvent.click(button, { detail: 1 });
};

describe('the buttons of a follow', () => {
  it('do what was pressed', async () => {
    const { phone } = show('tracking');
    await press('Pause');
    expect(phone.act).toHaveBeenCalledWith('pause');
  });

  it('take no tap from a finger that went down on another one', async () => {
    const { phone, rerender } = show('allocated');
    await fireEvent.pointerDown(screen.getByRole('button', { name: 'Start' }));
    await rerender('starting');
    await fireEvent.click(screen.getByRole('button', { name: 'Cancel' }), { detail: 1 });
    expect(phone.act).not.toHaveBeenCalled();
    await press('Cancel');
    expect(phone.act).toHaveBeenCalledWith('cancel');
  });

  it('can be pressed by keyboard', async () => {
    const { phone } = show('tracking');
    await fireEvent.click(screen.getByRole('button', { name: 'Pause' }), { detail: 0 });
    expect(phone.act).toHaveBeenCalledWith('pause');
  });

  it('are none on the way home', () => {
    show('returning');
    expect(screen.queryAllByRole('button')).toEqual([]);
  });
});
