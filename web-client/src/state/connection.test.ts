import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Connection } from './connection.svelte';

beforeEach(() => void vi.useFakeTimers({ now: 1_000_000 }));
afterEach(() => void vi.useRealTimers());

describe('the connection', () => {
  it('counts from the last word of the cloud, not from when that was missed', () => {
    const connection = new Connection();
    connection.up();
    connection.received();
    vi.advanceTimersByTime(2_500);
    connection.down();
    expect(connection.secondsDown).toBe(2);
    vi.advanceTimersByTime(5_000);
    connection.refresh();
    expect(connection.secondsDown).toBe(7);
    connection.down();
    expect(connection.secondsDown, 'another failed try changes nothing').toBe(7);
  });

  it('holds what is shown for old until the cloud has spoken again', () => {
    const connection = new Connection();
    expect(connection.stale).toBe(true);
    connection.up();
    expect(connection.stale).toBe(false);
    connection.down();
    expect(connection.stale).toBe(true);
    connection.up();
    expect([connection.stale, connection.secondsDown]).toEqual([false, 0]);
  });

  it('knows nothing of the session before', () => {
    const connection = new Connection();
    connection.received();
    vi.advanceTimersByTime(60_000);
    connection.begin();
    connection.down();
    expect(connection.secondsDown).toBe(0);
  });
});
