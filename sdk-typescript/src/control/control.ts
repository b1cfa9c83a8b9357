import type { CommandRequest, ControlView, DroneView } from '../contract/schemas.js';
import type { RestOperations } from '../contract/operations.js';
import { persistently } from '../rest/patience.js';
import { Problem } from '../rest/problem.js';
import type { Timers } from '../stream/stream-client.js';

/** What becomes of a drone that is in the air when control of it ends. */
export type OnExit = 'returnHome' | 'land' | 'hold' | 'keep';

export interface ControlOptions {
  /**
   * returnHome unless told. Hold and keep leave it in the air: the cloud brings home what waits there for orders, when
   * nobody takes control for half a minute.
   */
  readonly onExit?: OnExit | undefined;
  /** Takes it from whoever has it, with this reason that all can read; for supervisors. */
  readonly takeOver?: string | undefined;
  readonly signal?: AbortSignal | undefined;
}

export interface ControlPorts {
  readonly rest: RestOperations;
  readonly timers: Timers;
  /** Gives a command and waits for its outcome. */
  command(request: CommandRequest): Promise<unknown>;
  /** Called once it is given back or lost. */
  ended(): void;
}

/** The server misses three of these before it calls a holder lost. */
const HEARTBEAT_MILLISECONDS = 2_000;
const ANSWER_MILLISECONDS = 4_000;
const PATIENCE_MILLISECONDS = 30_000;

const COMMANDS = { returnHome: 'returnToLaunch', land: 'land', hold: 'hold' } as const;

/** Control of a drone ended otherwise than by giving it back. */
export class ControlLost extends Error {
  constructor(why: string) {
    super(`Control is lost: ${why}`);
    this.name = 'ControlLost';
  }
}

/** Control of one drone, kept by heartbeats until `end`, which `await using` calls by itself. */
export class Control implements AsyncDisposable {
  readonly drone: string;
  readonly #ports: ControlPorts;
  readonly #onExit: OnExit;
  readonly #lost = new AbortController();
  #epoch: number;
  #cancelHeartbeat: () => void = () => undefined;
  #ending: Promise<void> | null = null;

  private constructor(drone: string, epoch: number, ports: ControlPorts, onExit: OnExit) {
    this.drone = drone;
    this.#epoch = epoch;
    this.#ports = ports;
    this.#onExit = onExit;
    this.#plan();
  }

  static async take(
    drone: string,
    ports: ControlPorts,
    { onExit = 'returnHome', takeOver, signal }: ControlOptions,
  ): Promise<Control> {
    const { rest } = ports;
    const { epoch } =
      takeOver === undefined
        ? await rest.takeControl({ id: drone }, { signal })
        : await rest.takeOverControl({ id: drone }, { reason: takeOver }, { signal });
    return new Control(drone, epoch, ports, onExit);
  }

  /** Of this control; commands that name it are refused once it has ended. */
  get epoch(): number {
    return this.#epoch;
  }

  /** Ends with a `ControlLost` when somebody else has the drone. */
  get signal(): AbortSignal {
    return this.#lost.signal;
  }

  /** Asks for the epoch; true: it is another one than before. */
  async renew(): Promise<boolean> {
    const before = this.#epoch;
    await this.#heartbeat();
    return this.#epoch !== before;
  }

  /** Does with a drone in the air what was agreed, and gives control back. Once, however often it is called. */
  end(): Promise<void> {
    this.#ending ??= this.#end();
    return this.#ending;
  }

  [Symbol.asyncDispose](): Promise<void> {
    return this.end();
  }

  async #end(): Promise<void> {
    try {
      if (!this.signal.aborted && this.#onExit !== 'keep') {
        await this.#bringToSafety(COMMANDS[this.#onExit]);
      }
    } finally {
      this.#cancelHeartbeat();
      this.#ports.ended();
      if (!this.signal.aborted) {
        await this.#ports.rest.releaseControl({ id: this.drone }, { timeout: ANSWER_MILLISECONDS });
      }
    }
  }

  async #bringToSafety(type: 'returnToLaunch' | 'land' | 'hold'): Promise<void> {
    const { rest, timers } = this.#ports;
    const look = (): Promise<DroneView> =>
      rest.getDrone({ id: this.drone }, { timeout: ANSWER_MILLISECONDS });
    if (isAirborne(await persistently(timers, PATIENCE_MILLISECONDS, this.signal, look))) {
      await this.#ports.command({ type });
    }
  }

  #plan(): void {
    this.#cancelHeartbeat = this.#ports.timers.after(HEARTBEAT_MILLISECONDS, () => {
      this.#plan();
      void this.#heartbeat();
    });
  }

  async #heartbeat(): Promise<void> {
    const epoch = this.#epoch;
    try {
      const control: ControlView = await this.#ports.rest.keepControl(
        { id: this.drone },
        { epoch },
        { timeout: ANSWER_MILLISECONDS },
      );
      // A server that was restarted gives the control another epoch.
      this.#epoch = control.epoch;
    } catch (thrown) {
      // Without an answer it is still held: the connection may be back in time.
      if (thrown instanceof Problem && thrown.status >= 400 && thrown.status < 500 && !thrown.mayPass) {
        this.#lose(thrown.detail);
      }
    }
  }

  #lose(why: string): void {
    this.#cancelHeartbeat();
    this.#ports.ended();
    this.#lost.abort(new ControlLost(why));
  }
}

/** What is coming down already is left alone; of what nobody knows where it is, motors that turn count. */
function isAirborne({ flight, armed }: DroneView): boolean {
  return flight === 'takingOff' || flight === 'inAir' || (flight === null && armed === true);
}
