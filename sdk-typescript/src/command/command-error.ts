import type { CommandOutcomeView, CommandView } from '../contract/schemas.js';

interface Told {
  /** A sentence for people. */
  readonly reason: string;
  /** Why exactly, for programs; empty where nothing is said. */
  readonly code?: string | null | undefined;
  readonly by?: string | null | undefined;
  /** The id of the command. */
  readonly id: string;
  /** As it stands; null: the server has told nothing of it. */
  readonly command?: CommandView | null | undefined;
}

/** A command that did not succeed. The message is the reason, as the server or the vehicle words it. */
export abstract class CommandError extends Error {
  readonly reason: string;
  readonly code: string;
  readonly commandId: string;
  readonly command: CommandView | null;

  constructor({ reason, code, id, command }: Told) {
    super(reason);
    this.name = new.target.name;
    this.reason = reason;
    this.code = code ?? '';
    this.commandId = id;
    this.command = command ?? null;
  }
}

/** It was not carried out. `by`: the gate, which sent nothing to the vehicle, or the vehicle. */
export class Refused extends CommandError {
  readonly by: string;

  constructor(told: Told) {
    super(told);
    this.by = told.by ?? 'gate';
  }
}

/** The vehicle accepted it, but it did not happen. */
export class Failed extends CommandError {}

/** The vehicle did not answer in the time that it has. */
export class TimedOut extends CommandError {}

/** A newer command took its place, or another holder of control. */
export class Superseded extends CommandError {}

/** It may or may not have been carried out: look at the drone. */
export class OutcomeUnknown extends CommandError {}

const KINDS: Readonly<Record<string, new (told: Told) => CommandError>> = {
  refused: Refused,
  failed: Failed,
  timedOut: TimedOut,
  superseded: Superseded,
};

const WORDS: Readonly<Record<string, string>> = {
  refused: 'was refused',
  failed: 'failed',
  timedOut: 'was not answered in time',
  superseded: 'was superseded by a newer command',
};

/** null: it succeeded. An outcome that this client does not know is as good as none. */
export function errorOf(
  command: CommandView,
  { result, by, reason, code }: CommandOutcomeView,
): CommandError | null {
  if (result === 'succeeded') {
    return null;
  }
  const words = WORDS[result] ?? 'may or may not have been carried out; look at the drone';
  const told = { reason: reason ?? `“${command.summary}” ${words}.`, by, code, id: command.id, command };
  return new (KINDS[result] ?? OutcomeUnknown)(told);
}
