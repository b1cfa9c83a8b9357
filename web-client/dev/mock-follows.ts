// The follows of the mock server: a drone comes to whoever says where it is, and waits when nobody does.
import { randomUUID } from 'node:crypto';
import type {
  Follow,
  FollowOrder,
  FollowStage,
  PhoneReach,
  PlaceChange,
  Positions,
} from '../src/api/follows';
import type { FollowReceipt } from '@dronemap/client';
import { placeOf } from '../src/fleet/place';
import { distanceMeters } from '../src/geo/distance';
import type { MockDrone } from './mock-drone';
import type { Handler } from './mock-rest';
import { snapshotOf } from './mock-snapshot';
import { Refusal } from './refusal';

const HOLDS_MILLISECONDS = 2_000;
const ASLEEP_MILLISECONDS = 2_500;
const WARN_MILLISECONDS = 3_000;
const PATIENCE_SECONDS = 60;
const USUAL_PLACE: Follow['place'] = { side: 'behind', bearing: null, turn: null, distance: 8, height: 15 };
const REASONS: Record<PhoneReach, string> = {
  speaks: 'The phone does not know where it is: it lets its page find no position.',
  vague: 'The phone knows its place to no better than 50 m.',
  asleep: 'The phone’s page stands still: the screen is off, or something else is in front of it.',
  cut: 'The phone cannot be reached: it has no network.',
  gone: 'The phone’s page was closed, or has crashed.',
};
/** The place after a change; members that are left out stay. */
function placed(was: Follow['place'], change: PlaceChange): Follow['place'] {
  return {
    side: change.side ?? was.side,
    bearing: change.bearing ?? was.bearing,
    turn: change.turn ?? was.turn,
    distance: change.distance ?? was.distance,
    height: change.height ?? was.height,
  };
}

/** The stage after each action, by stage; left out: it is refused. */
const ACTIONS: Record<string, Partial<Record<FollowStage, FollowStage>>> = {
  start: { allocated: 'starting' },
  cancel: { allocated: 'over', starting: 'returning' },
  pause: { tracking: 'paused' },
  continue: { paused: 'starting', suspended: 'starting' },
  stop: { starting: 'returning', tracking: 'returning', paused: 'returning', suspended: 'over' },
};

/** The parts of the server that follows need. */
export interface FollowPorts {
  drones: readonly MockDrone[];
  /** Who is signed in. */
  owner: () => string;
  broadcast: (message: unknown) => void;
}

/** Plays the wire contract of follows just truly enough to develop the pages against. */
export class MockFollows {
  #all: Follow[] = [];
  #reportedAt = 0;
  #positionAt = 0;
  /** The connection of the phone is closed. */
  #gone = false;
  readonly #ports: FollowPorts;

  constructor(ports: FollowPorts) {
    this.#ports = ports;
  }

