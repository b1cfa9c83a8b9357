import type {
  FollowView as Follow,
  FollowList,
  FollowNowView as FollowNow,
  FollowOpenRequest as FollowOrder,
  FollowPlaceView as FollowPlace,
  FollowPlaceRequest as PlaceChange,
  FollowPositionsRequest as Positions,
  FollowReceipt,
} from './contract';

export type { Follow, FollowNow, FollowOrder, FollowPlace, PlaceChange, Positions };
export type { FollowOtherView as FollowOther } from './contract';

export type FollowStage = Follow['state'];

/** The part of an answer to positions that the page reads. */
export type Receipt = Pick<FollowReceipt, 'upTo'>;

export type FollowSide = FollowPlace['side'];

/** asleep: its page stands still; cut: it has no network; gone: its page was closed; vague: it says where it is, too vaguely. */
export type PhoneReach = NonNullable<FollowNow['reach']>;

/** `longest`: milliseconds until it is given up. */
type Call = <T>(method: string, path: string, body?: unknown, longest?: number) => Promise<T>;

/** A phone between two cells answers nothing for long; by then newer positions wait. */
export const ANSWER_MILLISECONDS = 4_000;

/** The calls about follows; each action returns the new state of the follow. */
export class FollowCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async all(): Promise<Follow[]> {
    return (await this.#call<FollowList>('GET', '/follows')).follows;
  }

  one(id: string): Promise<Follow> {
    return this.#call('GET', path(id), undefined, ANSWER_MILLISECONDS);
  }

  open(order: FollowOrder): Promise<Follow> {
    return this.#call('POST', '/follows', order);
  }

  change(id: string, place: PlaceChange): Promise<Follow> {
    return this.#call('PATCH', path(id), place);
  }

  positions(id: string, positions: Positions): Promise<Receipt> {
    return this.#call('POST', path(id, 'positions'), positions, ANSWER_MILLISECONDS);
  }

  act(id: string, action: FollowAction): Promise<Follow> {
    return this.#call('POST', path(id, action));
  }
}

export type FollowAction = 'start' | 'cancel' | 'pause' | 'continue' | 'stop';

function path(...parts: string[]): string {
  return ['/follows', ...parts.map(encodeURIComponent)].join('/');
}
