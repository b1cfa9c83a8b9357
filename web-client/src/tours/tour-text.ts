import type {
  FleetPlan,
  OrderedTour,
  PlanFlight,
  PlanProgress,
  PlanResult,
  PlanStage,
  PlanTour,
  PlanTask,
  PlanWaypoint,
  TourRequest,
} from '../api/plans';
import type { Drone } from '../api/types';
import type { Draft } from '../plan/draft';
import { NO_REQUIREMENTS, type Requirements } from './requirements';
import { counted, distance, fixed, span } from '../ui/format';

/** The number of colours for tours; further tours repeat them. */
export const TOUR_TONES = 6;

export function toneOf(plan: FleetPlan, drone: string): number {
  const at = plan.drones.findIndex((one) => one.id === drone);
  return Math.max(0, at) % TOUR_TONES;
}

export function isUnderWay(plan: FleetPlan): boolean {
  return plan.state === 'queued' || plan.state === 'running';
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
    return 'position or home unknown';
  }
  return (drone.battery?.percent ?? null) === null ? 'battery unknown' : null;
}

/** The gap to the best possible plan, rounded up. */
export function gapText(progress: PlanProgress): string {
  if (progress.unserved > 0) {
    return `${counted(progress.unserved, 'waypoint')} left out.`;
  }
  const percent = Math.ceil(progress.gap * 100);
  return percent === 0
    ? 'This is the best plan there is.'
    : `The best plan there is may be up to ${percent} % better.`;
}

export function stateText(plan: FleetPlan): string {
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

export function flightText(flight: PlanFlight): string {
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
export function waypointsOf(
  draft: Draft | null,
  requirementsAt: (key: number) => Requirements = () => NO_REQUIREMENTS,
): PlanWaypoint[] {
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
            ...requirementFields(requirementsAt(waypoint.key)),
          },
        ],
  );
}

function requirementFields(requirements: Requirements): Partial<PlanWaypoint> {
  const { priority, opens, closes, picture } = requirements;
  const tasks = tasksOf(requirements);
  return {
    ...(priority === null ? {} : { priority }),
    ...(opens === null && closes === null ? {} : { window: { opens, closes } }),
    ...(picture ? { needs: ['takePicture'] } : {}),
    ...(tasks.length === 0 ? {} : { tasks }),
  };
}

/** Servos are moved first, so that what they do is on the photo. */
function tasksOf({ photo, servo, pulse, sensors }: Requirements): PlanTask[] {
  return [
    ...(servo === null || pulse === null ? [] : [{ type: 'servo', output: servo, pulse } as const]),
    ...(photo ? [{ type: 'photo' } as const] : []),
    ...(sensors === null ? [] : [{ type: 'readSensors', seconds: sensors } as const]),
  ];
}

/** One line of a comparison; `better`: whether less of it is here, there, or neither. */
export interface Compared {
  label: string;
  here: string;
  there: string;
  better: 'here' | 'there' | null;
}

const sum = (values: readonly number[]): number => values.reduce((so, value) => so + value, 0);

/** Two finished plans side by side; less is better in every line. */
export function compared(here: PlanResult, there: PlanResult): Compared[] {
  const time = (seconds: number): string => span(Math.round(seconds));
  const lines: [string, (one: PlanResult) => number, (value: number) => string][] = [
    ['left out', (one) => one.unserved.length, (value) => fixed(value)],
    ['all done after', (one) => one.endsSeconds, time],
    ['flying in all', (one) => sum(one.tours.map((tour) => tour.endsSeconds - tour.departsSeconds)), time],
    ['distance in all', (one) => sum(one.tours.map((tour) => tour.distance)), distance],
    [
      'energy in all',
      (one) => sum(one.tours.map((tour) => tour.wattHours)),
      (value) => `${fixed(value, 1)} Wh`,
    ],
    ['drones that fly', (one) => one.tours.length, (value) => fixed(value)],
  ];
  return lines.map(([label, value, words]) => {
    const [a, b] = [value(here), value(there)];
    const same = words(a) === words(b);
    return { label, here: words(a), there: words(b), better: same ? null : a < b ? 'here' : 'there' };
  });
}

/** A name for a plan in a list. */
export function planName(plan: FleetPlan): string {
  const ends = plan.result === null ? '' : `: ${span(Math.round(plan.result.endsSeconds))}`;
  return `${counted(plan.drones.length, 'drone')}, ${counted(plan.waypoints, 'waypoint')}${ends}`;
}

/** The improvements of a plan, as points of a picture 100 wide and 100 high; empty where there are none. */
export function stepsOf(improvements: readonly PlanProgress[], seconds: number): string {
  const whole = improvements.filter((step) => step.unserved === improvements.at(-1)?.unserved);
  const most = Math.max(...whole.map((step) => step.longestSeconds));
  const least = Math.min(...whole.map((step) => step.longestSeconds));
  if (whole.length < 2 || most === least) {
    return '';
  }
  const y = (step: PlanProgress): number => 100 * (1 - (step.longestSeconds - least) / (most - least));
  const x = (step: PlanProgress): number => 100 * Math.min(1, step.seconds / seconds);
  let so = '';
  let before = y(whole[0] as PlanProgress);
  for (const step of whole) {
    so += ` ${fixed(x(step), 1)},${fixed(before, 1)} ${fixed(x(step), 1)},${fixed(y(step), 1)}`;
    before = y(step);
  }
  return `${so} 100,${fixed(before, 1)}`.trim();
}

/** The waypoints of a mission as they are asked about; without an altitude they are taken to lie at the height of home. */
export function tourRequest(drone: string, draft: Draft): TourRequest {
  return {
    drone,
    ending: draft.ending,
    waypoints: draft.waypoints.map((one) => ({
      latitude: one.latitude,
      longitude: one.longitude,
      altitude: one.altitude ?? 0,
      altitudeReference: one.altitudeReference,
      holdSeconds: one.holdSeconds,
    })),
  };
}

/** The result of ordering the waypoints of a mission. */
export function orderText({ before, after, unserved, order }: OrderedTour): string {
  const left =
    unserved.length === 0
      ? ''
      : ` Not to be visited, and put last: ${unserved.map((one) => `waypoint ${one.waypoint} (${one.why})`).join('; ')}.`;
  const same = order.every((number, index) => number === index);
  const gain = same
    ? `This order is a good one already: ${distance(after.distance)}.`
    : `${distance(after.distance)} instead of ${distance(before.distance)}, ` +
      `${span(Math.round(after.seconds))} instead of ${span(Math.round(before.seconds))}. Undo takes it back.`;
  return gain + left;
}
