import type { Follow, FollowCalls, FollowNow, FollowOrder, FollowWish, PlaceChange } from '../api/follows';
import { sentenceFor } from '../api/problem';

/** Follows that this page knows of. */
export class Follows {
  loaded = $state(false);
  problem = $state<string | null>(null);
  #all = $state.raw<ReadonlyMap<string, Follow>>(new Map());
  readonly #calls: FollowCalls;
  #looking = false;

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

  /** Answers may overtake each other: of an older stage than what is known nothing new is to be heard. */
  hear(follow: Follow): void {
    const known = this.#all.get(follow.id);
    if (known === undefined || known.since <= follow.since) {
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
    this.loaded = false;
    this.problem = null;
  }

  async load(): Promise<void> {
    await this.#attempt(async () => {
      (await this.#calls.all()).forEach((follow) => this.hear(follow));
      this.loaded = true;
    });
  }

  /** As often as one likes: over a dead line questions do not pile up. */
  async look(id: string): Promise<void> {
    if (!this.#looking) {
      this.#looking = true;
      await this.#attempt(async () => this.hear(await this.#calls.one(id)));
      this.#looking = false;
    }
  }

  async open(order: FollowOrder): Promise<Follow> {
    return this.#heard(await this.#calls.open(order));
  }

  async wish(id: string, wish: FollowWish): Promise<Follow> {
    return this.#heard(await this.#calls.wish(id, wish));
  }

  async change(id: string, place: PlaceChange): Promise<Follow> {
    return this.#heard(await this.#calls.change(id, place));
  }

  async #attempt(action: () => Promise<void>): Promise<void> {
    try {
      await action();
      this.problem = null;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
    }
  }

  #heard(follow: Follow): Follow {
    this.hear(follow);
    return follow;
  }
}
