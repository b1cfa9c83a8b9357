import type { CommandRequest, CommandView } from '../contract/schemas.js';
import type { RestOperations } from '../contract/operations.js';
import { persistently } from '../rest/patience.js';
import { Problem } from '../rest/problem.js';
import type { Timers } from '../stream/stream-client.js';
import { OutcomeUnknown, Refused } from './command-error.js';

export interface GiveOptions {
  readonly signal?: AbortSignal | undefined;
  /** Milliseconds in which it is tried again while the server cannot be reached or is busy: 30,000 unless told. */
  readonly timeout?: number | undefined;
}

export interface GivePorts {
  readonly rest: RestOperations;
  readonly timers: Timers;
}

/** With an id: the same id acts once, however often it is given. */
export type IdentifiedRequest = CommandRequest & { readonly id: string };

const PATIENCE_MILLISECONDS = 30_000;
const ANSWER_MILLISECONDS = 10_000;

/** Gives a command, again and again with the same id while there is no answer. */
export async function give(
  { rest, timers }: GivePorts,
  drone: string,
  request: IdentifiedRequest,
  { signal, timeout = PATIENCE_MILLISECONDS }: GiveOptions,
): Promise<CommandView> {
  let perhapsGiven = false;
  const attempt = async (): Promise<CommandView> => {
    try {
      return await rest.giveCommand({ id: drone }, request, { signal, timeout: ANSWER_MILLISECONDS });
    } catch (thrown) {
      const problem = asRefusal(thrown);
      perhapsGiven ||= problem.status === 0;
      throw problem;
    }
  };
  try {
    return await persistently(timers, timeout, signal, attempt);
  } catch (thrown) {
    throw perhapsGiven && thrown instanceof Problem ? unknown(request, thrown) : thrown;
  }
}

/** Whatever is no problem at all is thrown on, and what the gate refuses as the outcome that it is. */
function asRefusal(thrown: unknown): Problem {
  if (!(thrown instanceof Problem)) {
    throw thrown;
  }
  if (thrown.status === 409 && thrown.commandId !== null) {
    const { message: reason, code, commandId } = thrown;
    throw new Refused({ reason, code, by: 'gate', id: commandId });
  }
  return thrown;
}

function unknown({ id, type }: IdentifiedRequest, problem: Problem): OutcomeUnknown {
  const reason = `Whether ${type} was given is not known: ${problem.detail}`;
  return new OutcomeUnknown({ reason, code: problem.code, id });
}
