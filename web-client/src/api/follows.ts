import type {
  FollowView as Follow,
  FollowNowView as FollowNow,
  FollowOpenRequest as FollowOrder,
  FollowPlaceView as FollowPlace,
  FollowPlaceRequest as PlaceChange,
  FollowPositionsRequest as Positions,
  FollowReceipt,
  RestOperations,
} from '@dronemap/client';

export type { Follow, FollowNow, FollowOrder, FollowPlace, PlaceChange, Positions };
export type { FollowOtherView as FollowOther } from '@dronemap/client';

export type FollowStage = Follow['state'];

/** The part of an answer to positions that the page reads. */
export type Receipt = Pick<FollowReceipt, 'upTo'>;

export type FollowSide = FollowPlace['side'];

/** asleep: its page stands still; cut: it has no network; gone: its page was closed; vague: it says where it is, too vaguely. */
export type PhoneReach = NonNullable<FollowNow['reach']>;

/** A phone between two cells answers nothing for long; by then newer positions wait. */
export const ANSWER_MILLISECONDS = 4_000;

/** The calls about follows; each action returns the new state of the follow. */
export class FollowCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  async all(): Promise<Follow[]> {
    return (await this.#rest.listFollows()).follows;
  }

  one(id: string): Promise<Follow> {
    return this.#rest.getFollow({ id }, { timeout: ANSWER_MILLISECONDS });
  }

  open(order: FollowOrder): Promise<Follow> {
    return this.#rest.openFollow(order);
  }

  change(id: string, place: PlaceChange): Promise<Follow> {
    return this.#rest.changeFollow({ id }, place);
  }

  positions(id: string, positions: Positions): Promise<Receipt> {
    return this.#rest.reportFollowPositions({ id }, positions, { timeout: ANSWER_MILLISECONDS });
  }

  act(id: string, action: FollowAction): Promise<Follow> {
    return this.#rest[ACTIONS[action]]({ id });
  }
}

export type FollowAction = 'start' | 'cancel' | 'pause' | 'continue' | 'stop';

const ACTIONS = {
  start: 'startFollow',
  cancel: 'cancelFollow',
  pause: 'pauseFollow',
  continue: 'continueFollow',
  stop: 'stopFollow',
} as const satisfies Record<FollowAction, keyof RestOperations>;
