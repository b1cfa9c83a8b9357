import { describe, expect, it, vi } from 'vitest';
import type { Control } from '../api/control';
import { Problem } from '../api/problem';
import { aDrone } from '../testing';
import { ControlLeases, HEARTBEAT_MILLISECONDS } from './control-leases.svelte';

type Port = ConstructorParameters<typeof ControlLeases>[0];

function held(change: Partial<Control> = {}): Control {
  return {
    state: 'held',
    holder: 'olga',
    explicit: true,
    since: '2026-01-01T12:00:00Z',
    epoch: 7,
    requests: [],
    ...change,
  };
}

function controls(port: Partial<Port> = {}) {
  const heartbeat = vi.fn(async () => held());
  let now = 10_000;
  const whole: Port = {
    take: async () => held(),
    takeOver: async () => held({ epoch: 8 }),
    release: async () => held({ state: 'free', holder: null }),
    handOver: async () => held({ holder: 'bob' }),
    grant: async () => held({ holder: 'bob' }),
    heartbeat,
    ...port,
  };
  return { controls: new ControlLeases(whole, () => now), heartbeat, later: (ms: number) => (now += ms) };
}

describe('controls', () => {
  it('sends a heartbeat every two seconds for each drone that it keeps, however often it is asked', async () => {
    const { controls: mine, heartbeat, later } = controls();
    mine.sendHeartbeats();
    expect(heartbeat).not.toHaveBeenCalled();

    await mine.take('d1');
    for (let i = 0; i < 40; i++) {
      mine.sendHeartbeats();
      later(HEARTBEAT_MILLISECONDS / 10);
    }

    expect(heartbeat).toHaveBeenCalledTimes(4);
    expect(heartbeat).toHaveBeenCalledWith('d1', 7);
  });

  it('goes on under the epoch that the server gives it after a restart', async () => {
    const heartbeat = vi.fn(async () => held({ epoch: 9 }));
    const { controls: mine } = controls({ heartbeat });
    await mine.take('d1');
    mine.sendHeartbeats();

    await vi.waitFor(() => expect(mine.held.get('d1')).toBe(9));
  });

  it('stops when somebody else has control, but not for a lost connection', async () => {
    const answers = [Problem.unreachable(), new Problem({ status: 409, detail: 'bob has had control' })];
    const heartbeat = vi.fn(() => Promise.reject(answers.shift() ?? new Error('asked again')));
    const { controls: mine, later } = controls({ heartbeat });
    await mine.take('d1');
    mine.sendHeartbeats();
    await vi.waitFor(() => expect(heartbeat).toHaveBeenCalledTimes(1));
    expect(mine.held.has('d1')).toBe(true);

    later(HEARTBEAT_MILLISECONDS);
    mine.sendHeartbeats();
    await vi.waitFor(() => expect(mine.held.has('d1')).toBe(false));
    later(HEARTBEAT_MILLISECONDS);
    mine.sendHeartbeats();
    expect(heartbeat).toHaveBeenCalledTimes(2);
  });

  it('shows its own control from that of another window, and from that which came with a command', async () => {
    const { controls: mine } = controls();
    await mine.take('d1');

    expect(mine.leaseState(aDrone(), 'olga')).toBe('free');
    expect(mine.leaseState(aDrone({ control: held() }), 'olga')).toBe('here');
    expect(mine.leaseState(aDrone({ control: held({ epoch: 9 }) }), 'olga')).toBe('elsewhere');
    expect(mine.leaseState(aDrone({ control: held({ explicit: false }) }), 'olga')).toBe('implicit');
    expect(mine.leaseState(aDrone({ control: held() }), 'bob')).toBe('other');
    expect(mine.leaseState(aDrone({ control: held({ state: 'pilot', holder: null }) }), 'olga')).toBe(
      'pilot',
    );
  });

  it('says who has control, and lets supervisors stop what others fly', () => {
    const { controls: mine } = controls();
    const drone = aDrone({ control: held({ holder: 'ann' }) });

    expect(mine.whyNot(drone, 'arm', 'olga', false)).toBe('ann has control.');
    expect(mine.whyNot(drone, 'land', 'olga', false)).toBe('ann has control.');
    expect(mine.whyNot(drone, 'land', 'olga', true)).toBeNull();
    expect(mine.whyNot(drone, 'arm', 'olga', true)).toBe('ann has control.');
    expect(mine.whyNot(drone, 'readParameters', 'olga', false)).toBeNull();
    expect(mine.whyNot(drone, 'arm', 'ann', false)).toBeNull();
    expect(mine.whyNot(aDrone(), 'arm', 'olga', false)).toBeNull();
  });
});
