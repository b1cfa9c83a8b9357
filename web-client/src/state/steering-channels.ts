import type { StreamMessage, StreamRequest, Velocity } from '../api/types';

/** A channel by which one control on the page sends velocity setpoints to a drone. */
export interface SteeringChannel {
  /** False without a connection to the cloud. */
  steer: (velocity: Velocity) => boolean;
  letGo: () => void;
  close: () => void;
}

type Refused = (why: string) => void;

/** Sends velocity setpoints of controls on the stream, and passes refusals back to them. */
export class SteeringChannels {
  readonly #send: (request: StreamRequest) => boolean;
  readonly #epochOf: (drone: string) => number | undefined;
  readonly #open = new Map<string, { drone: string; onRefused: Refused }>();
  #number = 0;

  /** `epochOf`: the epoch of the lease that this window holds. */
  constructor(send: (request: StreamRequest) => boolean, epochOf: (drone: string) => number | undefined) {
    this.#send = send;
    this.#epochOf = epochOf;
  }

  open(drone: string, onRefused: Refused): SteeringChannel {
    this.#number += 1;
    const requestId = `steer-${String(this.#number)}`;
    this.#open.set(requestId, { drone, onRefused });
    return {
      steer: (velocity) => {
        const epoch = this.#epochOf(drone);
        const request = { type: 'steer', requestId, drone, velocity } as const;
        return this.#send(epoch === undefined ? request : { ...request, epoch });
      },
      letGo: () => {
        this.#send({ type: 'letGo', requestId, drone });
      },
      close: () => {
        this.#open.delete(requestId);
      },
    };
  }

  /** Whether the error answers a setpoint of one of these channels. */
  reject(message: Extract<StreamMessage, { type: 'error' }>): boolean {
    const channel = message.requestId === undefined ? undefined : this.#open.get(message.requestId);
    channel?.onRefused(message.problem.detail ?? 'The cloud accepts no velocity setpoints now.');
    return channel !== undefined;
  }
}
