import type { EventGap, NumberedEvent } from '../contract/schemas.js';
import type { RestOperations } from '../contract/operations.js';
import { Patience } from '../rest/patience.js';
import { Problem } from '../rest/problem.js';
import type { Timers } from '../stream/stream-client.js';

export interface EventsOptions {
  /** The `resume` of one that was read earlier; `first`: from the oldest that is kept. Without: from now on. */
  readonly after?: string | undefined;
  /** Ids of the drones of which events are told; without: of all. At most 200. */
  readonly drones?: readonly string[] | undefined;
  readonly signal?: AbortSignal | undefined;
}

/** What happened to a drone, or where events are missing. To go on after it, also in another program: its `resume`. */
export type DroneEvent = { readonly resume: string } & (
  ({ readonly type: 'event' } & NumberedEvent) | ({ readonly type: 'gap' } & EventGap)
);

const WAIT_SECONDS = 30;
/** Longer than the server waits: without an answer the line is dead. */
const ANSWER_MILLISECONDS = 45_000;

/**
 * Each event once, in their order, over lost connections. Only the `resume` of the last of those that came together goes
 * on behind it; those before it lead back to the first, so that none is missed.
 */
export async function* eventsOf(
  { rest, timers }: { readonly rest: RestOperations; readonly timers: Timers },
  { after, drones, signal }: EventsOptions,
): AsyncGenerator<DroneEvent, void, undefined> {
  const patience = new Patience(timers);
  const chosen = drones === undefined ? {} : { drones: drones.join() };
  let place = after;
  for (;;) {
    const wait = place === undefined ? {} : { after: place, wait: WAIT_SECONDS };
    try {
      const answer = await rest.followEvents(
        { ...wait, ...chosen },
        { signal, timeout: ANSWER_MILLISECONDS },
      );
      patience.reset();
      const before = place ?? answer.next;
      const told = inOrder(answer.events, answer.gaps);
      for (const [index, one] of told.entries()) {
        yield { ...one, resume: index === told.length - 1 ? answer.next : before };
      }
      place = answer.next;
    } catch (thrown) {
      if (!(thrown instanceof Problem && thrown.mayPass)) {
        throw thrown;
      }
      await patience.wait(patience.afterProblem(thrown), signal);
    }
  }
}

type Told = ({ readonly type: 'event' } & NumberedEvent) | ({ readonly type: 'gap' } & EventGap);

/** A gap stands before the events with higher numbers. */
function inOrder(events: readonly NumberedEvent[], gaps: readonly EventGap[]): Told[] {
  const told: Told[] = events.map((event) => ({ type: 'event', ...event }));
  for (const gap of gaps) {
    const behind = told.findIndex((one) => one.type === 'event' && one.number > gap.after);
    told.splice(behind === -1 ? told.length : behind, 0, { type: 'gap', ...gap });
  }
  return told;
}
