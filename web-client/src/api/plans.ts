import type {
  PlanWaypointRequest,
  PlanView as FleetPlan,
  TourView as OrderedTour,
  PlanFlightView as PlanFlight,
  PlanObjectiveRequest as PlanObjective,
  PlanRequest,
  TourRequest,
  RestOperations,
} from '@dronemap/client';

export type { FleetPlan, OrderedTour, PlanFlight, PlanObjective, PlanRequest, TourRequest };
export type {
  PlanPlaceView as PlanPlace,
  PlanProgressView as PlanProgress,
  PlanResultView as PlanResult,
  PlanStopView as PlanStop,
  PlanTaskRequest as PlanTask,
  PlanTourView as PlanTour,
  PlanUnservedView as PlanUnserved,
} from '@dronemap/client';

export type PlanState = FleetPlan['state'];

export type PlanStage = PlanFlight['stage'];

/** As the page asks for it. */
export type PlanWaypoint = PlanWaypointRequest & {
  [K in 'id' | 'latitude' | 'longitude' | 'altitude']: NonNullable<PlanWaypointRequest[K]>;
};

export type PlanAim = PlanObjective['kind'];

/** The calls around plans for several drones. */
export class PlanCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  ask(request: PlanRequest): Promise<FleetPlan> {
    return this.#rest.makePlan(request);
  }

  accept(id: string, start: boolean): Promise<FleetPlan> {
    return this.#rest.acceptPlan({ id }, { start });
  }

  one(id: string): Promise<FleetPlan> {
    return this.#rest.getPlan({ id });
  }

  /** Nobody else of it is started. */
  stop(id: string): Promise<FleetPlan> {
    return this.#rest.stopPlan({ id });
  }

  order(request: TourRequest): Promise<OrderedTour> {
    return this.#rest.orderTour(request);
  }

  remove(id: string): Promise<void> {
    return this.#rest.removePlan({ id });
  }
}
