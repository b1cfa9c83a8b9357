import type { Outlook } from '../src/api/control';
import type { Action, CommandKind, Drone } from '../src/api/types';
import { METERS_PER_DEGREE, type MockDrone } from './mock-drone';

/** A mock vehicle as the wire contract shows it. */
export function snapshotOf(drone: MockDrone): Drone {
  const { beginning } = drone;
  const silence = drone.silentSince === null ? 0 : Date.now() - drone.silentSince;
  const flying = drone.up > 0.3;
  return {
    id: beginning.id,
    name: beginning.name,
    replay: beginning.replay ?? false,
    link: {
      address: '127.0.0.1',
      port: beginning.port,
      systemId: 1,
      transport: 'udp',
      state: silence > 5000 ? 'lost' : silence > 1500 ? 'suspect' : 'live',
      lastHeard: new Date(drone.lastHeard).toISOString(),
      quality: {
        lossShort: 0.04 * (1 + Math.sin(Date.now() / 12_000)),
        lossLong: 0.04,
        rttMs: 42,
        rttLongMs: 40,
        jitterMs: 6,
        jitterLongMs: 5,
      },
      trend: { state: 'unknown', secondsLeft: null, sentence: 'How this link usually is, is not known yet.' },
      others: [],
      outdated: [],
    },
    identity: { evidence: 'address', proved: false, hardwareId: null },
    kind: beginning.kind,
    autopilot: 'ArduPilot',
    vehicle: beginning.vehicle,
    firmware: '4.5.6',
    mode: drone.mode,
    modes: ['STABILIZE', 'ALT_HOLD', 'LOITER', 'GUIDED', 'AUTO', 'RTL', 'LAND', 'BRAKE'],
    armed: drone.armed,
    readyToArm: null,
    flight: !flying
      ? 'onGround'
      : drone.mode === 'LAND'
        ? 'landing'
        : drone.climb > 1
          ? 'takingOff'
          : 'inAir',
    position: {
      latitude: beginning.latitude + drone.north / METERS_PER_DEGREE,
      longitude: beginning.longitude + drone.east / METERS_PER_DEGREE / drone.shrink(),
      altitudeAmsl: 488 + drone.up,
      altitudeAboveHome: drone.up,
    },
    local: null,
    sensed: null,
    place: beginning.place,
    motion: { groundSpeed: drone.speed, airSpeed: null, climbRate: drone.climb, heading: drone.heading },
    attitude: { roll: drone.speed * 0.6, pitch: -drone.speed, yaw: drone.heading },
    battery: {
      percent: Math.round(drone.battery),
      volts: 12.6 * (0.8 + drone.battery / 500),
      amps: flying ? 14.2 : 0.4,
      further: [],
    },
    gps: { fix: '3D', satellites: 14, hdop: 0.8 },
    home: { latitude: beginning.latitude, longitude: beginning.longitude, altitudeAmsl: 488 },
    mission: {
      items: drone.items,
      current: drone.current,
      reached: drone.reached,
      total: drone.items?.length ?? null,
      state: null,
      running: drone.mode === 'AUTO',
      notice: null,
      hash: null,
    },
    messages: drone.messages,
    actions: actionsOf(drone),
    control: { state: 'free', holder: null, explicit: false, since: null, epoch: 0, requests: [] },
    cloudLoss: {
      state: 'notSet',
      action: null,
      afterSeconds: null,
      returnHeight: null,
      sentence: 'It is not known what it does when it does not hear the cloud any more.',
      outstanding: [],
    },
    outlook: flying ? outlookOf(drone) : null,
    lastUpdate: new Date(drone.lastHeard).toISOString(),
    version: drone.version,
  };
}

function outlookOf(drone: MockDrone): Outlook {
  const returnsAt = drone.returnsAt();
  const { latitude, longitude } = drone.beginning;
  return {
    state: returnsAt === null ? 'returns' : 'waits',
    then:
      returnsAt === null
        ? 'Nobody has control of it; it is on its way home or down.'
        : 'Nobody has control of it; it is brought home unless somebody takes control.',
    returnsAt: returnsAt === null ? null : new Date(returnsAt).toISOString(),
    latitude,
    longitude,
    comesDown: 'home',
    emptyAt: new Date(Date.now() + drone.battery * 20_000).toISOString(),
  };
}

function actionsOf(drone: MockDrone): Record<CommandKind, Action> {
  const kinds: CommandKind[] = [
    'arm',
    'disarm',
    'setMode',
    'takeOff',
    'land',
    'returnToLaunch',
    'hold',
    'goTo',
    'uploadMission',
    'startMission',
    'pauseMission',
    'clearMission',
  ];
  const action = (why: string | null): Action =>
    why === null
      ? { allowed: true, why, mode: null }
      : { allowed: false, why, code: 'command-refused', mode: null };
  return Object.fromEntries(kinds.map((kind) => [kind, action(drone.why(kind))])) as Record<
    CommandKind,
    Action
  >;
}
