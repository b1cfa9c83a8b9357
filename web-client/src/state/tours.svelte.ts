import type { FleetPlan, PlanAim, PlanCalls, PlanWaypoint } from '../api/plans';
import { sentenceFor } from '../api/problem';
import type { Coordinates } from '../geo/coordinates';

/** The name under which the editor keeps the waypoints for several drones; no drone is called so. */
export const FLEET_DRAFT = '#fleet';

/** The plan for several drones that is being made, from the choice of drones to their start. */
export class Tours {
  /** Ids of the drones that are to share the waypoints. */
  chosen = $state<string[]>([]);
  aim = $state<PlanAim>('earliestEnd');
  seconds = $state<number | null>(5);
  plan = $state.raw<FleetPlan | null>(null);
  problem = $state<string | null>(null);
  /** Something was sent and is not answered yet. */
  busy = $state(false);
  /** Where the waypoints of the plan are, by their ids: while a search goes on only these are told. */
  places = $state.raw<ReadonlyMap<string, Coordinates>>(new Map());
  readonly #calls: PlanCalls;

  constructor(calls: PlanCalls) {
    this.#calls = calls;
  }

  hear(plan: FleetPlan): void {
    if (plan.id === this.plan?.id) {
      this.plan = plan;
    }
  }

  forget(id: string): void {
    if (id === this.plan?.id) {
      this.plan = null;
    }
  }

  clear(): void {
    this.plan = null;
    this.chosen = [];
    this.problem = null;
  }

  async ask(waypoints: readonly PlanWaypoint[]): Promise<void> {
    await this.#attempt(async () => {
      const before = this.plan;
      const plan = await this.#calls.ask({
        drones: this.chosen,
        waypoints,
        objective: { kind: this.aim },
        seconds: this.seconds ?? 5,
      });
      this.places = new Map(waypoints.map((waypoint) => [waypoint.id, waypoint]));
      this.plan = plan;
      if (before !== null && before.state !== 'queued' && before.state !== 'running') {
        await this.#calls.remove(before.id);
      }
    });
  }

  /** Puts the missions on board, and starts the drones when that is asked for. */
  async accept(start: boolean): Promise<void> {
    const { plan } = this;
    if (plan !== null) {
      await this.#attempt(async () => this.hear(await this.#calls.accept(plan.id, start)));
    }
  }

  /** Cancels the search, or leaves the plan. */
  async drop(): Promise<void> {
    const { plan } = this;
    if (plan !== null) {
      await this.#attempt(async () => {
        this.plan = null;
        await this.#calls.remove(plan.id);
      });
    }
  }

  async #attempt(action: () => Promise<void>): Promise<void> {
    this.busy = true;
    try {
      await action();
      this.problem = null;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
    } finally {
      this.busy = false;
    }
  }
}
