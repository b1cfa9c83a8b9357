import type {
  PlanWaypointRequest,
  PlanView as FleetPlan,
  TourView as OrderedTour,
  PlanFlightView as PlanFlight,
  PlanObjectiveRequest as PlanObjective,
  PlanRequest,
  TourRequest,
} from './contract';

export type { FleetPlan, OrderedTour, PlanFlight, PlanObjective, PlanRequest, TourRequest };
export type {
  PlanPlaceView as PlanPlace,
  PlanProgressView as PlanProgress,
  PlanResultView as PlanResult,
  PlanStopView as PlanStop,
  PlanTaskRequest as PlanTask,
  PlanTourView as PlanTour,
  PlanUnservedView as PlanUnserved,
} from './contract';

export type PlanState = FleetPlan['state'];

export type PlanStage = PlanFlight['stage'];

/** As the page asks for it. */
export type PlanWaypoint = PlanWaypointRequest & {
  [K in 'id' | 'latitude' | 'longitude' | 'altitude']: NonNullable<PlanWaypointRequest[K]>;
};

export type PlanAim = PlanObjective['kind'];

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
