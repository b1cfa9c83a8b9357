import type { Problem as DescribedProblem } from '../contract/schemas.js';

/** RFC 9457 problem details, with the field at fault and its allowed range where there is one. */
export type ProblemBody = Partial<DescribedProblem> & { status: number };

/** A request that the server answered with a problem, or did not answer at all (status 0). */
export class Problem extends Error {
  readonly status: number;
  readonly field: string | null;
  readonly allowed: string | null;
  readonly commandId: string | null;
  readonly type: string;
  /** Why exactly, for programs; empty without a problem. */
  readonly code: string;
  /** The sentence of the server, without what it adds of the allowed range. */
  readonly detail: string;
  /** What the detail is about; which of them come with which code, the server's list of problems tells. */
  readonly parameters: Readonly<Record<string, string | number | boolean>>;
  /** After so many seconds the same request may be taken. */
  readonly retryAfterSeconds: number | null;

  constructor(body: ProblemBody) {
    super(sentenceOf(body));
    this.name = 'Problem';
    this.status = body.status;
    this.field = body.field ?? null;
    this.allowed = body.allowed ?? null;
    this.commandId = body.commandId ?? null;
    this.type = body.type ?? '';
    this.code = body.code ?? '';
    this.detail = detailOf(body);
    this.parameters = body.parameters ?? {};
    this.retryAfterSeconds = body.retryAfterSeconds ?? null;
  }

  /** There was a session, and the cloud no longer knows it. */
  get sessionEnded(): boolean {
    return this.type === 'urn:dronemap:problem:session-ended';
  }

  /** The same request may be taken later: the server was not reached, is busy, or was asked too often. */
  get mayPass(): boolean {
    return this.status === 0 || this.status === 429 || this.status === 503;
  }

  static unreachable(): Problem {
    return new Problem({
      status: 0,
      detail: 'The cloud did not answer. Check the connection and try again.',
    });
  }
}

/** The problem of an answer that refuses a request. */
export function problemFrom(status: number, text: string): ProblemBody {
  try {
    return { ...(JSON.parse(text) as ProblemBody), status };
  } catch {
    // A proxy in between may answer with a page instead of a problem.
    return { status, detail: `The cloud answered with status ${status}.` };
  }
}

/** The sentence to show for anything that was thrown. */
export function sentenceFor(thrown: unknown): string {
  return thrown instanceof Error ? thrown.message : String(thrown);
}

function detailOf(body: ProblemBody): string {
  return body.detail ?? body.title ?? `The cloud answered with status ${body.status}.`;
}

function sentenceOf(body: ProblemBody): string {
  const sentence = detailOf(body);
  return body.allowed && !sentence.includes(body.allowed)
    ? `${sentence} Allowed: ${body.allowed}.`
    : sentence;
}
