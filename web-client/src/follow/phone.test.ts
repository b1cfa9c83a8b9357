import { beforeEach, describe, expect, it, vi } from 'vitest';
import { FollowCalls, type Follow } from '../api/follows';
import { Problem } from '../api/problem';
import { Follows } from '../state/follows.svelte';
import { aFollow, aFollowNow, operationsBy } from '../testing';
import { Phone } from './phone.svelte';

const BEGAN = Date.parse('2026-01-01T12:00:00Z');
const tracking = aFollow({
  state: 'tracking',
  since: '2026-01-01T12:00:00Z',
  now: aFollowNow('2026-01-01T12:00:00Z'),
});

function following(call: () => Promise<unknown>): { phone: Phone; apply: (follow: Follow) => void } {
  const follows = new Follows(new FollowCalls(operationsBy(call as never)));
  follows.apply(tracking);
  const phone = new Phone({ follows, sender: () => () => Promise.resolve({ upTo: null }) });
  phone.now = BEGAN;
  phone.resume(tracking);
  return { phone, apply: (follow) => follows.apply(follow) };
}

describe('a button that was pressed in vain', () => {
  const lost = (): Promise<never> => Promise.reject(Problem.unreachable());
  const refused = (): Promise<never> => Promise.reject(new Problem({ status: 409, detail: 'It is paused.' }));
  const online = (is: boolean): void => void vi.spyOn(navigator, 'onLine', 'get').mockReturnValue(is);

  beforeEach(() => online(true));

  it('did nothing where there is no network, and may have where the cloud does not answer', async () => {
    const { phone } = following(lost);
    online(false);
    await phone.act('stop');
    expect(phone.problem).toContain('“Stop and fly home” was not done: there is no network.');
    online(true);
    await phone.act('pause');
    expect(phone.problem).toContain('whether “Pause” was done');
  });

  it('is shown until the connection is back, but long enough to be read', async () => {
    const { phone } = following(lost);
    await phone.act('stop');
    phone.update(BEGAN + 1_000);
    expect(phone.problem).not.toBeNull();
    const uplink = phone.uplink ?? expect.fail('It has an uplink.');
    uplink.cutOffSince = BEGAN;
    [5_000, 9_000, 13_000].forEach((after) => phone.update(BEGAN + after));
    expect(phone.problem).not.toBeNull();
    uplink.cutOffSince = null;
    phone.update(BEGAN + 14_000);
    expect(phone.problem).toBeNull();
  });

  it('is shown until the next stage, when the cloud refused it', async () => {
    const { phone, apply } = following(refused);
    await phone.act('pause');
    [4_000, 8_000, 12_000].forEach((after) => phone.update(BEGAN + after));
    expect(phone.problem).toBe('It is paused.');
    apply({ ...tracking, state: 'paused', since: '2026-01-01T12:00:13Z' });
    phone.update(BEGAN + 13_000);
    expect(phone.problem).toBeNull();
  });
});
