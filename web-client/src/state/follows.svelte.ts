import type { Follow, FollowCalls, FollowNow, FollowOrder, FollowAction, PlaceChange } from '../api/follows';
import { sentenceFor } from '../api/problem';

/** Follows that this page knows of. */
export class Follows {
  loaded = $state(false);
  problem = $state<string | null>(null);
  #all = $state.raw<ReadonlyMap<string, Follow>>(new Map());
  readonly #calls: FollowCalls;
  #polling = false;
  /** Numbers requests and updates, so that an answer is known to be older than an update that came after its request. */
  #count = 0;
  /** The number of the request or update that each follow was stored from. */
  readonly #asOf = new Map<string, number>();

  constructor(calls: FollowCalls) {
    this.#calls = calls;
  }

  /** The newest first. */
  get all(): Follow[] {
    return [...this.#all.values()].sort((a, b) => b.beganAt.localeCompare(a.beganAt));
  }

  get underWay(): Follow[] {
    return this.all.filter((follow) => follow.state !== 'over');
  }

  find(id: string | null): Follow | null {
    return id === null ? null : (this.#all.get(id) ?? null);
  }

  /** Applies an update of the stream, which is the newest there is. */
  apply(follow: Follow): void {
    this.#store(follow, ++this.#count);
  }

  /**
   * Stores a follow unless a newer one is known: answers may be overtaken by each other and by the stream. Of the same stage the
   * later request or update counts, since notes change within a stage.
   */
  #store(follow: Follow, asOf: number): void {
    const known = this.#all.get(follow.id);
    const newer = known === undefined || known.since < follow.since;
    if (newer || (known.since === follow.since && asOf >= (this.#asOf.get(follow.id) ?? 0))) {
      this.#asOf.set(follow.id, asOf);
      this.#all = new Map(this.#all).set(follow.id, follow);
    }
  }

  applyNow(id: string, now: FollowNow | null): void {
    const known = this.#all.get(id);
    if (known !== undefined) {
      this.#all = new Map(this.#all).set(id, { ...known, now });
    }
  }

  /** After the connection was lost: the stream does not send follows that ended meanwhile. */
  async catchUp(): Promise<void> {
    if (this.underWay.length > 0) {
      await this.load();
    }
  }

  clear(): void {
    this.#all = new Map();
    this.#asOf.clear();
    this.loaded = false;
    this.problem = null;
  }

  async load(): Promise<void> {
    await this.#attempt(async () => {
      const asked = ++this.#count;
      (await this.#calls.all()).forEach((follow) => this.#store(follow, asked));
      this.loaded = true;
    });
  }

  /** Reads one follow, unless a read is pending: requests do not pile up over a dead connection. */
  async poll(id: string): Promise<void> {
    if (!this.#polling) {
      this.#polling = true;
      await this.#attempt(async () => void (await this.#ask(() => this.#calls.one(id))));
      this.#polling = false;
    }
  }

  open(order: FollowOrder): Promise<Follow> {
    return this.#ask(() => this.#calls.open(order));
  }

  act(id: string, action: FollowAction): Promise<Follow> {
    return this.#ask(() => this.#calls.act(id, action));
  }

  change(id: string, place: PlaceChange): Promise<Follow> {
    return this.#ask(() => this.#calls.change(id, place));
  }

  async #attempt(action: () => Promise<void>): Promise<void> {
    try {
      await action();
      this.problem = null;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
    }
  }

  async #ask(call: () => Promise<Follow>): Promise<Follow> {
    const asked = ++this.#count;
    const follow = await call();
    this.#store(follow, asked);
    return follow;
  }
}
