import type { RestOperations } from '@dronemap/client';
import type { Outlook, CloudLossState } from './api/control';
import type { Dispatch } from './api/dispatches';
import type { Follow, FollowNow, PhoneReach } from './api/follows';
import type { MissionRun, RunDrone, RunWaypoint } from './api/runs';
import type { Action, Command, Drone, VehicleMission } from './api/types';
import type { Zone } from './api/zones';

/** A drone on the ground in Zürich, for tests. */
export function aDrone(change: Partial<Drone> = {}): Drone {
  return {
    id: 'd1',
    name: 'Copter 1',
    replay: false,
    link: {
      address: '127.0.0.1',
      port: 14601,
      systemId: 1,
      transport: 'udp',
      state: 'live',
      lastHeard: '2026-01-01T12:00:00Z',
      quality: {
        lossShort: null,
        lossLong: null,
        rttMs: null,
        rttLongMs: null,
        jitterMs: null,
        jitterLongMs: null,
      },
      trend: { state: 'unknown', secondsLeft: null, sentence: 'How this link usually is, is not known yet.' },
      others: [],
      outdated: [],
    },
    identity: { evidence: 'address', proved: false, hardwareId: null },
    kind: 'multicopter',
    autopilot: 'ArduPilot',
    vehicle: 'ArduCopter',
    firmware: '4.5.6',
    mode: 'LOITER',
    modes: ['LOITER', 'GUIDED'],
    armed: false,
    readyToArm: null,
    flight: 'onGround',
    position: { latitude: 47.3977, longitude: 8.5456, altitudeAmsl: 488, altitudeAboveHome: 0 },
    local: null,
    sensed: null,
    place: '2 km NE of Zürich, CH',
    motion: { groundSpeed: 0, airSpeed: null, climbRate: 0, heading: 40 },
    attitude: null,
    battery: null,
    gps: null,
    home: { latitude: 47.3977, longitude: 8.5456, altitudeAmsl: 488 },
    mission: aMission(),
    messages: [],
    actions: { arm: anAction(), takeOff: anAction('Arm first.') },
    control: { state: 'free', holder: null, explicit: false, since: null, epoch: 0, requests: [] },
    cloudLoss: aCloudLoss(),
    outlook: null,
    lastUpdate: '2026-01-01T12:00:00Z',
    version: 1,
    ...change,
  };
}

/** An action that is allowed, unless a reason is given. */
export function anAction(why: string | null = null): Action {
  return why === null
    ? { allowed: true, why, mode: null }
    : { allowed: false, why, code: 'command-refused', mode: null };
}

/** The mission of a vehicle that was not read yet. */
export function aMission(change: Partial<VehicleMission> = {}): VehicleMission {
  return {
    items: null,
    current: null,
    reached: [],
    total: null,
    running: false,
    state: null,
    notice: null,
    hash: null,
    ...change,
  };
}

/** Set to come home when it loses the cloud. */
export function aCloudLoss(change: Partial<CloudLossState> = {}): CloudLossState {
  return {
    state: 'set',
    action: 'it returns home',
    afterSeconds: 20,
    returnHeight: null,
    sentence: 'When it does not hear the cloud any more, it returns home after 20 s.',
    outstanding: [],
    ...change,
  };
}

/** Nobody has it, at noon: it is brought home, half a kilometre away, in 12 s, and its battery lasts for 32 min. */
export function anOutlook(change: Partial<Outlook> = {}): Outlook {
  return {
    state: 'waits',
    then: 'Nobody has control of it; it is brought home unless somebody takes control.',
    returnsAt: '2026-01-01T12:00:12Z',
    latitude: 47.4022,
    longitude: 8.5456,
    comesDown: 'home',
    emptyAt: '2026-01-01T12:32:00Z',
    ...change,
  };
}

export function aCommand(change: Partial<Command> = {}): Command {
  return {
    id: 'c1',
    drone: 'd1',
    by: 'alice',
    face: 'rest',
    type: 'arm',
    summary: 'arm',
    at: '2026-01-01T12:00:00Z',
    phase: 'sent',
    outcome: null,
    finishedAt: null,
    progress: null,
    epoch: null,
    warnings: [],
    ...change,
  };
}

export function aRunDrone(id: string, change: Partial<RunDrone> = {}): RunDrone {
  return {
    id,
    name: id === 'd1' ? 'Falcon' : 'Heron',
    stage: 'flying',
    since: '2026-01-01T11:59:00Z',
    note: null,
    next: [],
    visited: 0,
    due: null,
    ...change,
  };
}

