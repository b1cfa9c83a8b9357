import type { Ending } from '../plan/draft';
import type { AltitudeReference } from './types';

export type PlanState = 'queued' | 'running' | 'finished' | 'cancelled' | 'failed';

/** How good a plan is; `gap`: a share of its own cost by which the best plan there is may at most be better. */
export interface PlanProgress {
  seconds: number;
  longestSeconds: number;
  sum: number;
  unserved: number;
  gap: number;
  iterations: number;
}

export interface PlanPlace {
  latitude: number;
  longitude: number;
  altitudeAmsl: number;
}

export interface PlanStop extends PlanPlace {
  waypoint: string;
  arrivesSeconds: number;
  via: PlanPlace[];
}

/** What one drone flies; seconds after the start of the plan, metres over the ground. */
export interface PlanTour {
  drone: string;
  name: string;
  departsSeconds: number;
  endsSeconds: number;
  distance: number;
  wattHours: number;
  batteryShare: number | null;
  stops: PlanStop[];
  back: PlanPlace[];
}

/** What nobody visits, and why. */
export interface PlanUnserved {
  waypoint: string;
  why: string;
  place: PlanPlace;
}

export interface PlanResult {
  endsSeconds: number;
  tours: PlanTour[];
  unserved: PlanUnserved[];
  faults: string[];
  assumed: boolean;
}

export type PlanStage =
  'uploading' | 'uploaded' | 'waiting' | 'arming' | 'starting' | 'started' | 'heldBack' | 'failed';

export interface PlanFlight {
  drone: string;
  name: string;
  stage: PlanStage;
  why: string | null;
  command: string | null;
}

/** A plan for several drones. Lists leave `orders`, `improvements` and `result` out. */
export interface FleetPlan {
  id: string;
  state: PlanState;
  why: string | null;
  seconds: number;
  drones: { id: string; name: string }[];
  waypoints: number;
  progress: PlanProgress | null;
  improvements: PlanProgress[] | null;
  orders: { drone: string; waypoints: string[] }[] | null;
  result: PlanResult | null;
  launch: { underWay: boolean; drones: PlanFlight[] } | null;
}

export type PlanAim = 'earliestEnd' | 'leastTime' | 'leastDistance' | 'leastEnergy' | 'weighted';

export interface PlanWaypoint {
  id: string;
  latitude: number;
  longitude: number;
  altitude: number;
  altitudeReference: AltitudeReference;
  holdSeconds: number | null;
  priority?: number;
  window?: { opens: number | null; closes: number | null };
  needs?: string[];
  tasks?: PlanTask[];
}

/** What is done at a waypoint, in order. */
export type PlanTask =
  | { type: 'photo' }
  | { type: 'servo'; output: number; pulse: number }
  | { type: 'readSensors'; seconds: number };

export interface PlanObjective {
  kind: PlanAim;
  longestWeight?: number;
  sumWeight?: number;
  everyDrone?: boolean;
}

export interface PlanRequest {
  drones: readonly string[];
  waypoints: readonly PlanWaypoint[];
  objective: PlanObjective;
  seconds: number;
  wind?: { speed: number; from: number };
}

export interface TourRequest {
  drone: string;
  waypoints: readonly Omit<PlanWaypoint, 'id'>[];
  ending: Ending;
}

/** A good order of one drone's waypoints, by their numbers in the request, from 0. */
export interface OrderedTour {
  order: number[];
  before: { seconds: number; distance: number };
  after: { seconds: number; distance: number };
  gap: number;
  unserved: PlanUnserved[];
}

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls around plans for several drones. */
export class PlanCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  ask(request: PlanRequest): Promise<FleetPlan> {
    return this.#call('POST', '/plans', request);
  }

  accept(id: string, start: boolean): Promise<FleetPlan> {
    return this.#call('POST', `${one(id)}/accept`, { start });
  }

  one(id: string): Promise<FleetPlan> {
    return this.#call('GET', one(id));
  }

  /** Nobody else of it is started. */
  stop(id: string): Promise<FleetPlan> {
    return this.#call('POST', `${one(id)}/stop`);
  }

  order(request: TourRequest): Promise<OrderedTour> {
    return this.#call('POST', '/tours', request);
  }

  remove(id: string): Promise<void> {
    return this.#call('DELETE', one(id));
  }
}

function one(id: string): string {
  return `/plans/${encodeURIComponent(id)}`;
}
