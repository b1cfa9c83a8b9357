import type {
  Figures,
  MissionRun,
  Moved,
  Replay,
  RunDrone,
  RunExplanation,
  RunStage,
  RunTask,
  RunWaypoint,
  RunWaypointState,
  TaskType,
} from '../api/runs';
import type { Drone } from '../api/types';
import { whyNotPlanned } from '../tours/tour-text';
import { counted, span } from '../ui/format';

/** Green: as planned; amber: look; red: act; violet: planned and not yet true; blue: its mission changes. */
export type Tone = 'green' | 'amber' | 'red' | 'violet' | 'blue' | 'neutral';

interface Look {
  words: string;
  tone: Tone;
}

export const WAYPOINT_LOOKS: Record<RunWaypointState, Look & { mark: string }> = {
  visited: { words: 'visited', tone: 'green', mark: '✓' },
  assigned: { words: 'to be visited', tone: 'violet', mark: '' },
  waiting: { words: 'unassigned', tone: 'amber', mark: '…' },
  reserved: { words: 'kept for a silent drone', tone: 'amber', mark: '?' },
  unserved: { words: 'left out', tone: 'red', mark: '✕' },
  cancelled: { words: 'cancelled', tone: 'neutral', mark: '–' },
};

const TASKS: Record<TaskType, string> = {
  photo: 'Photo',
  servo: 'Servo',
  lookAt: 'Look at a place',
  readSensors: 'Read sensors',
};

const RESULTS: Record<RunTask['result'], string> = {
  open: 'not yet',
  underWay: 'under way',
  done: 'done',
  notKnown: 'unknown',
  notAvailable: 'not available',
};

/** "Photo: done. Photo 3 at 47.397700, 8.545600." */
export function taskText(task: RunTask): string {
  const words = task.words === null ? '' : ` ${task.words}`;
  return `${TASKS[task.type] ?? task.type}: ${RESULTS[task.result] ?? task.result}.${words}`;
}

const STAGES: Record<RunStage, Look> = {
  landed: { words: 'on the ground', tone: 'neutral' },
  uploading: { words: 'uploading mission', tone: 'blue' },
  ready: { words: 'ready, waits to leave', tone: 'blue' },
  arming: { words: 'arming', tone: 'blue' },
  starting: { words: 'taking off', tone: 'blue' },
  flying: { words: 'flying', tone: 'green' },
  holding: { words: 'waiting in the air', tone: 'amber' },
  replacing: { words: 'changing mission', tone: 'blue' },
  continuing: { words: 'going on', tone: 'blue' },
  resuming: { words: 'rejoining', tone: 'blue' },
  returning: { words: 'on its way home', tone: 'neutral' },
  silent: { words: 'no contact', tone: 'amber' },
  suspended: { words: 'under other control', tone: 'amber' },
  crashed: { words: 'crashed', tone: 'red' },
  gone: { words: 'lost', tone: 'red' },
  left: { words: 'left the run', tone: 'neutral' },
};

/** A stage that this page does not know yet is shown as it is called. */
export function stageLook(drone: RunDrone): Look {
  if (drone.stage === 'flying' && drone.next.length === 0) {
    return { words: 'finishing', tone: 'green' };
  }
  return STAGES[drone.stage] ?? { words: drone.stage, tone: 'neutral' };
}

const TRIGGERS: Record<RunExplanation['trigger'], string> = {
  start: 'Started',
  takenOver: 'Taken over',
  lost: 'Contact lost',
  heardAgain: 'Contact regained',
  gone: 'Lost',
  crashed: 'Crashed',
  lowBattery: 'Low battery',
  linkFalling: 'Link falling',
  wentHome: 'Returned by itself',
  cameDown: 'Came down',
  removed: 'Removed',
  offPath: 'Off its path',
  late: 'Late',
  commandFailed: 'Command failed',
  waypointsAdded: 'Waypoints added',
  waypointMoved: 'Waypoint moved',
  waypointCancelled: 'Waypoint cancelled',
  fenceAdded: 'Zone added',
  joined: 'Joined',
  resumed: 'Resumed',
  givenUp: 'Taken out',
  tooNear: 'Kept apart',
  betterPlan: 'Better plan',
  answered: 'Answered',
  restarted: 'Server restarted',
  paused: 'Paused',
  wentOn: 'Went on',
  stopped: 'Ended by user',
  ended: 'Over',
};

export function triggerText(explanation: Pick<RunExplanation, 'trigger'>): string {
  // A server that is newer than the page may have another one.
  return TRIGGERS[explanation.trigger] ?? explanation.trigger;
}

export function stateText(run: MissionRun): string {
  switch (run.state) {
    case 'running':
      return run.proposal === null ? 'Under way' : 'Waits for your answer';
    case 'paused':
      return 'Paused: drones hold where they are';
    case 'stopping':
      return 'Ending: its drones return';
    default:
      return run.end ?? 'Over';
  }
}

/** In one line, for lists. */
export function countsText(run: MissionRun): string {
  const { waypoints, visited, unserved, cancelled } = run.counts;
  const parts = [`${visited} of ${counted(waypoints - cancelled, 'waypoint')} visited`];
  if (unserved > 0) {
    parts.push(`${unserved} left out`);
  }
  return parts.join(', ');
}

export interface Share extends Look {
  state: RunWaypointState;
  count: number;
}