  readonly handlers: Record<string, Handler> = {
    listFollows: () => ({ follows: this.#all }),
    getFollow: (_, id) => this.#find(id),
    openFollow: (body: FollowOrder) => this.#open(body),
    changeFollow: (body: PlaceChange, id) => {
      const follow = this.#find(id);
      return this.#put({ ...follow, place: placed(follow.place, body) });
    },
    reportFollowPositions: (body: Positions, id) => this.receive(id, body),
    ...Object.fromEntries(
      Object.keys(ACTIONS).map((action) => [
        `${action}Follow`,
        ((_, id) => this.#act(action, id)) satisfies Handler,
      ]),
    ),
  };

  get underWay(): Follow[] {
    return this.#all.filter(({ state }) => state !== 'over');
  }

  /** Receives positions, by REST or on the stream. */
  receive(id: string, { positions }: Positions): FollowReceipt {
    const follow = this.#find(id);
    if (follow.state === 'over') {
      throw new Refusal(409, 'operation-over', 'This follow is over.', { parameters: { id } });
    }
    this.#reportedAt = Date.now();
    this.#gone = false;
    const receivedAt = new Date().toISOString();
    const newest = positions.at(-1);
    if (newest === undefined || follow.now === null) {
      return { at: receivedAt, follow: id, taken: 0, known: 0, upTo: null };
    }
    this.#positionAt = this.#reportedAt;
    const { latitude, longitude } = newest;
    const accuracy = newest.accuracy ?? 10;
    const phone = { at: { latitude, longitude }, accuracy, id: Date.parse(newest.at), heard: receivedAt };
    this.#publish({ ...follow, now: { ...follow.now, phone } });
    return { at: receivedAt, follow: id, taken: positions.length, known: 0, upTo: phone.id };
  }

  /** The connection of the phone has ended. */
  left(): void {
    this.#gone = true;
  }

  /** Four times a second. */
  step(): void {
    this.underWay.forEach((follow) => this.#step(follow));
  }

  #step(before: Follow): void {
    const drone = this.#drone(before);
    const droneAt = placeOf(snapshotOf(drone));
    const phone = before.now?.phone ?? null;
    const follow: Follow = {
      ...before,
      now: {
        droneAt,
        height: drone.up,
        distance: phone === null || droneAt === null ? null : distanceMeters(droneAt, phone.at),
        battery: Math.round(drone.battery),
        secondsLeft: Math.max(0, Math.round((drone.battery - 25) * 12)),
        phone,
        reach: this.#reach(),
      },
    };
    this.#publish(follow);
    if (follow.state === 'starting' && drone.up > follow.place.height - 1) {
      this.#to(follow, 'tracking', `${follow.droneName} is in the air and follows.`);
    } else if (follow.state === 'tracking') {
      this.#guide(follow, drone);
    } else if (follow.state === 'returning' && !drone.armed) {
      this.#to(follow, 'over', `${follow.droneName} is down; it is over.`);
    }
  }

  #guide(follow: Follow, drone: MockDrone): void {
    const silent = Date.now() - Math.max(this.#positionAt, Date.parse(follow.since));
    const target = follow.now?.phone?.at;
    if (silent < HOLDS_MILLISECONDS && target !== undefined) {
      const { north, east } = drone.local(target);
      drone.goal = { north: north - follow.place.distance, east, up: follow.place.height };
    } else {
      drone.goal = { north: drone.north, east: drone.east, up: drone.up };
    }
    if (silent > PATIENCE_SECONDS * 1000) {
      drone.act({ type: 'returnToLaunch' });
      const words = `The phone has said nothing for ${PATIENCE_SECONDS} s; ${follow.droneName} flies home.`;
      this.#to(follow, 'returning', words);
    } else if (silent > WARN_MILLISECONDS) {
      const words = `${REASONS[this.#reach()]} ${follow.droneName} waits, and flies home ${PATIENCE_SECONDS} s after the last position.`;
      if (follow.note !== words) {
        this.#put({ ...withEvent(follow, words), note: words });
      }
    } else if (follow.note !== null) {
      this.#put({ ...withEvent(follow, 'The phone says again where it is.'), note: null });
    }
  }

  #reach(): PhoneReach {
    if (this.#gone) {
      return 'gone';
    }
    return Date.now() - this.#reportedAt < ASLEEP_MILLISECONDS ? 'speaks' : 'asleep';
  }

  #open({ drone: wanted, name, place }: FollowOrder): Follow {
    const drone =
      this.#ports.drones.find(({ beginning }) => beginning.id === wanted) ?? this.#ports.drones[0];
    if (drone === undefined) {
      throw new Refusal(409, 'no-drone-to-follow', 'No drone waits in the warehouse.');
    }
    const at = new Date().toISOString();
    const follow: Follow = {
      id: randomUUID(),
      name: name ?? 'Follow',
      owner: this.#ports.owner(),
      beganAt: at,
      endedAt: null,
      state: 'allocated',
      since: at,
      note: null,
      end: null,
      drone: drone.beginning.id,
      droneName: drone.beginning.name,
      place: placed(USUAL_PLACE, place ?? {}),
      patience: PATIENCE_SECONDS,
      others: [],
      told: [{ at, words: `${drone.beginning.name} was chosen: it is the nearest one.` }],
      now: null,
    };
    this.#step(follow);
    return this.#find(follow.id);
  }

  #act(action: string, id: string): Follow {
    const follow = this.#find(id);
    const next = ACTIONS[action]?.[follow.state];
    if (next === undefined) {
      throw new Refusal(409, 'operation-state', `It is ${follow.state}: it takes no “${action}” now.`);
    }
    const drone = this.#drone(follow);
    if (next === 'starting') {
      drone.act({ type: 'arm' });
      drone.act({ type: 'takeOff', altitude: follow.place.height });
    } else if (next === 'returning') {
      drone.act({ type: 'returnToLaunch' });
    } else if (next === 'paused') {
      drone.goal = { north: drone.north, east: drone.east, up: drone.up };
    }
    return this.#to(follow, next, `${follow.owner} requested it: ${action}.`);
  }

  #to(follow: Follow, state: FollowStage, words: string): Follow {
    const at = new Date().toISOString();
    const over = state === 'over' ? { end: words, endedAt: at, now: null } : {};
    return this.#put({ ...withEvent(follow, words), state, since: at, note: null, ...over });
  }

  #put(follow: Follow): Follow {
    this.#all = [follow, ...this.#all.filter(({ id }) => id !== follow.id)];
    this.#ports.broadcast({ type: 'follow', follow });
    return follow;
  }

  /** Sends the part of a follow that changes all the time. */
  #publish(follow: Follow): void {
    if (this.#all.some(({ id }) => id === follow.id)) {
      this.#all = this.#all.map((one) => (one.id === follow.id ? follow : one));
      this.#ports.broadcast({ type: 'followNow', id: follow.id, now: follow.now });
    } else {
      this.#put(follow);
    }
  }

  #find(id: string): Follow {
    const follow = this.#all.find((one) => one.id === id);
    if (follow === undefined) {
      throw new Refusal(404, 'follow-unknown', `There is no follow ${id}.`, { parameters: { id } });
    }
    return follow;
  }

  #drone(follow: Follow): MockDrone {
    const drone = this.#ports.drones.find(({ beginning }) => beginning.id === follow.drone);
    if (drone === undefined) {
      throw new Refusal(404, 'drone-unknown', `There is no drone ${follow.drone}.`, {
        parameters: { drone: follow.drone },
      });
    }
    return drone;
  }
}

function withEvent(follow: Follow, words: string): Follow {
  return { ...follow, told: [...follow.told, { at: new Date().toISOString(), words }].slice(-30) };
}
