import type { Zone } from './zones';
import type {
  PlanWaypointRequest as NewRunWaypoint,
  RunReplayView as Replay,
  RunDroneView as RunDrone,
  RunStartRequest as RunStart,
  RunTaskView as RunTask,
  RunView,
  RunWaypointView as RunWaypoint,
  RestOperations,
} from '@dronemap/client';

export type { NewRunWaypoint, Replay, RunDrone, RunStart, RunTask, RunWaypoint };
export type {
  RunFiguresView as Figures,
  RunMovedView as Moved,
  RunExplanationView as RunExplanation,
  RunProposalView as RunProposal,
} from '@dronemap/client';

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

/** The calls around mission runs; each returns the new state of the run. */
export class RunCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  async all(): Promise<MissionRun[]> {
    return (await this.#rest.listRuns()).runs as MissionRun[];
  }

  one(id: string): Promise<MissionRun> {
    return this.#rest.getRun({ id }) as Promise<MissionRun>;
  }

  start(request: RunStart): Promise<MissionRun> {
    return this.#rest.startRun(request) as Promise<MissionRun>;
  }

  add(id: string, waypoints: readonly NewRunWaypoint[]): Promise<MissionRun> {
    return this.#rest.addRunWaypoints({ id }, { waypoints: [...waypoints] }) as Promise<MissionRun>;
  }

  /** It keeps its height. */
  move(id: string, waypoint: string, latitude: number, longitude: number): Promise<MissionRun> {
    return this.#rest.moveRunWaypoint({ id, waypoint }, { latitude, longitude }) as Promise<MissionRun>;
  }

  cancel(id: string, waypoint: string): Promise<MissionRun> {
    return this.#rest.cancelRunWaypoint({ id, waypoint }) as Promise<MissionRun>;
  }

  join(id: string, drone: string): Promise<MissionRun> {
    return this.#rest.joinRun({ id }, { drone }) as Promise<MissionRun>;
  }

  resume(id: string, drone: string): Promise<MissionRun> {
    return this.#rest.resumeRunDrone({ id, drone }) as Promise<MissionRun>;
  }

  giveUp(id: string, drone: string): Promise<MissionRun> {
    return this.#rest.giveUpRunDrone({ id, drone }) as Promise<MissionRun>;
  }

  answer(id: string, proposal: number, accept: boolean): Promise<MissionRun> {
    return this.#rest.answerRun({ id, proposal: String(proposal) }, { accept }) as Promise<MissionRun>;
  }

  pause(id: string): Promise<MissionRun> {
    return this.#rest.pauseRun({ id }) as Promise<MissionRun>;
  }

  resumeRun(id: string): Promise<MissionRun> {
    return this.#rest.continueRun({ id }) as Promise<MissionRun>;
  }

  stop(id: string): Promise<MissionRun> {
    return this.#rest.stopRun({ id }) as Promise<MissionRun>;
  }

  replay(id: string): Promise<Replay> {
    return this.#rest.replayRunJournal({ id });
  }
}
