import type { CommandRequest, DroneView } from './contract/schemas.js';
import type { RestOperations } from './contract/operations.js';
import { give, type GiveOptions } from './command/give.js';
import { errorOf, Refused } from './command/command-error.js';
import { GivenCommand } from './command/given-command.js';
import { sentenceFor } from './rest/problem.js';
import { Control, type ControlOptions } from './control/control.js';
import type { Timers } from './stream/stream-client.js';
import { Deadline } from './timing.js';
import { newUuid } from './uuid.js';
import type { SharedStream } from './watch/shared-stream.js';
import { readable, statesOf, type StatesOptions } from './watch/watching.js';

/** The server waits for the vehicle's answer for 8 s. */
const SPEED_MILLISECONDS = 30_000;

export interface DronePorts {
  readonly rest: RestOperations;
  readonly stream: SharedStream;
  readonly timers: Timers;
}

export interface CommandOptions extends GiveOptions {
  /** Your own id, 8 to 64 of A-Z a-z 0-9 _ -: the same id twice acts once. A new one unless told. */
  readonly id?: string | undefined;
}

export interface WaitOptions extends StatesOptions {
  /** Milliseconds after which it is waited for no longer. Without: as long as it takes. */
  readonly timeout?: number | undefined;
}

/** What was waited for did not come in time, or cannot come any more. */
export class WaitEnded extends Error {
  constructor(sentence: string) {
    super(sentence);
    this.name = 'WaitEnded';
  }
}

/** One drone of the cloud: what it does, and what it shall do. */
export class Drone {
  readonly id: string;
  readonly name: string;
  readonly #ports: DronePorts;
  #control: Control | null = null;

  constructor({ id, name }: Pick<DroneView, 'id' | 'name'>, ports: DronePorts) {
    this.id = id;
    this.name = name;
    this.#ports = ports;
  }

  /** As it is now. */
  state(options: { readonly signal?: AbortSignal | undefined } = {}): Promise<DroneView> {
    return this.#ports.rest.getDrone({ id: this.id }, options);
  }

  /** Its state now, then each newer one, over lost connections too. Ends when the drone is removed. */
  states(options: StatesOptions = {}): AsyncIterable<DroneView> {
    return readable(() => statesOf(this.id, this.#ports, options));
  }

  /** @throws WaitEnded when it does not come true in time */
  async waitFor(
    condition: (state: DroneView) => boolean,
    { timeout, signal, rate }: WaitOptions = {},
  ): Promise<DroneView> {
    const late = (): Error => this.#ended(`within ${(timeout ?? 0) / 1000} s`);
    const deadline = new Deadline(this.#ports.timers, timeout, late, signal);
    try {
      for await (const state of this.states({ rate, signal: deadline.signal })) {
        if (condition(state)) {
          return state;
        }
      }
    } finally {
      deadline.end();
    }
    throw this.#ended('before the drone was removed');
  }

  /**
   * Resolves when the server has taken the command, which is tried again over a lost connection and acts once; `outcome`
   * of what it resolves with tells how it ended. Under a control that was taken here it says so, and is refused when
   * that has ended.
   *
   * @throws Refused when the gate refuses it, OutcomeUnknown when whether it was taken is not known, else Problem
   */
  async command(request: CommandRequest, { id, ...options }: CommandOptions = {}): Promise<GivenCommand> {
    const control = this.#control;
    try {
      return await this.#give(request, id ?? newUuid(), options);
    } catch (thrown) {
      // A server that was restarted has given the control another epoch, which it tells with a heartbeat.
      const mayBeRenewed = thrown instanceof Refused && thrown.code === 'control-ended' && id === undefined;
      if (mayBeRenewed && (await control?.renew()) === true) {
        return this.#give(request, newUuid(), options);
      }
      throw thrown;
    }
  }

  /**
   * Goes on at that speed in m/s, over the ground or, what flies on wings alone, through the air, until its mode changes;
   * resolves when the vehicle does. A speed that its kind does not go at is refused with the range.
   *
   * @throws as `command` and `outcome`; OutcomeUnknown also when the vehicle has not answered within 30 s
   */
  async changeSpeed(metersPerSecond: number, options: CommandOptions = {}): Promise<void> {
    const given = await this.command({ type: 'changeSpeed', metersPerSecond }, options);
    await given.outcome({ signal: options.signal, timeout: SPEED_MILLISECONDS });
  }

  async #give(request: CommandRequest, id: string, options: GiveOptions): Promise<GivenCommand> {
    const held = this.#control === null ? {} : { epoch: this.#control.epoch };
    const view = await give(this.#ports, this.id, { ...held, ...request, id }, options);
    const error = view.outcome?.result === 'refused' ? errorOf(view, view.outcome) : null;
    if (error !== null) {
      throw error;
    }
    return new GivenCommand(view, this.#ports);
  }

  /** Takes control and keeps it until `end`, or until the work is done or fails. */
  control(options?: ControlOptions): Promise<Control>;
  control<T>(work: (control: Control) => Promise<T>, options?: ControlOptions): Promise<T>;
  async control<T>(
    first: ControlOptions | ((control: Control) => Promise<T>) = {},
    options: ControlOptions = {},
  ): Promise<Control | T> {
    if (typeof first !== 'function') {
      return this.#take(first);
    }
    const control = await this.#take(options);
    const work = async (): Promise<T> => first(control);
    const result = await work().catch(async (thrown: unknown) => {
      await control.end().catch((other: unknown) => {
        throw new AggregateError([thrown, other], `${sentenceFor(thrown)} After that: ${sentenceFor(other)}`);
      });
      throw thrown;
    });
    await control.end();
    return result;
  }

  async #take(options: ControlOptions): Promise<Control> {
    const { rest, timers } = this.#ports;
    const command = async (request: CommandRequest): Promise<unknown> =>
      (await this.command(request)).outcome({ timeout: 30_000 });
    const ended = (): void => {
      if (this.#control === control) {
        this.#control = null;
      }
    };
    const control = await Control.take(this.id, { rest, timers, command, ended }, options);
    this.#control = control;
    return control;
  }

  #ended(when: string): WaitEnded {
    return new WaitEnded(`What was waited for did not come true for ${this.name} ${when}.`);
  }
}
