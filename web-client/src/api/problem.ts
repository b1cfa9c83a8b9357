import type { ProblemBody } from './types';

/** A request that the server answered with a problem, or did not answer at all (status 0). */
export class Problem extends Error {
  readonly status: number;
  readonly field: string | null;
  readonly allowed: string | null;
  readonly commandId: string | null;
  readonly type: string;
  /** Why exactly, for programs; empty without a problem. */
  readonly code: string;

  constructor(body: ProblemBody) {
    super(sentenceOf(body));
    this.name = 'Problem';
    this.status = body.status;
    this.field = body.field ?? null;
    this.allowed = body.allowed ?? null;
    this.commandId = body.commandId ?? null;
    this.type = body.type ?? '';
    this.code = body.code ?? '';
  }

  /** There was a session, and the cloud no longer knows it. */
  get sessionEnded(): boolean {
    return this.type === 'urn:dronemap:problem:session-ended';
  }

  static unreachable(): Problem {
    return new Problem({
      status: 0,
      detail: 'The cloud did not answer. Check the connection and try again.',
    });
  }
}

/** The sentence to show for anything that was thrown. */
export function sentenceFor(thrown: unknown): string {
  return thrown instanceof Error ? thrown.message : String(thrown);
}

function sentenceOf(body: ProblemBody): string {
  const sentence = body.detail ?? body.title ?? `The cloud answered with status ${body.status}.`;
  return body.allowed && !sentence.includes(body.allowed)
    ? `${sentence} Allowed: ${body.allowed}.`
    : sentence;
}
