import { OPERATIONS, type RestOperations } from '../contract/operations.js';
import { VERSION } from '../version.js';
import { addressOf, type CallOptions, type FileBody, type Operation, type Parameters } from './operation.js';
import { Problem, problemFrom } from './problem.js';

export type Fetch = (input: string, init?: RequestInit) => Promise<Response>;

export interface RestOptions {
  /** Where the server is, such as https://drones.example; empty: where the page came from. */
  readonly url: string;
  /** An access key; without: the session of the browser. */
  readonly key?: string | undefined;
  readonly fetch?: Fetch | undefined;
}

/** Operations that only look, so that their address may be opened, saved or shown. */
export type LookOperation = {
  [Id in keyof RestOperations]: (typeof OPERATIONS)[Id]['method'] extends 'GET' ? Id : never;
}[keyof RestOperations];

type ParametersOf<Id extends keyof RestOperations> = (typeof OPERATIONS)[Id] extends {
  query: readonly string[];
}
  ? FirstOf<Id>
  : (typeof OPERATIONS)[Id]['path'] extends `${string}{${string}`
    ? FirstOf<Id>
    : Record<string, never>;
type FirstOf<Id extends keyof RestOperations> = NonNullable<globalThis.Parameters<RestOperations[Id]>[0]>;

/** Calls the operations of REST. */
export class RestClient {
  readonly operations: RestOperations;
  readonly #base: string;
  readonly #key: string | null;
  readonly #fetch: Fetch;
  #serverVersion: string | null = null;

  constructor({ url, key, fetch: fetcher }: RestOptions) {
    this.#base = url.replace(/\/+$/, '');
    this.#key = key ?? null;
    this.#fetch = fetcher ?? ((input, init) => globalThis.fetch(input, init));
    const ids = Object.keys(OPERATIONS) as (keyof RestOperations)[];
    const calls = ids.map((id) => [id, (...given: unknown[]) => this.#call(id, given)] as const);
    this.operations = Object.fromEntries(calls) as unknown as RestOperations;
  }

  /** As the newest answer said it; null: none did so. */
  get serverVersion(): string | null {
    return this.#serverVersion;
  }

  /** The address at which a browser gets what an operation answers, for links and pictures. */
  address<Id extends LookOperation>(id: Id, parameters: ParametersOf<Id>): string {
    return this.#base + addressOf(OPERATIONS[id], parameters as Parameters);
  }

  /** What is given: parameters and body, where the operation has them, then options. */
  #call(id: keyof RestOperations, given: readonly unknown[]): Promise<unknown> {
    const operation: Operation = OPERATIONS[id];
    const rest = [...given];
    const hasParameters = operation.query !== undefined || operation.path.includes('{');
    const parameters = hasParameters ? (rest.shift() as Parameters | undefined) : undefined;
    const body = operation.body === undefined ? undefined : rest.shift();
    const options = (rest[0] ?? {}) as CallOptions;
    return this.#send(id, operation, addressOf(operation, parameters), body, options);
  }

  async #send(
    id: string,
    operation: Operation,
    address: string,
    body: unknown,
    { signal, timeout }: CallOptions,
  ): Promise<unknown> {
    signal?.throwIfAborted();
    const init = this.#request(operation, body);
    const end = firstOf(signal, timeout === undefined ? undefined : AbortSignal.timeout(timeout));
    if (end !== undefined) {
      init.signal = end;
    }
    try {
      const response = await this.#fetch(this.#base + address, init);
      this.#serverVersion = response.headers.get('Dronemap-Version') ?? this.#serverVersion;
      if (isRefusal(operation, response)) {
        throw new Problem(this.#explained(id, problemFrom(response.status, await response.text())));
      }
      return await answered(operation, response);
    } catch (thrown) {
      signal?.throwIfAborted();
      throw thrown instanceof Problem || thrown instanceof SyntaxError ? thrown : Problem.unreachable();
    }
  }

  #request({ method, body: types = [], answer }: Operation, body: unknown): RequestInit {
    // The custom header cannot be sent by a foreign page: it is the guard against forged requests.
    const proof: Record<string, string> =
      this.#key === null ? { 'X-Dronemap': '1' } : { Authorization: `Bearer ${this.#key}` };
    const accepted = answer === 'json' || answer === 'nothing' ? 'application/json' : '*/*';
    const headers: Record<string, string> = { Accept: accepted, ...proof };
    const init: RequestInit = { method, headers, credentials: 'same-origin' };
    if (answer === 'redirect') {
      init.redirect = 'manual';
    }
    const [type] = types;
    if (body !== undefined && type !== undefined) {
      headers['Content-Type'] = body instanceof Blob && types.includes(body.type) ? body.type : type;
      init.body = type === 'application/json' ? JSON.stringify(body) : (body as FileBody);
    }
    return init;
  }

  /** A server of another version may not have every operation of this client. */
  #explained(id: string, problem: ReturnType<typeof problemFrom>): ReturnType<typeof problemFrom> {
    if (problem.status !== 404 || problem.code !== 'address-unknown') {
      return problem;
    }
    const server = this.#serverVersion === null ? 'This server' : `This server (${this.#serverVersion})`;
    return { ...problem, detail: `${server} has no ${id}; this client was made for ${VERSION}.` };
  }
}

/** Ends with the first of both. Browsers that do not know how to join them serve as long as one is enough. */
function firstOf(one: AbortSignal | undefined, other: AbortSignal | undefined): AbortSignal | undefined {
  return one !== undefined && other !== undefined ? AbortSignal.any([one, other]) : (one ?? other);
}

/** A redirect is an answer: a browser hides all of it but that it is one. */
function isRefusal({ answer }: Operation, { ok, status, type }: Response): boolean {
  const redirects = type === 'opaqueredirect' || (status >= 300 && status < 400);
  return !ok && !(answer === 'redirect' && redirects);
}

async function answered({ answer }: Operation, response: Response): Promise<unknown> {
  if (answer === 'file' || answer === 'redirect') {
    return response;
  }
  const text = await response.text();
  if (answer === 'text') {
    return text;
  }
  return text === '' ? undefined : JSON.parse(text);
}
