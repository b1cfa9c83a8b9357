import type { StreamError } from '@dronemap/client';

/** As REST and the stream tell it. */
type Problem = StreamError['problem'];

/** The classes of problems that the mock server has, by status: the end of their type, and their title. */
const CLASSES: Readonly<Record<number, readonly [string, string]>> = {
  400: ['malformed', 'The request cannot be read'],
  401: ['not-signed-in', 'Not signed in'],
  404: ['unknown', 'There is no such thing'],
  405: ['method', 'Not with this method'],
  409: ['refused', 'Refused'],
  415: ['media-type', 'Wrong kind of content'],
  422: ['invalid-value', 'A value is missing or out of range'],
};
const BROKEN = ['internal', 'The server failed'] as const;

/** What else a problem tells. */
type More = Partial<Pick<Problem, 'parameters' | 'field' | 'allowed' | 'commandId'>>;

/** A request that the mock server does not carry out, told as the server tells it. */
export class Refusal extends Error {
  readonly problem: Problem;

  /** `code`: one of docs/problems.md. */
  constructor(status: number, code: string, detail: string, more: More = {}) {
    super(detail);
    const [type, title] = CLASSES[status] ?? BROKEN;
    this.problem = {
      type: `urn:dronemap:problem:${type}`,
      title,
      status,
      detail,
      code,
      parameters: {},
      ...more,
    };
  }

  /** What was thrown as the problem that it is answered with. */
  static of(thrown: unknown): Refusal {
    return thrown instanceof Refusal ? thrown : new Refusal(500, 'server-failed', String(thrown));
  }
}

/**
 * A value that the description lets be left out, and the server does not.
 *
 * @throws Refusal where it is
 */
export function needed<T>(value: T | null | undefined, field: string, allowed: string): T {
  if (value === null || value === undefined) {
    const more = { field, allowed, parameters: { field, allowed } };
    throw new Refusal(422, 'value-missing', `"${field}" is missing; it must be ${allowed}.`, more);
  }
  return value;
}
