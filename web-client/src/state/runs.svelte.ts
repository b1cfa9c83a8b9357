import type { MissionRun, NewRunWaypoint, RunCalls, RunStart } from '../api/runs';
import { sentenceFor } from '../api/problem';
import type { Coordinates } from '../geo/coordinates';

/** The effect of a click on the map on the shown run. */
export type RunTool = 'add' | 'move';

/** The runs, and the changes being made to the shown one. */
export class Runs {
  shownId = $state<string | null>(null);
  /** The id of the selected waypoint. */
  chosen = $state<string | null>(null);
  tool = $state<RunTool | null>(null);
  /** Places that were marked on the map and are not sent yet. */
  marks = $state.raw<readonly Coordinates[]>([]);
  problem = $state<string | null>(null);
  /** Something was sent and is not answered yet. */
  busy = $state(false);
  /** Earlier ones were asked for. */
  loaded = $state(false);
  #all = $state.raw<ReadonlyMap<string, MissionRun>>(new Map());
  readonly #calls: RunCalls;

  constructor(calls: RunCalls) {
    this.#calls = calls;
  }

  get shown(): MissionRun | null {
    return this.shownId === null ? null : (this.#all.get(this.shownId) ?? null);
  }

  /** The newest first. */
  get all(): MissionRun[] {
    return [...this.#all.values()].sort((a, b) => b.beganAt.localeCompare(a.beganAt));
  }

  get underWay(): MissionRun[] {
    return this.all.filter((run) => run.state !== 'over');
  }

  /** Applies a newer version of a run; answers and updates may overtake each other. */
  apply(run: MissionRun): void {
    const known = this.#all.get(run.id);
    if (known !== undefined && known.journal > run.journal) {
      return;
    }
    this.#all = new Map(this.#all).set(run.id, run);
    if (run.id === this.shownId && run.state !== 'running' && run.state !== 'paused') {
      this.clearTool();
    }
  }

  show(id: string): void {
    if (id !== this.shownId) {
      this.leave();
    }
    this.shownId = id;
  }

  leave(): void {
    this.shownId = null;
    this.chosen = null;
    this.problem = null;
    this.clearTool();
  }

  clear(): void {
    this.leave();
    this.#all = new Map();
    this.loaded = false;
  }

  choose(waypoint: string | null): void {
    this.chosen = waypoint;
    this.clearTool();
  }

  selectTool(tool: RunTool): void {
    this.tool = tool;
    this.marks = [];
  }

  /** Puts the tool aside, and what was marked with it. */
  clearTool(): void {
    this.tool = null;
    this.marks = [];
  }

  mark(place: Coordinates): void {
    this.marks = this.tool === 'add' ? [...this.marks, place] : [place];
  }

  unmark(): void {
    this.marks = this.marks.slice(0, -1);
  }

  /** Reads all runs: the stream does not send those that are over. */
  async load(): Promise<void> {
    await this.#attempt(async () => {
      (await this.#calls.all()).forEach((run) => this.apply(run));
      this.loaded = true;
    });
  }

  /** The connection was lost, and is there again. */
  async catchUp(): Promise<void> {
    const { shown } = this;
    if (this.loaded) {
      await this.load();
    } else if (shown !== null) {
      await this.#attempt(async () => this.apply(await this.#calls.one(shown.id)));
    }
  }

  /** Answers whether it has begun; then it is looked at. */
  async start(request: RunStart): Promise<boolean> {
    return this.#send(async () => {
      const run = await this.#calls.start(request);
      this.apply(run);
      this.show(run.id);
    });
  }

  async addMarks(altitude: number): Promise<void> {
    const waypoints = this.marks.map(({ latitude, longitude }): NewRunWaypoint => ({
      latitude,
      longitude,
      altitude,
      altitudeReference: 'home',
    }));
    await this.#act((id) => this.#calls.add(id, waypoints));
  }

  async moveChosen(): Promise<void> {
    const [mark] = this.marks;
    const { chosen } = this;
    if (mark !== undefined && chosen !== null) {
      await this.#act((id) => this.#calls.move(id, chosen, mark.latitude, mark.longitude));
    }
  }

  async cancel(waypoint: string): Promise<void> {
    await this.#act((id) => this.#calls.cancel(id, waypoint));
  }

  async join(drone: string): Promise<void> {
    await this.#act((id) => this.#calls.join(id, drone));
  }

  async resume(drone: string): Promise<void> {
    await this.#act((id) => this.#calls.resume(id, drone));
  }

  async giveUp(drone: string): Promise<void> {
    await this.#act((id) => this.#calls.giveUp(id, drone));
  }

  async answer(proposal: number, accept: boolean): Promise<void> {
    await this.#act((id) => this.#calls.answer(id, proposal, accept));
  }

  async pause(): Promise<void> {
    await this.#act((id) => this.#calls.pause(id));
  }

  async resumeRun(): Promise<void> {
    await this.#act((id) => this.#calls.resumeRun(id));
  }

  async stop(): Promise<void> {
    await this.#act((id) => this.#calls.stop(id));
  }

  /** Sends a change of the run; the marks are kept when it is refused. */
  async #act(call: (id: string) => Promise<MissionRun>): Promise<void> {
    const id = this.shownId;
    if (id !== null && !this.busy) {
      await this.#send(async () => {
        this.apply(await call(id));
        this.clearTool();
      });
    }
  }

  async #send(action: () => Promise<void>): Promise<boolean> {
    this.busy = true;
    try {
      return await this.#attempt(action);
    } finally {
      this.busy = false;
    }
  }

  async #attempt(action: () => Promise<void>): Promise<boolean> {
    try {
      await action();
      this.problem = null;
      return true;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
      return false;
    }
  }
}
