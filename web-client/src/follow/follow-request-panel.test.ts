import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { FollowCalls } from '../api/follows';
import { Follows } from '../state/follows.svelte';
import { STATION, Station } from '../state/station.svelte';
import FollowRequestPanel from './FollowRequestPanel.svelte';
import { operationsBy } from '../testing';
import { Phone } from './phone.svelte';

const WALK = 'I am indoors: use a demo walk';
const BACK = 'Use where I am instead';

describe('where the target is', () => {
  const calls = { onlocate: vi.fn(), ondemo: vi.fn(), onask: vi.fn() };
  let phone: Phone;

  beforeEach(() => {
    vi.clearAllMocks();
    vi.stubGlobal('isSecureContext', true);
    phone = new Phone({
      follows: new Follows(new FollowCalls(operationsBy(vi.fn()))),
      sender: () => vi.fn(),
    });
    phone.locating = 'on';
    phone.fix = { at: 0, latitude: 47, longitude: 8, accuracy: 6, speed: null, course: null };
  });
  afterEach(() => {
    cleanup();
    vi.unstubAllGlobals();
  });

  async function press(name: string): Promise<void> {
    const props = { phone, wanted: null, demoPossible: true, ...calls };
    render(FollowRequestPanel, { props, context: new Map([[STATION, new Station()]]) });
    await fireEvent.click(screen.getByRole('button', { name }));
  }

  it('can be a demo walk also where the phone knows it', async () => {
    await press(WALK);
    expect(calls.ondemo).toHaveBeenCalledOnce();
    expect(screen.queryByRole('button', { name: BACK })).toBeNull();
  });

  it('can be a demo walk while the phone looks for it', async () => {
    phone.locating = 'asking';
    phone.fix = null;
    await press(WALK);
    expect(calls.ondemo).toHaveBeenCalledOnce();
  });

  it('can be where the phone is again, after a demo walk', async () => {
    phone.demo = true;
    await press(BACK);
    expect(calls.onlocate).toHaveBeenCalledOnce();
    expect(screen.queryByRole('button', { name: WALK })).toBeNull();
  });
});
