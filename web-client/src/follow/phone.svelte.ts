import type { Follow, FollowOrder, FollowStage, FollowAction, PlaceChange } from '../api/follows';
import { Problem, sentenceFor } from '../api/problem';
import { systemTimers } from '@dronemap/client';
import { AbsenceWatch } from './absence.svelte';
import { notDoneText } from './follow-text';
import type { Fix, Locating, TargetSource } from './fix';
import { PositionUplink, type SendPositions } from './position-uplink.svelte';
import type { Follows } from '../state/follows.svelte';
import { WARN_AFTER_SECONDS } from './outage';

/** Longer between two updates means that the system had stopped the page. */
const SLEPT_MILLISECONDS = 5_000;
const UPDATE_MILLISECONDS = 1_000;
/** A problem is shown at least this long, also when the connection is back at once. */
const READ_MILLISECONDS = 8_000;

export interface PhonePorts {
  follows: Follows;
  /** Sends positions of the follow of that id. */
  sender(id: string): SendPositions;
}

/** The state of the phone page: the position of the target, the follow that it requested, and the uplink between both. */
export class Phone {
  /** By the phone's clock, updated once a second. */
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
  uplink = $state.raw<PositionUplink | null>(null);
  readonly #ports: PhonePorts;
  #stopSource: (() => void) | null = null;
  /** The time and stage at which the problem arose, and whether the cloud was not reached. */
  #origin: { at: number; stage: FollowStage | null; unreached: boolean } | null = null;

  constructor(ports: PhonePorts) {
    this.#ports = ports;
  }

  get follow(): Follow | null {
    return this.#ports.follows.find(this.followId);
  }

  /** Begins periodic updates; returns how to end. */
  open(): () => void {
    const handle = setInterval(() => this.update(Date.now()), UPDATE_MILLISECONDS);
    return () => {
      clearInterval(handle);
      this.#stopLocating();
      this.#closeUplink();
    };
  }

  update(now: number): void {
    const gap = now - this.now;
    this.now = now;
    this.online = navigator.onLine;
    if (gap > SLEPT_MILLISECONDS) {
      this.absence.suspect('asleep', now);
      this.uplink?.resumed();
    } else if (this.uplink !== null && this.uplink.cutOffSince !== null) {
      this.absence.suspect(this.online ? 'unanswered' : 'cut', now);
    } else if (this.fix === null || now - this.fix.at > WARN_AFTER_SECONDS * 1000) {
      this.absence.suspect('blind', now);
    }
    this.#watch();
    this.#forgetProblem();
    this.uplink?.keepAlive();
  }

  /** Drops the problem when its stage is over, or the outage that caused it. */
  #forgetProblem(): void {
    const origin = this.#origin;
    if (origin === null) {
      return;
    }
    const reached = this.uplink !== null && this.uplink.cutOffSince === null;
    const over = origin.unreached && reached && this.now - origin.at >= READ_MILLISECONDS;
    if (over || origin.stage !== (this.follow?.state ?? null)) {
      this.#origin = null;
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
        this.uplink?.offer(fix);
      },
      onLocating: (locating) => (this.locating = locating),
    });
  }

  /** A follow of mine that is under way from before the page was closed. */
  resume(follow: Follow): void {
    this.#adopt(follow);
    this.absence.suspect('gone', this.now);
  }

  #adopt(follow: Follow): void {
    this.followId = follow.id;
    this.problem = null;
    this.#watch();
    this.#openUplink(follow);
  }

  async ask(order: Omit<FollowOrder, 'latitude' | 'longitude'>): Promise<void> {
    const { fix } = this;
    if (fix !== null) {
      await this.#attempt('ask', async () => {
        const { latitude, longitude } = fix;
        this.#adopt(await this.#ports.follows.open({ latitude, longitude, ...order }));
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
    this.#closeUplink();
    this.followId = null;
    this.problem = null;
  }

  /** The connection to the cloud is back. */
  reconnected(): void {
    this.uplink?.retryNow();
  }

  #openUplink(follow: Follow): void {
    this.#closeUplink();
    if (follow.state !== 'over') {
      this.uplink = new PositionUplink(this.#ports.sender(follow.id), systemTimers);
      if (this.fix !== null) {
        this.uplink.offer(this.fix);
      }
    }
  }

  /** The cloud needs no positions any more. */
  #closeUplink(): void {
    this.uplink?.close();
    this.uplink = null;
  }

  closeIfOver(): void {
    if (this.follow?.state === 'over') {
      this.#closeUplink();
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
      this.#origin = null;
    } catch (thrown) {
      const unreached = thrown instanceof Problem && thrown.status === 0;
      const stage = this.follow?.state ?? null;
      this.#origin = { at: this.now, stage, unreached };
      this.problem =
        unreached && stage !== null && what !== 'ask' && what !== 'place'
          ? notDoneText(what, stage, navigator.onLine)
          : sentenceFor(thrown);
    } finally {
      this.busy = null;
    }
  }
}
