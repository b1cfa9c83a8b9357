import { describe, expect, it } from 'vitest';
import type { Endpoint } from '../api/endpoints';
import { endpointText } from './endpoint-text';

const QUIET: Endpoint = {
  id: 'e1',
  url: 'udpserver://0.0.0.0:14550',
  transport: 'udp',
  origin: 'added',
  addedBy: 'alice',
  addedAt: null,
  peers: [],
  state: 'open',
  reason: null,
  counts: {
    peers: 1,
    framesIn: 12345,
    framesOut: 67,
    lost: 0,
    brokenBytes: 0,
    droppedIn: 0,
    droppedOut: 0,
    throttled: 0,
    refusedPeers: 0,
    queue: 0,
    kernelDrops: null,
  },
};

describe('the text of an endpoint', () => {
  it('shows what went in and out, and no bad news where there is none', () => {
    expect(endpointText(QUIET)).toBe('1 peer · 12,345 in · 67 out');
  });

  it('shows what was lost on the way', () => {
    const counts = {
      ...QUIET.counts,
      peers: 2,
      lost: 3,
      droppedIn: 1,
      droppedOut: 2,
      throttled: 9,
      kernelDrops: 4,
    };
    expect(endpointText({ ...QUIET, counts })).toBe(
      '2 peers · 12,345 in · 67 out · 3 lost · 3 dropped · 9 throttled · 4 dropped by the system',
    );
  });
});
