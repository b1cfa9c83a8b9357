import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { DescribedOperation, DescribedRest } from '../../dev/operations-source.js';
import { OPERATIONS } from '../contract/operations.js';
import { RestClient } from './rest-client.js';

const PINNED = new URL('../../../dronemap-ws/src/test/resources/wire/openapi.json', import.meta.url);
const { paths } = JSON.parse(readFileSync(PINNED, 'utf8')) as DescribedRest;
const described = Object.entries(paths).flatMap(([path, methods]) =>
  Object.entries(methods).map(([method, operation]) => ({ path, method: method.toUpperCase(), operation })),
);

interface Made {
  readonly address: string;
  readonly init: RequestInit;
}

/** Makes the call of an operation with a value for each of its parameters and a body, if it has one. */
async function make(operation: DescribedOperation): Promise<{ made: Made[]; answer: unknown }> {
  const made: Made[] = [];
  const status = Object.keys(operation.responses).find((one) => Number(one) < 400) ?? '';
  const [type] = Object.keys(operation.responses[status]?.content ?? {});
  const client = new RestClient({
    url: 'https://drones.example',
    key: 'k',
    fetch: async (address, init = {}) => {
      made.push({ address, init });
      const text = type === undefined ? null : type === 'application/json' ? '{"told":1}' : 'file';
      return new Response(text, { status: Number(status) });
    },
  });
  const call = client.operations[operation.operationId as keyof typeof OPERATIONS] as (
    ...given: unknown[]
  ) => Promise<unknown>;
  const parameters = operation.parameters?.map(({ name }) => [name, `a ${name}/é`] as const);
  const given = [
    ...(parameters === undefined ? [] : [Object.fromEntries(parameters)]),
    ...(operation.requestBody === undefined ? [] : [bodyOf(operation)]),
  ];
  return { made, answer: await call(...given) };
}

const isJson = (operation: DescribedOperation): boolean =>
  'application/json' in (operation.requestBody?.content ?? {});

const bodyOf = (operation: DescribedOperation): unknown =>
  isJson(operation) ? { said: [1, null] } : 'a file';

/** As the description has it. */
function addressOf(path: string, { parameters = [] }: DescribedOperation): string {
  const value = (name: string): string => encodeURIComponent(`a ${name}/é`);
  const filled = path.replaceAll(/\{(\w+)\}/g, (_, name: string) => value(name));
  const query = parameters
    .filter((one) => one.in === 'query')
    .map(({ name }) => `${name}=${value(name).replaceAll('%20', '+')}`);
  return `https://drones.example${filled}${query.length === 0 ? '' : `?${query.join('&')}`}`;
}

describe('operations', () => {
  it('are those of the description', () => {
    expect(Object.keys(OPERATIONS).sort()).toEqual(
      described.map(({ operation }) => operation.operationId).sort(),
    );
  });

  it.each(described.map((one) => [one.operation.operationId, one] as const))(
    '%s is called as it is described',
    async (_, { path, method, operation }) => {
      const { made, answer } = await make(operation);
      expect(made).toHaveLength(1);
      const [{ address, init }] = made as [Made];
      expect(init.method).toBe(method);
      expect(address).toBe(addressOf(path, operation));
      const [type] = Object.keys(operation.requestBody?.content ?? {});
      expect(new Headers(init.headers).get('Content-Type')).toBe(type ?? null);
      const body = operation.requestBody === undefined ? undefined : bodyOf(operation);
      expect(init.body).toEqual(isJson(operation) ? JSON.stringify(body) : body);
      const kind = OPERATIONS[operation.operationId as keyof typeof OPERATIONS].answer;
      if (kind === 'json' || kind === 'nothing') {
        expect(answer).toEqual(kind === 'json' ? { told: 1 } : undefined);
      } else {
        expect(await (answer instanceof Response ? answer.text() : answer)).toBe(
          kind === 'redirect' ? '' : 'file',
        );
      }
    },
  );
});
