import type { FleetPlan, PlanAim, PlanCalls, PlanObjective, PlanWaypoint } from '../api/plans';
import { Problem, sentenceFor } from '../api/problem';
import type { Coordinates } from '../geo/coordinates';
import { NO_REQUIREMENTS, type Requirements } from '../tours/requirements';
import { isUnderWay } from '../tours/tour-text';

/** The name under which the editor keeps the waypoints for several drones; no drone is called so. */
export const FLEET_DRAFT = '#fleet';

/** The plans for several drones: the one that is being made, from the choice of drones to their start, and earlier ones. */
export class Tours {
  /** Ids of the drones that are to share the waypoints. */
  chosen = $state<string[]>([]);
  /** Up to so many drones of the pool, which the cloud chooses; else those that are chosen here. */
  ofPool = $state(false);
  upTo = $state<number | null>(3);
  aim = $state<PlanAim>('earliestEnd');
  /** Weighted: 0: all done early, 100: little flying in all. */
  balance = $state(50);
  everyDrone = $state(false);
  seconds = $state<number | null>(5);
  /** m/s; null: calm. */
  windSpeed = $state<number | null>(null);
  /** Degrees clockwise from north. */
  windFrom = $state<number | null>(null);
  /** By the keys of the waypoints in the editor. */
  requirements = $state.raw<ReadonlyMap<number, Requirements>>(new Map());
  problem = $state<string | null>(null);
  /** Something was sent and is not answered yet. */
  busy = $state(false);
  shownId = $state<string | null>(null);
  besideId = $state<string | null>(null);
  #plans = $state.raw<ReadonlyMap<string, FleetPlan>>(new Map());
  /** The places of the waypoints of a plan, by their ids: during the search only ids are sent. */
  #places = $state.raw<{ plan: string; places: ReadonlyMap<string, Coordinates> } | null>(null);
  readonly #calls: PlanCalls;

  constructor(calls: PlanCalls) {
    this.#calls = calls;
  }

  /** The one that is looked at. */
  get plan(): FleetPlan | null {
    return this.#find(this.shownId);
  }

  /** The one that it is compared with. */
  get beside(): FleetPlan | null {
    return this.besideId === this.shownId ? null : this.#find(this.besideId);
  }

  /** Finished ones that can be looked at instead, the newest first. */
  get others(): FleetPlan[] {
    return [...this.#plans.values()]
      .filter((one) => one.result !== null && one.id !== this.shownId)
      .reverse();
  }

  get places(): ReadonlyMap<string, Coordinates> {
    return this.#places?.plan === this.shownId ? this.#places.places : new Map();
  }

  #find(id: string | null): FleetPlan | null {
    return id === null ? null : (this.#plans.get(id) ?? null);
  }

  apply(plan: FleetPlan): void {
    this.#plans = new Map(this.#plans).set(plan.id, plan);
    // After the page was opened anew.
    if (this.plan === null && (isUnderWay(plan) || plan.launch?.underWay === true)) {
      this.shownId = plan.id;
    }
  }

  applyRemoval(id: string): void {
    const plans = new Map(this.#plans);
    plans.delete(id);
    this.#plans = plans;
  }

  clear(): void {
    this.#plans = new Map();
    this.shownId = null;
    this.besideId = null;
    this.chosen = [];
    this.problem = null;
  }

  requirementsOf(key: number): Requirements {
    return this.requirements.get(key) ?? NO_REQUIREMENTS;
  }

  changeRequirements(key: number, change: Partial<Requirements>): void {
    this.requirements = new Map(this.requirements).set(key, { ...this.requirementsOf(key), ...change });
  }

  show(id: string): void {
    this.besideId = this.shownId;
    this.shownId = id;
  }

  async ask(waypoints: readonly PlanWaypoint[]): Promise<void> {
    await this.#attempt(async () => {
      const before = this.plan;
      const plan = await this.#calls.ask({
        ...(this.ofPool ? { upTo: this.upTo } : { drones: this.chosen }),
        waypoints: [...waypoints],
        objective: this.#objective(),
        seconds: this.seconds ?? 5,
        ...(this.windSpeed === null || this.windSpeed === 0
          ? {}
          : { wind: { speed: this.windSpeed, from: this.windFrom ?? 0 } }),
      });
      this.#places = {
        plan: plan.id,
        places: new Map(waypoints.map((waypoint) => [waypoint.id, waypoint])),
      };
      // The stream may have sent a later version.
      if (!this.#plans.has(plan.id)) {
        this.apply(plan);
      }
      this.shownId = plan.id;
      this.besideId = before?.result ? before.id : null;
    });
  }

  #objective(): PlanObjective {
    const { aim, everyDrone } = this;
    const share = this.balance / 100;
    return aim === 'weighted'
      ? { kind: aim, everyDrone, longestWeight: 1 - share, sumWeight: share }
      : { kind: aim, everyDrone };
  }

  /** Puts the missions on board, and starts the drones when that is asked for. */
  async accept(start: boolean): Promise<void> {
    const { plan } = this;
    if (plan !== null) {
      await this.#attempt(async () => this.apply(await this.#calls.accept(plan.id, start)));
    }
  }

  async stop(): Promise<void> {
    const { plan } = this;
    if (plan !== null) {
      await this.#attempt(async () => this.apply(await this.#calls.stop(plan.id)));
    }
  }

  /** Cancels the search, or leaves the plan. */
  async drop(): Promise<void> {
    const { plan } = this;
    if (plan !== null) {
      await this.#attempt(async () => {
        await this.#calls.remove(plan.id);
        if (isUnderWay(plan)) {
          // It was cancelled; now it is forgotten.
          await this.#calls.remove(plan.id);
        }
        this.applyRemoval(plan.id);
        this.shownId = null;
      });
    }
  }

  /** The connection was lost, and is there again: a server that was started anew knows no plans. */
  async catchUp(): Promise<void> {
    const { plan } = this;
    if (plan === null) {
      return;
    }
    try {
      this.apply(await this.#calls.one(plan.id));
    } catch (thrown) {
      if (thrown instanceof Problem && thrown.status === 404) {
        this.applyRemoval(plan.id);
        this.problem =
          'The server no longer knows this plan: it was started anew, or much time has passed. ' +
          'What was uploaded is on board; drones that had not been started stay where they are.';
      }
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
