import { describe, expect, it } from 'vitest';
import { ANSWER_MILLISECONDS, type Positions, type Receipt } from '../api/follows';
import { Problem } from '../api/problem';
import type { Fix } from './fix';
import { FixBuffer, MOST_FIXES } from './fix-buffer';
import { LOST_MILLISECONDS, PositionUplink, RETRY_MILLISECONDS } from './position-uplink.svelte';

const fix = (at: number): Fix => ({ at, latitude: 47, longitude: 8, accuracy: 5, speed: null, course: null });

/** A clock that the test moves, and a cloud that answers when the test says so. */
class Bench {
  now = 1_000_000;
  #answered = 0;
  readonly sent: Positions[] = [];
  #answers: { resolve: (receipt: Receipt) => void; reject: (thrown: unknown) => void }[] = [];
  #timers: { at: number; action: () => void }[] = [];
  readonly uplink = new PositionUplink(
    (positions) =>
      new Promise((resolve, reject) => {
        this.sent.push(positions);
        this.#answers.push({ resolve, reject });
      }),
    {
      now: () => this.now,
      after: (milliseconds, action) => {
        const timer = { at: this.now + milliseconds, action };
        this.#timers.push(timer);
        return () => (this.#timers = this.#timers.filter((one) => one !== timer));
      },
    },
    () => this.now,
  );

  async pass(milliseconds: number): Promise<void> {
    this.now += milliseconds;
    const due = this.#timers.filter(({ at }) => at <= this.now);
    this.#timers = this.#timers.filter(({ at }) => at > this.now);
    due.forEach(({ action }) => action());
    await settled();
  }

  /** The cloud deals with all of them, with those up to a time, or with none. */
  async answer(problem?: Problem | Receipt): Promise<void> {
    const waiting = this.#answers.shift();
    if (!(problem instanceof Problem)) {
      const all = times(this.sent[this.#answered]).at(-1) ?? null;
      this.#answered += 1;
      waiting?.resolve(problem ?? { upTo: all });
    } else {
      this.#answered += 1;
      waiting?.reject(problem);
    }
    await settled();
  }
}

const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
const times = (positions: Positions | undefined): number[] =>
  (positions?.positions ?? []).map(({ at }) => Date.parse(at));

describe('fixes that wait', () => {
  it('are the newest sixty, and what had no room is counted', () => {
    const buffer = new FixBuffer();
    for (let at = 0; at < MOST_FIXES + 5; at++) {
      buffer.add(fix(at));
    }
    expect(buffer.pending.map(({ at }) => at)).toEqual(
      Array.from({ length: MOST_FIXES }, (_, index) => index + 5),
    );
    expect(buffer.dropped).toBe(5);
  });

  it('are not said twice when the receiver repeats itself', () => {
    const buffer = new FixBuffer();
    buffer.add(fix(5));
    buffer.add(fix(5));
    buffer.add(fix(4));
    expect(buffer.pending).toHaveLength(1);
  });
});

describe('the uplink to the cloud', () => {
  it('says one thing at a time, and what came meanwhile together', async () => {
    const bench = new Bench();
    bench.uplink.offer(fix(bench.now));
    bench.uplink.offer(fix(bench.now + 1));
    bench.uplink.offer(fix(bench.now + 2));
    expect(bench.sent).toHaveLength(1);
    bench.now += 120;
    await bench.answer();
    expect(times(bench.sent[1])).toEqual([1_000_001, 1_000_002]);
    expect(bench.sent[1]?.roundTrip).toBe(120);
  });

  it('says again what got lost, and since when it is cut off', async () => {
    const bench = new Bench();
    bench.uplink.offer(fix(bench.now));
    await bench.answer();
    const taken = bench.now;
    await bench.pass(1000);
    bench.uplink.offer(fix(bench.now));
    await bench.answer(Problem.unreachable());
    expect(bench.uplink.cutOffSince).toBe(taken);

    await bench.pass(RETRY_MILLISECONDS);
    expect(times(bench.sent[2])).toEqual([1_001_000]);
    await bench.answer();
    expect(bench.uplink.cutOffSince).toBeNull();
  });

  it('waits for no answer that does not come', async () => {
    const bench = new Bench();
    bench.uplink.offer(fix(bench.now));
    await bench.pass(ANSWER_MILLISECONDS);
    expect(bench.uplink.cutOffSince).not.toBeNull();
    await bench.pass(RETRY_MILLISECONDS);
    expect(bench.sent).toHaveLength(2);
  });

  it('tries at once when the network is back', async () => {
    const bench = new Bench();
    bench.uplink.offer(fix(bench.now));
    await bench.answer(Problem.unreachable());
    bench.uplink.retryNow();
    expect(bench.sent).toHaveLength(2);
  });

  it('keeps what it saw without a network, and says all of it when there is one', async () => {
    const bench = new Bench();
    for (let second = 0; second < 30; second++) {
      bench.uplink.offer(fix(bench.now));
      await bench.answer(Problem.unreachable());
      await bench.pass(1000);
    }
    expect(times(bench.sent.at(-1))).toHaveLength(30);
    expect(bench.uplink.cutOffSince).toBe(1_000_000);
  });

  it('says again what a receipt does not cover', async () => {
    const bench = new Bench();
    bench.uplink.offer(fix(bench.now));
    bench.uplink.offer(fix(bench.now + 1));
    bench.uplink.offer(fix(bench.now + 2));
    await bench.answer();
    await bench.answer({ upTo: bench.now + 1 });
    expect(times(bench.sent[2])).toEqual([1_000_002]);
    await bench.answer({ upTo: null });
    expect(bench.uplink.cutOffSince).not.toBeNull();
    await bench.pass(RETRY_MILLISECONDS);
    expect(times(bench.sent[3])).toEqual([1_000_002]);
  });

  it('says that the phone is there when it does not know where it is', async () => {
    const bench = new Bench();
    bench.uplink.offer(fix(bench.now));
    await bench.answer();
    bench.uplink.keepAlive();
    expect(bench.sent).toHaveLength(1);
    await bench.pass(LOST_MILLISECONDS);
    bench.uplink.keepAlive();
    expect(bench.sent[1]?.positions).toEqual([]);
    await bench.answer({ upTo: null });
    expect(bench.uplink.cutOffSince).toBeNull();
  });

  it('does not repeat what the cloud does not want, and says why', async () => {
    const bench = new Bench();
    bench.uplink.offer(fix(bench.now));
    await bench.answer(new Problem({ status: 409, detail: 'This follow is over.' }));
    expect(bench.uplink.refused).toBe('This follow is over.');
    expect(bench.uplink.cutOffSince).toBeNull();
    await bench.pass(10_000);
    expect(bench.sent).toHaveLength(1);
  });

  it('says again what an overloaded cloud did not take', async () => {
    const bench = new Bench();
    bench.uplink.offer(fix(bench.now));
    await bench.answer(new Problem({ status: 429, detail: 'Slower.' }));
    await bench.pass(RETRY_MILLISECONDS);
    expect(bench.sent).toHaveLength(2);
  });

  it('is silent once it is closed', async () => {
    const bench = new Bench();
    bench.uplink.offer(fix(bench.now));
    await bench.answer(Problem.unreachable());
    bench.uplink.close();
    bench.uplink.offer(fix(bench.now + 1));
    await bench.pass(10_000);
    expect(bench.sent).toHaveLength(1);
  });
});
