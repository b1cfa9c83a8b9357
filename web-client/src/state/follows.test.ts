import { describe, expect, it, vi } from 'vitest';
import { FollowCalls } from '../api/follows';
import { Problem } from '../api/problem';
import { aFollow, aFollowNow, operationsBy } from '../testing';
import { Follows } from './follows.svelte';
import { PendingRequests } from './pending-requests';

describe('follows', () => {
  it('believe no picture of an earlier stage', () => {
    const follows = new Follows(new FollowCalls(operationsBy(vi.fn())));
    follows.apply(aFollow({ state: 'tracking', since: '2026-01-01T12:00:05Z' }));
    follows.apply(aFollow({ state: 'starting', since: '2026-01-01T12:00:00Z' }));
    expect(follows.find('f1')?.state).toBe('tracking');
  });

  it('believe no answer that the stream has overtaken: a note ends within a stage', async () => {
    const waits = aFollow({ state: 'tracking', note: 'Copter 1 waits.' });
    let answer: (body: unknown) => void = () => undefined;
    const call = vi.fn(() => new Promise((resolve) => (answer = resolve)));
    const follows = new Follows(new FollowCalls(operationsBy(call as never)));
    const loading = follows.load();
    follows.apply({ ...waits, note: null });
    answer({ follows: [waits] });
    await loading;
    expect(follows.find('f1')?.note).toBeNull();

    const looking = follows.poll('f1');
    answer(waits);
    await looking;
    expect(follows.find('f1')?.note).toBe('Copter 1 waits.');
  });

  it('take what changes all the time for those that are known', () => {
    const follows = new Follows(new FollowCalls(operationsBy(vi.fn())));
    const now = { ...aFollowNow('2026-01-01T12:00:00Z'), secondsLeft: 300 };
    follows.applyNow('f1', now);
    expect(follows.all).toEqual([]);
    follows.apply(aFollow());
    follows.applyNow('f1', now);
    expect(follows.find('f1')?.now?.secondsLeft).toBe(300);
  });

  it('learn after an outage what ended meanwhile', async () => {
    const call = vi.fn().mockResolvedValue({
      follows: [aFollow({ state: 'over', since: '2026-01-01T12:01:00Z', end: 'It is down.' })],
    });
    const follows = new Follows(new FollowCalls(operationsBy(call)));
    await follows.catchUp();
    expect(call).not.toHaveBeenCalled();
    follows.apply(aFollow({ state: 'tracking' }));
    await follows.catchUp();
    expect(follows.underWay).toEqual([]);
  });
});

describe('what is asked over the stream', () => {
  it('is answered, refused, or given up when the connection is lost', async () => {
    const pending = new PendingRequests<string>();
    const ids: string[] = [];
    const ask = (): Promise<string> | null => pending.request((id) => ids.push(id) > 0);
    const [first, second, third] = [ask(), ask(), ask()];
    pending.resolve(ids[0] ?? '', 'yes');
    await expect(first).resolves.toBe('yes');
    const refusal = { status: 409, detail: 'This follow is over.' };
    expect(pending.reject({ type: 'error', requestId: ids[1] ?? '', problem: refusal })).toBe(true);
    await expect(second).rejects.toThrow('This follow is over.');
    expect(pending.reject({ type: 'error', requestId: 'steer-1', problem: refusal })).toBe(false);
    pending.rejectAll();
    await expect(third).rejects.toBeInstanceOf(Problem);
  });

  it('is not sent without a connection', () => {
    expect(new PendingRequests().request(() => false)).toBeNull();
  });
});
