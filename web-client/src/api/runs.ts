import type { AltitudeReference, CloudLoss } from './types';
import type { Zone } from './zones';

export type RunWaypointState = 'waiting' | 'assigned' | 'reserved' | 'visited' | 'unserved' | 'cancelled';

export type RunStage =
  | 'landed'
  | 'uploading'
  | 'ready'
  | 'arming'
  | 'starting'
  | 'flying'
  | 'holding'
  | 'replacing'
  | 'continuing'
  | 'resuming'
  | 'returning'
  | 'silent'
  | 'suspended'
  | 'crashed'
  | 'gone'
  | 'left';

/** One drone of a run; `next`: the waypoints that it is to visit, in order. */
export interface RunDrone {
  id: string;
  name: string;
  stage: RunStage;
  since: string;
  note: string | null;
  next: string[];
  visited: number;
  due: string | null;
}

export interface RunWaypoint {
  id: string;
  latitude: number;
  longitude: number;
  altitudeAmsl: number;
  state: RunWaypointState;
  drone: string | null;
  /** Why nobody visits it. */
  why: string | null;
  due: string | null;
  visits: { drone: string; at: string }[];
  tasks: RunTask[];
}

export type TaskType = 'photo' | 'servo' | 'lookAt' | 'readSensors';

/** What is done at a waypoint, and what became of it. */
export interface RunTask {
  type: TaskType;
  /** notKnown: a drone was told to, and nothing shows what came of it. */
  result: 'open' | 'underWay' | 'done' | 'notKnown' | 'notAvailable';
  drone: string | null;
  at: string | null;
  photo: number | null;
  words: string | null;
}

/** A waypoint that is another drone's now; null: nobody's. */
export interface Moved {
  waypoint: string;
  from: string | null;
  to: string | null;
}

/** What a plan comes to. */
export interface Figures {
  longestSeconds: number;
  cost: number;
  unserved: number;
}

/** A changed plan that waits for an answer. */
export interface RunProposal {
  number: number;
  at: string;
  words: string;
  moved: Moved[];
  before: Figures;
  after: Figures;
}

/** One decision, and why. */
export interface RunExplanation {
  number: number;
  at: string;
  trigger: string;
  drone: string | null;
  moved: Moved[];
  before: Figures | null;
  after: Figures | null;
  words: string;
}

export interface Barrier extends Pick<Zone, 'type' | 'geometry'> {
  properties: Pick<
    Zone['properties'],
    'name' | 'kind' | 'radius' | 'floor' | 'ceiling' | 'altitudeReference'
  >;
}

/** A plan that the cloud has drones fly, as it stands. */
export interface MissionRun {
  id: string;
  name: string;
  owner: string;
  beganAt: string;
  endedAt: string | null;
  state: 'running' | 'paused' | 'stopping' | 'over';
  end: string | null;
  mode: RunMode;
  onCloudLoss: CloudLoss;
  counts: {
    waypoints: number;
    visited: number;
    unserved: number;
    cancelled: number;
    replans: number;
    doubles: number;
  };
  drones: RunDrone[];
  waypoints: RunWaypoint[];
  /** What its drones keep to: the cloud's zones in reach, and what was added to the run alone. */
  barriers: Barrier[];
  proposal: RunProposal | null;
  explanations: RunExplanation[];
  /** The number of the newest entry of its journal. */
  journal: number;
}

export type RunMode = 'automatic' | 'askFirst';

export interface RunStart {
  plan: string;
  mode: RunMode;
  onCloudLoss: CloudLoss;
  name?: string;
}

export interface NewRunWaypoint {
  latitude: number;
  longitude: number;
  altitude: number;
  altitudeReference: AltitudeReference;
}

/** Whether a journal bears itself out; `number`: the first entry that is decided on otherwise. */
export interface Replay {
  same: boolean;
  entries: number;
  number: number | null;
  written: string | null;
  decided: string | null;
}

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls around mission runs; each wish answers with how the run stands then. */
export class RunCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async all(): Promise<MissionRun[]> {
    return (await this.#call<{ runs: MissionRun[] }>('GET', '/runs')).runs;
  }

  one(id: string): Promise<MissionRun> {
    return this.#call('GET', path(id));
  }

  start(request: RunStart): Promise<MissionRun> {
    return this.#call('POST', '/runs', request);
  }

  add(id: string, waypoints: readonly NewRunWaypoint[]): Promise<MissionRun> {
    return this.#call('POST', path(id, 'waypoints'), { waypoints });
  }

  /** It keeps its height. */
  move(id: string, waypoint: string, latitude: number, longitude: number): Promise<MissionRun> {
    return this.#call('PATCH', path(id, 'waypoints', waypoint), { latitude, longitude });
  }

  cancel(id: string, waypoint: string): Promise<MissionRun> {
    return this.#call('DELETE', path(id, 'waypoints', waypoint));
  }

  join(id: string, drone: string): Promise<MissionRun> {
    return this.#call('POST', path(id, 'drones'), { drone });
  }

  resume(id: string, drone: string): Promise<MissionRun> {
    return this.#call('POST', path(id, 'drones', drone, 'resume'));
  }

  giveUp(id: string, drone: string): Promise<MissionRun> {
    return this.#call('POST', path(id, 'drones', drone, 'give-up'));
  }

  answer(id: string, proposal: number, accept: boolean): Promise<MissionRun> {
    return this.#call('POST', path(id, 'answers', String(proposal)), { accept });
  }

  pause(id: string): Promise<MissionRun> {
    return this.#call('POST', path(id, 'pause'));
  }

  goOn(id: string): Promise<MissionRun> {
    return this.#call('POST', path(id, 'continue'));
  }

  stop(id: string): Promise<MissionRun> {
    return this.#call('POST', path(id, 'stop'));
  }

  replay(id: string): Promise<Replay> {
    return this.#call('GET', path(id, 'journal', 'replay'));
  }
}

function path(...parts: string[]): string {
  return ['/runs', ...parts.map(encodeURIComponent)].join('/');
}
