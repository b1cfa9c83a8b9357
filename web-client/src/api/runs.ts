import type { Zone } from './zones';
import type {
  PlanWaypointRequest as NewRunWaypoint,
  RunReplayView as Replay,
  RunDroneView as RunDrone,
  RunStartRequest as RunStart,
  RunTaskView as RunTask,
  RunView,
  RunWaypointView as RunWaypoint,
} from './contract';

export type { NewRunWaypoint, Replay, RunDrone, RunStart, RunTask, RunWaypoint };
export type {
  RunFiguresView as Figures,
  RunMovedView as Moved,
  RunExplanationView as RunExplanation,
  RunProposalView as RunProposal,
} from './contract';

/** A plan that the cloud has drones fly, as it stands. */
export type MissionRun = Omit<RunView, 'barriers'> & { barriers: Barrier[] };

export type Barrier = Pick<Zone, 'type' | 'geometry'> & {
  properties: Pick<
    Zone['properties'],
    'name' | 'kind' | 'radius' | 'floor' | 'ceiling' | 'altitudeReference'
  >;
};

export type RunMode = MissionRun['mode'];

export type RunStage = RunDrone['stage'];

export type RunWaypointState = RunWaypoint['state'];

export type TaskType = RunTask['type'];

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls around mission runs; each returns the new state of the run. */
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

  resumeRun(id: string): Promise<MissionRun> {
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
