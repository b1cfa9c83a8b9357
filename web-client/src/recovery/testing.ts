import type { Recovery, RecoveryPreview } from '../api/recoveries';

/** A drone that comes home with others, for tests. */
export function aRecovery(change: Partial<Recovery> = {}): Recovery {
  return {
    id: 'c1',
    owner: 'ann',
    beganAt: '2026-01-01T11:58:00Z',
    endedAt: null,
    manner: 'return',
    state: 'comingDown',
    since: '2026-01-01T11:58:30Z',
    lowest: 20,
    ceiling: 120,
    drones: [
      {
        drone: 'd1',
        droneName: 'Falcon',
        step: 'level',
        outcome: null,
        note: null,
        waitsFor: ['Kestrel'],
        plan: { latitude: 47.3977, longitude: 8.5456, height: 26, startSeconds: 0, downSeconds: 90 },
      },
    ],
    told: [],
    end: null,
    ...change,
  };
}

/** What would be done with one drone, for tests. */
export function aRecoveryPreview(): RecoveryPreview {
  return {
    manner: 'return',
    lowest: 20,
    ceiling: 120,
    seconds: 90,
    drones: [
      {
        drone: 'd1',
        droneName: 'Falcon',
        fromLatitude: 47.3989,
        fromLongitude: 8.5456,
        plan: { latitude: 47.3977, longitude: 8.5456, height: 26, startSeconds: 0, downSeconds: 90 },
        waitsFor: [],
      },
    ],
    leftOut: [],
  };
}