/** The count of waypoints in each state, in the order of the bar; empty states are left out. */
export function sharesOf(run: MissionRun): Share[] {
  const states: RunWaypointState[] = ['visited', 'assigned', 'waiting', 'reserved', 'unserved', 'cancelled'];
  return states
    .map((state) => ({
      state,
      ...WAYPOINT_LOOKS[state],
      count: run.waypoints.filter((waypoint) => waypoint.state === state).length,
    }))
    .filter((share) => share.count > 0);
}

export function nameOf(run: MissionRun, drone: string | null): string {
  return drone === null ? 'nobody' : (run.drones.find((one) => one.id === drone)?.name ?? drone);
}

/** "3, 4: Falcon to Heron", one for each pair. */
export function movedTexts(run: MissionRun, moved: readonly Moved[]): string[] {
  const pairs = new Map<string, string[]>();
  for (const { waypoint, from, to } of moved) {
    const pair = `${nameOf(run, from)} to ${nameOf(run, to)}`;
    pairs.set(pair, [...(pairs.get(pair) ?? []), waypoint]);
  }
  return [...pairs].map(([pair, waypoints]) => `${waypoints.join(', ')}: ${pair}`);
}

/** The cost of a decision; null where nothing was planned. */
export function costText(before: Figures | null, after: Figures | null): string | null {
  if (before === null || after === null) {
    return null;
  }
  const time = (figures: Figures): string => span(Math.round(figures.longestSeconds));
  const left =
    before.unserved === 0 && after.unserved === 0 ? '' : `, left out ${before.unserved} → ${after.unserved}`;
  return `all back in ${time(before)} → ${time(after)}, cost ${amount(before.cost)} → ${amount(after.cost)}${left}`;
}

function amount(cost: number): string {
  return cost.toLocaleString('en-GB', { maximumFractionDigits: cost < 100 ? 1 : 0 });
}

/** The time from now on; null: unknown, or past. */
export function dueText(due: string | null, now: number): string | null {
  if (due === null) {
    return null;
  }
  const seconds = Math.round((Date.parse(due) - now) / 1000);
  return seconds > 0 ? `in ${span(seconds)}` : null;
}

/** The state of one waypoint, in one sentence. */
export function waypointText(run: MissionRun, waypoint: RunWaypoint, now: number): string {
  const { words } = WAYPOINT_LOOKS[waypoint.state];
  if (waypoint.state === 'visited') {
    const by = waypoint.visits.map((visit) => nameOf(run, visit.drone)).join(', then ');
    return by === '' ? words : `${words} by ${by}`;
  }
  if (waypoint.state === 'unserved' && waypoint.why !== null) {
    return `${words}: ${waypoint.why}`;
  }
  const due = dueText(waypoint.due, now);
  const by = waypoint.drone === null ? '' : ` by ${nameOf(run, waypoint.drone)}`;
  return waypoint.state === 'assigned' ? `${words}${by}${due === null ? '' : `, ${due}`}` : words;
}

export function isSettled(waypoint: RunWaypoint): boolean {
  return waypoint.state === 'visited' || waypoint.state === 'unserved' || waypoint.state === 'cancelled';
}

/** The order of waypoints: left out, then unassigned, then to come in the order of coming, then visited. */
const ORDER: RunWaypointState[] = ['unserved', 'reserved', 'waiting', 'assigned', 'visited', 'cancelled'];

export function sortedWaypoints(run: MissionRun): RunWaypoint[] {
  return run.waypoints.toSorted(
    (a, b) => ORDER.indexOf(a.state) - ORDER.indexOf(b.state) || (a.due ?? '').localeCompare(b.due ?? ''),
  );
}

/** Another holder has it, or it left the run: it comes back only when it is resumed. */
export function mayResume(drone: RunDrone): boolean {
  return drone.stage === 'suspended' || drone.stage === 'left' || drone.stage === 'gone';
}

export function mayGiveUp(drone: RunDrone): boolean {
  return !['left', 'gone', 'crashed'].includes(drone.stage);
}

/** It is in the air, so that it can hold. */
export function isInTheAir(drone: RunDrone): boolean {
  return ['starting', 'flying', 'holding', 'replacing', 'continuing', 'resuming', 'returning'].includes(
    drone.stage,
  );
}

/** The drones that move at once when a paused run is resumed; null: none that is known now. */
export function resumeText(run: MissionRun): string | null {
  const words = run.drones
    .filter(({ next }) => next.length > 0)
    .map((drone) => `${drone.name} ${isInTheAir(drone) ? 'flies on' : 'takes off'}`);
  return words.length === 0 ? null : `At once: ${words.join(', ')}.`;
}

/** Drones that can come into a run: on the ground, all known, and not in it. */
export function joinable(run: MissionRun, drones: readonly Drone[]): Drone[] {
  const inside = new Set(run.drones.filter((one) => one.stage !== 'left').map((one) => one.id));
  return drones.filter((drone) => !inside.has(drone.id) && whyNotPlanned(drone) === null);
}

export function replayText(replay: Replay): string {
  const entries = counted(replay.entries, 'entry').replace('entrys', 'entries');
  return replay.same
    ? `Replayed ${entries}: no difference.`
    : `Entry ${replay.number ?? '?'} differs in the replay.`;
}

/** How many drones of the pool fly it at most, or nothing where they were named. */
export function poolText({ upTo }: Pick<MissionRun, 'upTo'>): string {
  return upTo === undefined || upTo === null ? '' : ` · up to ${counted(upTo, 'drone')} of the pool`;
}