export function aRunWaypoint(id: string, change: Partial<RunWaypoint> = {}): RunWaypoint {
  return {
    id,
    latitude: 47 + Number(id) / 10,
    longitude: 8,
    altitudeAmsl: 500,
    state: 'assigned',
    drone: 'd1',
    why: null,
    due: null,
    visits: [],
    tasks: [],
    ...change,
  };
}

/** Two drones and three waypoints, one of each kind. */
export function aRun(change: Partial<MissionRun> = {}): MissionRun {
  return {
    id: 'r1',
    name: 'roofs',
    owner: 'olga',
    beganAt: '2026-01-01T11:58:00Z',
    endedAt: null,
    state: 'running',
    end: null,
    mode: 'automatic',
    onCloudLoss: 'continue',
    counts: { waypoints: 3, visited: 1, unserved: 0, cancelled: 0, replans: 0, doubles: 0 },
    drones: [aRunDrone('d1', { next: ['2'] }), aRunDrone('d2')],
    waypoints: [
      aRunWaypoint('1', { state: 'visited', visits: [{ drone: 'd2', at: '2026-01-01T11:59:30Z' }] }),
      aRunWaypoint('2'),
      aRunWaypoint('3', { state: 'reserved' }),
    ],
    barriers: [],
    proposal: null,
    explanations: [],
    journal: 4,
    ...change,
  };
}

export function aFollow(change: Partial<Follow> = {}): Follow {
  return {
    id: 'f1',
    name: 'Follow',
    owner: 'olga',
    beganAt: '2026-01-01T11:58:00Z',
    endedAt: null,
    state: 'allocated',
    since: '2026-01-01T11:58:00Z',
    note: null,
    end: null,
    drone: 'd1',
    droneName: 'Copter 1',
    place: { side: 'behind', bearing: null, turn: null, distance: 8, height: 15 },
    patience: 60,
    told: [{ at: '2026-01-01T11:58:00Z', words: 'Copter 1 is nearest: 40 m away.' }],
    others: [],
    now: null,
    ...change,
  };
}

/** The drone is 8 m away; the phone said then where it is. */
/** A drone that comes to a place, for tests. */
export function aDispatch(change: Partial<Dispatch> = {}): Dispatch {
  return {
    id: 's1',
    owner: 'ann',
    beganAt: '2026-01-01T11:58:00Z',
    endedAt: null,
    state: 'enRoute',
    since: '2026-01-01T11:58:30Z',
    latitude: 47.3989,
    longitude: 8.5456,
    height: 30,
    note: null,
    end: null,
    drone: 'd1',
    droneName: 'Falcon',
    told: [],
    others: [],
    now: { latitude: 47.3977, longitude: 8.5456, height: 30, distance: 142, seconds: 29, battery: 80 },
    ...change,
  };
}

export function aFollowNow(heard: string, reach: PhoneReach | null = 'speaks'): FollowNow {
  return {
    droneAt: { latitude: 47.3978, longitude: 8.5456 },
    height: 15,
    distance: 8,
    battery: 80,
    secondsLeft: 600,
    phone: { at: { latitude: 47.3979, longitude: 8.5456 }, accuracy: 5, id: 1, heard },
    reach,
  };
}

/** A round zone in a place of no meaning that everybody keeps out of, for tests. */
export function aZone(change: Partial<Zone['properties']> = {}): Zone {
  return {
    type: 'Feature',
    id: 'z1',
    geometry: { type: 'Point', coordinates: [8, 47] },
    properties: {
      name: 'School',
      kind: 'exclusion',
      radius: 100,
      floor: null,
      ceiling: null,
      altitudeReference: 'home',
      user: null,
      drone: null,
      from: null,
      until: null,
      onBreach: 'hold',
      by: 'ann',
      changedAt: '2026-01-01T11:00:00Z',
      ...change,
    },
  };
}

/** Operations that are all answered by one function, told the id of the operation and what it is given. */
export function operationsBy(
  answer: (operation: string, ...given: unknown[]) => Promise<unknown>,
): RestOperations {
  const call =
    (_: object, operation: string) =>
    (...given: unknown[]): Promise<unknown> =>
      answer(operation, ...given);
  return new Proxy({}, { get: call as never }) as RestOperations;
}
