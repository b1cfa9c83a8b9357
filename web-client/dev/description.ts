/** The pinned descriptions of REST and of the stream, and which operation of REST a request is for. */
import { readFileSync } from 'node:fs';
import { Refusal } from './refusal';

const WIRE = new URL('../../dronemap-ws/src/test/resources/wire/', import.meta.url);

export type Schema = Readonly<Record<string, unknown>>;

/** A reference to a schema by its name. */
export const named = (name: string): Schema => ({ $ref: `#/components/schemas/${name}` });

/** What a body may be, by its media type. */
export type Content = Readonly<Record<string, { schema: Schema }>>;

export interface Parameter {
  readonly name: string;
  readonly in: 'path' | 'query';
  readonly required?: boolean;
  readonly schema: Schema;
}

interface Described {
  readonly operationId: string;
  readonly parameters?: readonly Parameter[];
  readonly requestBody?: { readonly required?: boolean; readonly content: Content };
  /** By status, as a text. */
  readonly responses: Readonly<Record<string, { content?: Content }>>;
}

export interface Operation extends Described {
  /** In capital letters. */
  readonly method: string;
  /** With the names of its parameters in braces. */
  readonly path: string;
}

export interface WithSchemas {
  readonly components: { readonly schemas: Readonly<Record<string, Schema>> };
}

export interface RestDescription extends WithSchemas {
  readonly paths: Readonly<Record<string, Readonly<Record<string, Described>>>>;
}

export interface StreamOperation {
  readonly action: 'send' | 'receive';
  readonly messages: readonly { $ref: string }[];
  readonly reply?: { readonly messages: readonly { $ref: string }[] };
}

export interface StreamDescription extends WithSchemas {
  readonly operations: Readonly<Record<string, StreamOperation>>;
}

const pinned = (file: string): unknown => JSON.parse(readFileSync(new URL(file, WIRE), 'utf8'));
export const readRest = (): RestDescription => pinned('openapi.json') as RestDescription;
export const readStream = (): StreamDescription => pinned('asyncapi.json') as StreamDescription;

export function operationsOf({ paths }: RestDescription): Operation[] {
  return Object.entries(paths).flatMap(([path, methods]) =>
    Object.entries(methods).map(([method, described]) => ({
      ...described,
      method: method.toUpperCase(),
      path,
    })),
  );
}

/** The operation of an address, and the values that stand in the address, by name. */
export interface Found {
  readonly operation: Operation;
  readonly inPath: Readonly<Record<string, string>>;
}

/** Finds the operation that a request is for; where a fixed part and a parameter both match, the fixed part counts. */
export class Addresses {
  readonly #all: readonly { operation: Operation; matcher: RegExp }[];

  constructor(operations: readonly Operation[]) {
    const parameters = ({ path }: Operation): number => path.split('{').length;
    this.#all = operations
      .toSorted((one, other) => parameters(one) - parameters(other))
      .map((operation) => ({
        operation,
        matcher: new RegExp(`^${operation.path.replaceAll(/\{(\w+)\}/g, '(?<$1>[^/]+)')}$`),
      }));
  }

  /** @throws Refusal as the server: 404 where there is nothing, 405 where there is another method */
  find(method: string, path: string): Found {
    const there = this.#all.filter(({ matcher }) => matcher.test(path));
    const found = there.find(({ operation }) => operation.method === method);
    if (found !== undefined) {
      const inPath = Object.entries(found.matcher.exec(path)?.groups ?? {});
      return {
        operation: found.operation,
        inPath: Object.fromEntries(inPath.map(([name, value]) => [name, decodeURIComponent(value)])),
      };
    }
    if (there.length === 0) {
      const words = `There is nothing at ${path}; /api/docs lists the addresses.`;
      throw new Refusal(404, 'address-unknown', words, { parameters: { address: path } });
    }
    const allowed = [...new Set(there.map(({ operation }) => operation.method))].sort().join(', ');
    const words = `This address does not take ${method}; it takes ${allowed}.`;
    throw new Refusal(405, 'method-not-taken', words, { parameters: { method, allowed } });
  }
}
