import type { Follow, PhoneReach } from '../api/follows';
import { HOLDS_AFTER_SECONDS, WARN_AFTER_SECONDS } from './outage';

/** blind: the phone was there, and did not know where it is; unanswered: it had a network, and received nothing from the cloud. */
export type AbsenceReason = Exclude<PhoneReach, 'speaks'> | 'blind' | 'unanswered';

/** The newest time during which the cloud had no positions of the phone. */
export interface Absence {
  why: AbsenceReason;
  seconds: number;
  /** Seconds that the drone stood still, if the cloud led it all the time. */
  waited: number;
  /** The time of the last position before it, by the cloud's clock. */
  from: number;
  /** The time at which the page noticed its end, by the phone's clock. */
  until: number;
}

/** The rank of each reason: a phone that sleeps loses its network too. */
const RANKS: Record<AbsenceReason, number> = {
  blind: 0,
  vague: 0,
  unanswered: 1,
  cut: 2,
  gone: 3,
  asleep: 4,
};

/** So soon after a page was opened again its next standstill belongs to that: it is busy with what it shows. */
const TOGETHER_SECONDS = 3;

/** Notices that the cloud has positions again after it had none: how long by the cloud's clock, why by what both know. */
export class AbsenceWatch {
  last = $state.raw<Absence | null>(null);
  #follow: string | null = null;
  #lastPosition: number | null = null;
  #known: AbsenceReason | null = null;
  #reported: AbsenceReason | null = null;
  /** The time at which a reason was last noticed, by the phone's clock. */
  #noticed = 0;
  /** From when to when the newest absence was, by the cloud's clock. */
  #span = { from: -Infinity, to: -Infinity };

  /** Notes a reason that the page itself knows, since the last position; `now` by the phone's clock. */
  suspect(why: AbsenceReason, now: number): void {
    this.#noticed = now;
    if (this.#known === null || RANKS[why] > RANKS[this.#known]) {
      this.#known = why;
    }
  }

  /** Compares the follow with the last one; to be called often. `now` by the phone's clock. */
  update(follow: Follow, now: number): void {
    if (follow.id !== this.#follow) {
      this.#begin(follow.id);
    }
    const phone = follow.now?.phone ?? null;
    const reach = follow.now?.reach ?? null;
    if (reach !== null && reach !== 'speaks') {
      this.#reported = reach;
      this.#noticed = now;
    }
    if (phone === null) {
      return;
    }
    const receivedAt = Date.parse(phone.heard);
    if (this.#lastPosition === null || receivedAt > this.#lastPosition) {
      this.#compare(follow, receivedAt, now);
      this.#lastPosition = receivedAt;
    }
  }

  #begin(id: string): void {
    this.#follow = id;
    this.#lastPosition = null;
    this.#reported = null;
    this.last = null;
  }

  #compare(follow: Follow, receivedAt: number, now: number): void {
    // A drone that follows only since then has not waited before.
    const from = Math.max(this.#lastPosition ?? receivedAt, Date.parse(follow.since));
    const seconds = Math.round((receivedAt - from) / 1000);
    const over = follow.state === 'tracking' && seconds >= WARN_AFTER_SECONDS;
    if (over) {
      this.#record(from, receivedAt, now);
    }
    // A page that wakes up first reads what was said before it slept.
    if (over || now - this.#noticed > WARN_AFTER_SECONDS * 1000) {
      this.#known = null;
      this.#reported = null;
    }
  }

  #record(from: number, to: number, now: number): void {
    const goesOn = this.last?.why === 'gone' && from - this.#span.to <= TOGETHER_SECONDS * 1000;
    const why = goesOn ? 'gone' : (this.#known ?? this.#reported ?? 'cut');
    this.#span = { from: goesOn ? this.#span.from : from, to };
    const seconds = Math.round((to - this.#span.from) / 1000);
    this.last = { why, seconds, waited: seconds - HOLDS_AFTER_SECONDS, from: this.#span.from, until: now };
  }
}
