import type { Coordinates } from '../geo/coordinates';

export type FollowStage =
  'allocated' | 'starting' | 'tracking' | 'paused' | 'suspended' | 'returning' | 'over';

export type FollowSide = 'behind' | 'ahead' | 'fixed' | 'orbit';

/** Where the drone stays: metres on the ground and above its home, degrees from north, degrees a second. */
export interface FollowPlace {
  side: FollowSide;
  bearing: number | null;
  turn: number | null;
  distance: number;
  height: number;
}

/** A phone that a drone follows, as it stands. */
export interface Follow {
  id: string;
  name: string;
  owner: string;
  beganAt: string;
  endedAt: string | null;
  state: FollowStage;
  since: string;
  note: string | null;
  end: string | null;
  drone: string;
  droneName: string;
  place: FollowPlace;
  /** Seconds without a position before the drone flies home. */
  patience: number;
  /** Oldest first; the first says why this drone was chosen. */
  told: { at: string; words: string }[];
  /** Its other drones. */
  others: FollowOther[];
  /** null: it is over. */
  now: FollowNow | null;
}

/** A drone that comes to replace the one that follows, or that flies home since it was replaced. */
export interface FollowOther {
  drone: string;
  droneName: string;
  state: FollowStage;
  /** On its way to take over. */
  comes: boolean;
}

/** How drone and phone are to each other just now; null where nobody knows. */
export interface FollowNow {
  droneAt: Coordinates | null;
  /** Metres above its home. */
  height: number | null;
  /** Metres on the ground from the drone to where the phone said last that it is. */
  distance: number | null;
  /** Percent. */
  battery: number | null;
  /** Until it has to fly home, as far away as it is. */
  secondsLeft: number | null;
  phone: { at: Coordinates; accuracy: number; id: number; heard: string } | null;
  /** How the phone is reached on the stream; null: it does not speak there. */
  reach: PhoneReach | null;
}

/** asleep: its page stands still; cut: it has no network; gone: its page was closed. */
export type PhoneReach = 'speaks' | 'asleep' | 'cut' | 'gone';

export type PlaceChange = Partial<FollowPlace>;

export interface FollowOrder {
  latitude: number;
  longitude: number;
  name?: string;
  /** Left out: the best one of the warehouse. */
  drone?: string;
  place?: PlaceChange;
  minutes?: number;
}

export interface Positions {
  /** By the phone's own clock, as the times of positions. */
  sent: string;
  /** Milliseconds from sending to the answer, as measured last. */
  roundTrip?: number;
  /** At most 60, oldest first; none: the phone is there, and does not know where it is. */
  positions: {
    at: string;
    latitude: number;
    longitude: number;
    accuracy: number;
    speed?: number;
    course?: number;
  }[];
}

/** What became of positions. */
export interface Receipt {
  /** The id of the newest that is dealt with, the milliseconds of its time; null: none is, say them again. */
  upTo: number | null;
}

/** `longest`: milliseconds until it is given up. */
type Call = <T>(method: string, path: string, body?: unknown, longest?: number) => Promise<T>;

/** A phone between two cells answers nothing for long; by then newer positions wait. */
export const ANSWER_MILLISECONDS = 4_000;

/** The calls around follows; each wish answers with how the follow stands then. */
export class FollowCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async all(): Promise<Follow[]> {
    return (await this.#call<{ follows: Follow[] }>('GET', '/follows')).follows;
  }

  one(id: string): Promise<Follow> {
    return this.#call('GET', path(id), undefined, ANSWER_MILLISECONDS);
  }

  open(order: FollowOrder): Promise<Follow> {
    return this.#call('POST', '/follows', order);
  }

  change(id: string, place: PlaceChange): Promise<Follow> {
    return this.#call('PATCH', path(id), place);
  }

  positions(id: string, positions: Positions): Promise<Receipt> {
    return this.#call('POST', path(id, 'positions'), positions, ANSWER_MILLISECONDS);
  }

  wish(id: string, wish: FollowWish): Promise<Follow> {
    return this.#call('POST', path(id, wish));
  }
}

export type FollowWish = 'start' | 'cancel' | 'pause' | 'continue' | 'stop';

function path(...parts: string[]): string {
  return ['/follows', ...parts.map(encodeURIComponent)].join('/');
}
