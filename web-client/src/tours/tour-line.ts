import type { FleetPlan, PlanFlight, PlanProgress, PlanStage, PlanTour } from '../api/plans';
import type { Drone } from '../api/types';
import type { Draft } from '../plan/draft';
import type { PlanWaypoint } from '../api/plans';
import { counted, distance, fixed, span } from '../ui/format';

/** So many colours there are for tours; further ones begin anew. */
export const TOUR_TONES = 6;

export function toneOf(plan: FleetPlan, drone: string): number {
  const at = plan.drones.findIndex((one) => one.id === drone);
  return Math.max(0, at) % TOUR_TONES;
}

/** Why a drone cannot be planned with now, or null. The cloud looks closer. */
export function whyNotPlanned(drone: Drone): string | null {
  if (drone.replay) {
    return 'a recording';
  }
  if (drone.link.state !== 'live') {
    return 'no contact';
  }
  if (drone.flight !== null && drone.flight !== 'onGround') {
    return 'in the air';
  }
  if (drone.home === null || drone.position === null) {
    return 'its place or home is not known';
  }
  return (drone.battery?.percent ?? null) === null ? 'its battery is not known' : null;
}

/** In plain words, and never better than it is. */
export function gapLine(progress: PlanProgress): string {
  if (progress.unserved > 0) {
    return `${counted(progress.unserved, 'waypoint')} left out.`;
  }
  const percent = Math.ceil(progress.gap * 100);
  return percent === 0
    ? 'This is the best plan there is.'
    : `The best plan there is may be up to ${percent} % better.`;
}

export function stateLine(plan: FleetPlan): string {
  switch (plan.state) {
    case 'queued':
      return 'Waiting for its turn …';
    case 'running':
      return plan.progress === null
        ? 'Looking for a first plan …'
        : `Getting better: all done after ${span(Math.round(plan.progress.longestSeconds))}.`;
    case 'finished':
      return plan.result === null ? '' : `All done after ${span(Math.round(plan.result.endsSeconds))}.`;
    case 'cancelled':
      return 'Cancelled.';
    default:
      return plan.why ?? 'It failed.';
  }
}

const STAGES: Record<PlanStage, string> = {
  uploading: 'mission on its way',
  uploaded: 'mission on board',
  waiting: 'leaves later',
  arming: 'arming',
  starting: 'starting',
  started: 'flying',
  heldBack: 'held back',
  failed: 'failed',
};

export function flightLine(flight: PlanFlight): string {
  return flight.why === null ? STAGES[flight.stage] : `${STAGES[flight.stage]}: ${flight.why}`;
}

export interface Bar {
  label: string;
  value: string;
  /** Of the longest one of all drones, 0 to 1. */
  share: number;
}

/** Time, distance and energy of a tour beside those of the others. */
export function barsOf(tour: PlanTour, all: readonly PlanTour[]): Bar[] {
  const most = (value: (one: PlanTour) => number): number => Math.max(1e-9, ...all.map(value));
  const battery = tour.batteryShare === null ? '' : `, ${fixed(tour.batteryShare * 100)} %`;
  return [
    {
      label: 'time',
      value: span(Math.round(tour.endsSeconds)),
      share: tour.endsSeconds / most((one) => one.endsSeconds),
    },
    {
      label: 'distance',
      value: distance(tour.distance),
      share: tour.distance / most((one) => one.distance),
    },
    {
      label: 'energy',
      value: `${fixed(tour.wattHours, 1)} Wh${battery}`,
      share: tour.wattHours / most((one) => one.wattHours),
    },
  ];
}

/** Of the plan in the editor; take-off and end are the planner's. */
export function waypointsOf(draft: Draft | null): PlanWaypoint[] {
  return (draft?.waypoints ?? []).flatMap((waypoint, index) =>
    waypoint.altitude === null
      ? []
      : [
          {
            id: String(index + 1),
            latitude: waypoint.latitude,
            longitude: waypoint.longitude,
            altitude: waypoint.altitude,
            altitudeReference: waypoint.altitudeReference,
            holdSeconds: waypoint.holdSeconds,
          },
        ],
  );
}
