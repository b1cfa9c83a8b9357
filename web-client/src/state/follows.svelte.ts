import type { Follow, FollowCalls, FollowNow, FollowOrder, FollowWish, PlaceChange } from '../api/follows';
import { sentenceFor } from '../api/problem';

/** Follows that this page knows of. */
export class Follows {
  loaded = $state(false);
  problem = $state<string | null>(null);
  #all = $state.raw<ReadonlyMap<string, Follow>>(new Map());
  readonly #calls: FollowCalls;
  #looking = false;
  /** Counts what was asked and what was told, so that an answer can be told to be older than what came meanwhile. */
  #count = 0;
  /** Of each follow, by that count, how new its picture is. */
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

  /** The stream tells: that is the newest there is. */
  hear(follow: Follow): void {
    this.#take(follow, ++this.#count);
  }

  /**
   * Answers may be overtaken, by each other and by the stream: a picture of an older stage brings nothing new, nor does
   * one of the same stage that was asked for before a newer one came. Notes change within a stage.
   */
  #take(follow: Follow, asOf: number): void {
    const known = this.#all.get(follow.id);
    const newer = known === undefined || known.since < follow.since;
    if (newer || (known.since === follow.since && asOf >= (this.#asOf.get(follow.id) ?? 0))) {
      this.#asOf.set(follow.id, asOf);
      this.#all = new Map(this.#all).set(follow.id, follow);
    }
  }

  hearNow(id: string, now: FollowNow | null): void {
    const known = this.#all.get(id);
    if (known !== undefined) {
      this.#all = new Map(this.#all).set(id, { ...known, now });
    }
  }

  /** The line to the cloud was lost, and is there again: what ended meanwhile is not told by itself. */
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
      (await this.#calls.all()).forEach((follow) => this.#take(follow, asked));
      this.loaded = true;
    });
  }

  /** As often as one likes: over a dead line questions do not pile up. */
  async look(id: string): Promise<void> {
    if (!this.#looking) {
      this.#looking = true;
      await this.#attempt(async () => void (await this.#ask(() => this.#calls.one(id))));
      this.#looking = false;
    }
  }

  open(order: FollowOrder): Promise<Follow> {
    return this.#ask(() => this.#calls.open(order));
  }

  wish(id: string, wish: FollowWish): Promise<Follow> {
    return this.#ask(() => this.#calls.wish(id, wish));
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
    this.#take(follow, asked);
    return follow;
  }
}
