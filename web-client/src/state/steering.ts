import type { StreamMessage, StreamRequest, Velocity } from '../api/types';

/** What one control on the page steers a drone by. */
export interface SteeringLine {
  /** False when there is no line to the cloud. */
  steer: (velocity: Velocity) => boolean;
  letGo: () => void;
  close: () => void;
}

type Refused = (why: string) => void;

/** Takes speeds from controls to the stream, and its refusals back to them. */
export class SteeringLines {
  readonly #say: (request: StreamRequest) => boolean;
  readonly #epochOf: (drone: string) => number | undefined;
  readonly #open = new Map<string, { drone: string; onRefused: Refused }>();
  #number = 0;

  /** `epochOf`: of the control that this window keeps. */
  constructor(say: (request: StreamRequest) => boolean, epochOf: (drone: string) => number | undefined) {
    this.#say = say;
    this.#epochOf = epochOf;
  }

  open(drone: string, onRefused: Refused): SteeringLine {
    this.#number += 1;
    const requestId = `steer-${String(this.#number)}`;
    this.#open.set(requestId, { drone, onRefused });
    return {
      steer: (velocity) => {
        const epoch = this.#epochOf(drone);
        const request = { type: 'steer', requestId, drone, velocity } as const;
        return this.#say(epoch === undefined ? request : { ...request, epoch });
      },
      letGo: () => {
        this.#say({ type: 'letGo', requestId, drone });
      },
      close: () => {
        this.#open.delete(requestId);
      },
    };
  }

  /** True when that was the answer to one of them. */
  hear(message: Extract<StreamMessage, { type: 'error' }>): boolean {
    const line = message.requestId === undefined ? undefined : this.#open.get(message.requestId);
    line?.onRefused(message.problem.detail ?? 'The cloud takes no speeds now.');
    return line !== undefined;
  }
}
