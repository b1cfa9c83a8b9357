/** Plays REST as its description has it: what the scenario does not answer is answered with an example. */
import type { IncomingHttpHeaders } from 'node:http';
import { Addresses, operationsOf, type Operation, type RestDescription } from './description';
import { OperationChecks, type Answer } from './operation-checks';
import { Refusal } from './refusal';
import { Schemas } from './schemas';

export interface Call {
  /** In capital letters. */
  readonly method: string;
  /** With the query. */
  readonly url: string;
  readonly headers: IncomingHttpHeaders;
  /** The body as it came; empty: none. */
  readonly text: string;
}

/** Answers with another status than the first that the description has for success. */
export class WithStatus {
  constructor(
    readonly status: number,
    readonly body: unknown,
  ) {}
}

/** Answers an operation: the body that came, and the first value in the address; the body of the answer, if it has one. */
export type Handler = (body: never, id: string) => unknown;

/** The state of the mock server, as far as REST sees it. */
export interface Scenario {
  /** By the id of the operation. */
  readonly handlers: Readonly<Record<string, Handler>>;
  readonly signedIn: () => boolean;
  /** Called with the reason when an answer is not as it is described. */
  readonly breach: (sentence: string) => void;
}

export class MockRest {
  readonly operations: readonly Operation[];
  readonly #addresses: Addresses;
  readonly #schemas: Schemas;
  readonly #checks: OperationChecks;
  readonly #scenario: Scenario;

  /** @throws Error when the scenario answers an operation that the description does not have */
  constructor(description: RestDescription, scenario: Scenario) {
    this.operations = operationsOf(description);
    this.#addresses = new Addresses(this.operations);
    this.#schemas = new Schemas(description);
    this.#checks = new OperationChecks(this.#schemas);
    this.#scenario = scenario;
    const known = new Set(this.operations.map(({ operationId }) => operationId));
    const unknown = Object.keys(scenario.handlers).filter((id) => !known.has(id));
    if (unknown.length > 0) {
      throw new Error(`The description has no operation ${unknown.join(', ')}.`);
    }
  }

  /** The body that an operation takes, as an example; undefined: it takes none that is JSON. */
  exampleFor({ requestBody }: Operation): unknown {
    const described = requestBody?.content['application/json'];
    return described === undefined ? undefined : this.#schemas.example(described.schema, 'all members');
  }

  answer(call: Call): Answer {
    const { pathname, searchParams } = new URL(call.url, 'http://mock');
    let operation: Operation | null = null;
    try {
      const found = this.#addresses.find(call.method, pathname);
      operation = found.operation;
      this.#admit(operation);
      this.#checks.parameters(found, searchParams);
      const body = this.#checks.body(operation, call.headers, call.text);
      const [id = ''] = Object.values(found.inPath);
      const handler = this.#scenario.handlers[operation.operationId];
      return this.#checked(
        operation,
        handler === undefined ? this.#example(operation) : answerOf(operation, handler(body as never, id)),
      );
    } catch (thrown) {
      const refused = refusing(thrown);
      return operation === null || refused.status >= 500 ? refused : this.#checked(operation, refused);
    }
  }

  /** Whether an operation needs a session tells its status for who has none; who signs in has none yet. */
  #admit({ operationId, responses }: Operation): void {
    if ('401' in responses && operationId !== 'signIn' && !this.#scenario.signedIn()) {
      throw new Refusal(401, 'sign-in-needed', 'Sign in first, or send an access key.');
    }
  }

  #example(operation: Operation): Answer {
    const { status, type } = successOf(operation);
    const described = type === null ? undefined : operation.responses[String(status)]?.content?.[type];
    return { status, type, body: described && this.#schemas.example(described.schema) };
  }

  /** Nothing goes out that the description does not have. */
  #checked(operation: Operation, answer: Answer): Answer {
    const sentence = this.#checks.breachOf(operation, answer);
    if (sentence === null) {
      return answer;
    }
    this.#scenario.breach(sentence);
    return refusing(new Refusal(500, 'server-failed', sentence));
  }
}

function refusing(thrown: unknown): Answer {
  const { problem } = Refusal.of(thrown);
  return { status: problem.status, type: 'application/problem+json', body: problem };
}

/** The first status that is no refusal, and the type that comes with it. */
function successOf({ responses }: Operation): Pick<Answer, 'status' | 'type'> {
  const status = Object.keys(responses).find((text) => Number(text) < 400) ?? '';
  return { status: Number(status), type: typeOf(responses, status) };
}

function typeOf(responses: Operation['responses'], status: string): string | null {
  return Object.keys(responses[status]?.content ?? {})[0] ?? null;
}

function answerOf(operation: Operation, result: unknown): Answer {
  return result instanceof WithStatus
    ? { ...result, type: typeOf(operation.responses, String(result.status)) }
    : { ...successOf(operation), body: result };
}
