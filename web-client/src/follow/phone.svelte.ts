import type { Follow, FollowOrder, FollowStage, FollowAction, PlaceChange } from '../api/follows';
import { Problem, sentenceFor } from '../api/problem';
import { browserTimers } from '../api/stream';
import { AbsenceWatch } from './absence.svelte';
import { notDoneWords } from './follow-words';
import type { Fix, Locating, TargetSource } from './fix';
import { PositionLine, type SayPositions } from './position-line.svelte';
import type { Follows } from '../state/follows.svelte';
import { TOLD_AFTER_SECONDS } from './waiting';

/** Longer between two beats, and the system had stopped the page. */
const SLEPT_MILLISECONDS = 5_000;
const BEAT_MILLISECONDS = 1_000;
/** Whoever pressed in vain shall read it, also when the line is there again at once. */
const READ_MILLISECONDS = 8_000;

export interface PhonePorts {
  follows: Follows;
  /** Says positions of the follow of that id. */
  say(id: string): SayPositions;
}

/** What the phone page is about: where the target is, the follow that it asked for, and the line between both. */
export class Phone {
  /** By the phone's clock; ticks once a second. */
  now = $state(Date.now());
  fix = $state.raw<Fix | null>(null);
  locating = $state<Locating>('off');
  demo = $state(false);
  /** As far as the phone knows, it has a network. */
  online = $state(navigator.onLine);
  /** The follow that this page is about; it may be over. */
  followId = $state<string | null>(null);
  busy = $state<FollowAction | 'ask' | 'place' | null>(null);
  problem = $state<string | null>(null);
  readonly absence = new AbsenceWatch();
  line = $state.raw<PositionLine | null>(null);
  readonly #ports: PhonePorts;
  #stopSource: (() => void) | null = null;
  /** When and at which stage the problem came up, and whether the cloud was not reached. */
  #came: { at: number; stage: FollowStage | null; unreached: boolean } | null = null;

  constructor(ports: PhonePorts) {
    this.#ports = ports;
  }

  get follow(): Follow | null {
    return this.#ports.follows.find(this.followId);
  }

  /** Begins to beat; answers how to end. */
  open(): () => void {
    const handle = setInterval(() => this.beat(Date.now()), BEAT_MILLISECONDS);
    return () => {
      clearInterval(handle);
      this.#stopLocating();
      this.#hangUp();
    };
  }

  beat(now: number): void {
    const gap = now - this.now;
    this.now = now;
    this.online = navigator.onLine;
    if (gap > SLEPT_MILLISECONDS) {
      this.absence.suspect('asleep', now);
      this.line?.woke();
    } else if (this.line !== null && this.line.cutOffSince !== null) {
      this.absence.suspect(this.online ? 'unanswered' : 'cut', now);
    } else if (this.fix === null || now - this.fix.at > TOLD_AFTER_SECONDS * 1000) {
      this.absence.suspect('blind', now);
    }
    this.#watch();
    this.#forgetProblem();
    this.line?.beat();
  }

  /** It does not outlive its stage, nor the outage that it came of. */
  #forgetProblem(): void {
    const came = this.#came;
    if (came === null) {
      return;
    }
    const reached = this.line !== null && this.line.cutOffSince === null;
    const over = came.unreached && reached && this.now - came.at >= READ_MILLISECONDS;
    if (over || came.stage !== (this.follow?.state ?? null)) {
      this.#came = null;
      this.problem = null;
    }
  }

  #watch(): void {
    if (this.follow !== null) {
      this.absence.update(this.follow, this.now);
    }
  }

  locate(source: TargetSource, demo: boolean): void {
    this.#stopLocating();
    this.fix = null;
    this.demo = demo;
    this.#stopSource = source.start({
      onFix: (fix) => {
        this.fix = fix;
        this.line?.offer(fix);
      },
      onLocating: (locating) => (this.locating = locating),
    });
  }

  /** A follow of mine that is under way from before the page was closed. */
  resume(follow: Follow): void {
    this.#take(follow);
    this.absence.suspect('gone', this.now);
  }

  #take(follow: Follow): void {
    this.followId = follow.id;
    this.problem = null;
    this.#watch();
    this.#dial(follow);
  }

  async ask(order: Omit<FollowOrder, 'latitude' | 'longitude'>): Promise<void> {
    const { fix } = this;
    if (fix !== null) {
      await this.#attempt('ask', async () => {
        const { latitude, longitude } = fix;
        this.#take(await this.#ports.follows.open({ latitude, longitude, ...order }));
      });
    }
  }

  async act(action: FollowAction): Promise<void> {
    await this.#onFollow(action, (id) => this.#ports.follows.act(id, action));
  }

  async place(change: PlaceChange): Promise<void> {
    await this.#onFollow('place', (id) => this.#ports.follows.change(id, change));
  }

  /** Back to the question, after one is over. */
  leave(): void {
    this.#hangUp();
    this.followId = null;
    this.problem = null;
  }

  /** The line to the cloud is there again. */
  reconnected(): void {
    this.line?.retryNow();
  }

  #dial(follow: Follow): void {
    this.#hangUp();
    if (follow.state !== 'over') {
      this.line = new PositionLine(this.#ports.say(follow.id), browserTimers);
      if (this.fix !== null) {
        this.line.offer(this.fix);
      }
    }
  }

  /** Nobody asks where the target is any more. */
  #hangUp(): void {
    this.line?.close();
    this.line = null;
  }

  settle(): void {
    if (this.follow?.state === 'over') {
      this.#hangUp();
    }
  }

  #stopLocating(): void {
    this.#stopSource?.();
    this.#stopSource = null;
    this.locating = 'off';
  }

  async #onFollow(what: FollowAction | 'place', call: (id: string) => Promise<unknown>): Promise<void> {
    const id = this.followId;
    if (id !== null) {
      await this.#attempt(what, () => call(id));
    }
  }

  async #attempt(what: NonNullable<Phone['busy']>, action: () => Promise<unknown>): Promise<void> {
    if (this.busy !== null) {
      return;
    }
    this.busy = what;
    try {
      await action();
      this.problem = null;
      this.#came = null;
    } catch (thrown) {
      const unreached = thrown instanceof Problem && thrown.status === 0;
      const stage = this.follow?.state ?? null;
      this.#came = { at: this.now, stage, unreached };
      this.problem =
        unreached && stage !== null && what !== 'ask' && what !== 'place'
          ? notDoneWords(what, stage, navigator.onLine)
          : sentenceFor(thrown);
    } finally {
      this.busy = null;
    }
  }
}
