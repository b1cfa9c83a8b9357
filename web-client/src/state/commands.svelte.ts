import { Problem, sentenceFor } from '../api/problem';
import type { RestClient } from '../api/rest';
import type { Command, CommandKind, CommandPhase, CommandRequest, Outcome } from '../api/types';

/** One press of a control and the phase that its command has reached. */
export interface Attempt {
  id: string;
  drone: string;
  type: CommandKind;
  phase: 'sending' | CommandPhase;
  outcome: Outcome | null;
  /** Set when the cloud did not accept the request. */
  problem: string | null;
  /** The member of the request that the problem is about, where it is about one. */
  field: string | null;
  progress: { done: number; total: number } | null;
}

const PHASE_ORDER: Record<Attempt['phase'], number> = { sending: 0, sent: 1, accepted: 2, done: 3 };
const MOST_HISTORY = 50;

type CommandPort = Pick<RestClient, 'sendCommand' | 'command' | 'commandsOf'>;

/** Sends commands and follows each to its outcome, from answers and from the stream, whichever comes first. */
export class Commands {
  /** The newest attempt of each drone and command, by `drone/type`. */
  attempts = $state.raw<ReadonlyMap<string, Attempt>>(new Map());
  /** Newest first, for each drone. */
  history = $state.raw<ReadonlyMap<string, readonly Command[]>>(new Map());
  readonly #awaited = new Map<string, (ended: Attempt) => void>();
  readonly #port: CommandPort;
  readonly #newId: () => string;
  readonly #onSuccess: (attempt: Attempt) => void;

  constructor(
    port: CommandPort,
    newId: () => string,
    onSuccess: (attempt: Attempt) => void = () => undefined,
  ) {
    this.#port = port;
    this.#newId = newId;
    this.#onSuccess = onSuccess;
  }

  attempt(drone: string, type: CommandKind): Attempt | null {
    return this.attempts.get(keyOf(drone, type)) ?? null;
  }

  isUnderWay(drone: string, type: CommandKind): boolean {
    const attempt = this.attempt(drone, type);
    return attempt !== null && attempt.phase !== 'done';
  }

  /** Resolves when the cloud has accepted or refused the command; later phases appear in `attempts`. */
  async send(drone: string, request: CommandRequest): Promise<Attempt> {
    const id = this.#newId();
    const { type } = request;
    this.#put({
      id,
      drone,
      type,
      phase: 'sending',
      outcome: null,
      problem: null,
      field: null,
      progress: null,
    });
    try {
      this.apply(await this.#port.sendCommand(drone, { ...request, id }));
    } catch (thrown) {
      this.#fail(id, drone, type, thrown);
    }
    return this.attempt(drone, type) as Attempt;
  }

  /** The same, resolving when it has ended: with an outcome, or without one when the cloud did not accept it. */
  async toEnd(drone: string, request: CommandRequest): Promise<Attempt> {
    const sent = await this.send(drone, request);
    if (sent.phase === 'done') {
      return sent;
    }
    return new Promise((resolve) => this.#awaited.set(sent.id, resolve));
  }

  /** Applies an update of any command; an older phase than the known one changes nothing. */
  apply(command: Command): void {
    const attempt = this.attempt(command.drone, command.type);
    if (attempt?.id === command.id && PHASE_ORDER[command.phase] >= PHASE_ORDER[attempt.phase]) {
      const next: Attempt = {
        ...attempt,
        phase: command.phase,
        outcome: command.outcome,
        problem: null,
        field: null,
        progress: command.progress ?? attempt.progress,
      };
      this.#put(next);
      if (attempt.phase !== 'done' && next.outcome?.result === 'succeeded') {
        this.#onSuccess(next);
      }
    }
    this.#remember(command);
  }

  dismiss(drone: string, type: CommandKind): void {
    const attempts = new Map(this.attempts);
    attempts.delete(keyOf(drone, type));
    this.attempts = attempts;
  }

  async loadHistory(drone: string): Promise<void> {
    const commands = await this.#port.commandsOf(drone);
    const history = new Map(this.history);
    history.set(drone, commands);
    this.history = history;
  }

  /** After the stream was down: ask for what may have ended meanwhile. */
  async catchUp(): Promise<void> {
    const open = [...this.attempts.values()].filter((attempt) => attempt.phase !== 'done');
    for (const attempt of open) {
      try {
        this.apply(await this.#port.command(attempt.id));
      } catch (thrown) {
        this.#fail(attempt.id, attempt.drone, attempt.type, thrown);
      }
    }
  }

  #fail(id: string, drone: string, type: CommandKind, thrown: unknown): void {
    const attempt = this.attempt(drone, type);
    if (attempt?.id !== id || attempt.phase === 'done') {
      return;
    }
    const refusedByGate = thrown instanceof Problem && thrown.status === 409;
    this.#put({
      ...attempt,
      phase: 'done',
      outcome: refusedByGate
        ? { result: 'refused', by: 'gate', reason: thrown.message, code: thrown.code }
        : null,
      problem: refusedByGate ? null : sentenceFor(thrown),
      field: thrown instanceof Problem ? thrown.field : null,
    });
  }

  #put(attempt: Attempt): void {
    const before = this.attempt(attempt.drone, attempt.type);
    if (before !== null && before.id !== attempt.id) {
      this.#settle({ ...before, phase: 'done' });
    }
    this.attempts = new Map(this.attempts).set(keyOf(attempt.drone, attempt.type), attempt);
    if (attempt.phase === 'done') {
      this.#settle(attempt);
    }
  }

  #settle(ended: Attempt): void {
    this.#awaited.get(ended.id)?.(ended);
    this.#awaited.delete(ended.id);
  }

  #remember(command: Command): void {
    const known = this.history.get(command.drone) ?? [];
    const at = known.findIndex((one) => one.id === command.id);
    const old = known[at];
    if (old !== undefined && PHASE_ORDER[command.phase] < PHASE_ORDER[old.phase]) {
      return;
    }
    const next = old === undefined ? [command, ...known] : known.with(at, command);
    this.history = new Map(this.history).set(command.drone, next.slice(0, MOST_HISTORY));
  }
}

function keyOf(drone: string, type: CommandKind): string {
  return `${drone}/${type}`;
}
