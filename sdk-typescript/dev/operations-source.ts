/** Writes the typed call of each operation of REST, and the table that the calls are made by. */

interface Schema {
  readonly $ref?: string;
  readonly type?: string | readonly string[];
  readonly enum?: readonly unknown[];
  readonly format?: string;
}

interface Parameter {
  readonly name: string;
  readonly in: 'path' | 'query';
  readonly required?: boolean;
  readonly description?: string;
  readonly schema: Schema;
}

type Content = Readonly<Record<string, { schema: Schema }>>;

export interface DescribedOperation {
  readonly operationId: string;
  readonly summary?: string;
  readonly parameters?: readonly Parameter[];
  readonly requestBody?: { readonly required?: boolean; readonly content: Content };
  readonly responses: Readonly<Record<string, { content?: Content }>>;
}

export interface DescribedRest {
  readonly info: { readonly version: string };
  readonly paths: Readonly<Record<string, Readonly<Record<string, DescribedOperation>>>>;
}

/** What is answered when all goes well, and its type here. */
interface Answer {
  readonly kind: 'json' | 'text' | 'file' | 'nothing' | 'redirect';
  readonly type: string;
}

const JSON_TYPE = 'application/json';
const PLAIN: Readonly<Record<string, string>> = {
  string: 'string',
  integer: 'number',
  number: 'number',
  boolean: 'boolean',
  null: 'null',
};

export function operationsSource({ paths }: DescribedRest): string {
  const all = Object.entries(paths)
    .flatMap(([path, methods]) =>
      Object.entries(methods).map(([method, described]) => ({
        path,
        method: method.toUpperCase(),
        described,
      })),
    )
    .sort((one, other) => (one.described.operationId < other.described.operationId ? -1 : 1));
  const types = new Set<string>();
  const calls = all.map(({ path, method, described }) => call(path, method, described, types));
  const rows = all.map(({ path, method, described }) => row(path, method, described));
  return [
    '// Written by npm run types from the description of REST.',
    '',
    "import type { CallOptions, FileBody, Operation } from '../rest/operation.js';",
    `import type {\n${[...types]
      .sort()
      .map((name) => `  ${name},\n`)
      .join('')}} from './schemas.js';`,
    '',
    '/** Each operation of REST, by its id. A refusal rejects with a `Problem`. */',
    `export interface RestOperations {\n${calls.join('')}}`,
    '',
    '/** How each operation is called. */',
    `export const OPERATIONS = {\n${rows.join('')}} as const satisfies Record<keyof RestOperations, Operation>;`,
    '',
  ].join('\n');
}

function call(path: string, method: string, described: DescribedOperation, types: Set<string>): string {
  const { operationId, summary = '', parameters = [], requestBody } = described;
  const given = [];
  if (parameters.length > 0) {
    // A body that has to be given stands behind it.
    const needed = requestBody?.required === true || parameters.some(({ required }) => required === true);
    const optional = needed ? '' : '?';
    given.push(`parameters${optional}: { ${parameters.map(member).join('; ')} }`);
  }
  if (requestBody !== undefined) {
    given.push(`body${requestBody.required === true ? '' : '?'}: ${bodyType(requestBody.content, types)}`);
  }
  const answer = answerOf(described);
  if (answer.kind === 'json') {
    types.add(answer.type);
  }
  const sentence = `${summary}: ${method} ${path}`;
  return `  /** ${sentence} */\n  ${operationId}(${[...given, 'options?: CallOptions'].join(', ')}): Promise<${answer.type}>;\n`;
}

function member({ name, required, schema }: Parameter): string {
  const kinds = [schema.type ?? 'string'].flat().map((kind) => PLAIN[kind] ?? 'string');
  const type = schema.enum?.map((value) => JSON.stringify(value)).join(' | ') ?? kinds.join(' | ');
  return `${name}${required === true ? '' : '?'}: ${type}${required === true ? '' : ' | undefined'}`;
}

function bodyType(content: Content, types: Set<string>): string {
  const name = content[JSON_TYPE]?.schema.$ref?.split('/').at(-1);
  if (name === undefined) {
    return 'FileBody';
  }
  types.add(name);
  return name;
}

function answerOf({ operationId, responses }: DescribedOperation): Answer {
  const statuses = Object.keys(responses).filter((status) => Number(status) < 400);
  if (statuses.some((status) => status.startsWith('3'))) {
    return { kind: 'redirect', type: 'Response' };
  }
  const contents = statuses.map((status) => responses[status]?.content).filter((one) => one !== undefined);
  const media = [...new Set(contents.flatMap((content) => Object.keys(content)))];
  if (media.length === 0) {
    return { kind: 'nothing', type: 'void' };
  }
  const names = new Set(contents.map((content) => content[JSON_TYPE]?.schema.$ref?.split('/').at(-1)));
  const [name] = names;
  if (name !== undefined && names.size === 1) {
    return { kind: 'json', type: name };
  }
  if (media.includes(JSON_TYPE)) {
    throw new Error(`${operationId} answers with several types, or with one without a name.`);
  }
  return media.every((type) => type.startsWith('text/'))
    ? { kind: 'text', type: 'string' }
    : { kind: 'file', type: 'Response' };
}

function row(path: string, method: string, described: DescribedOperation): string {
  const query = (described.parameters ?? []).filter((one) => one.in === 'query').map(({ name }) => name);
  const body = Object.keys(described.requestBody?.content ?? {});
  const members = [
    `method: '${method}'`,
    `path: '${path}'`,
    ...(query.length > 0 ? [`query: ${list(query)}`] : []),
    ...(body.length > 0 ? [`body: ${list(body)}`] : []),
    `answer: '${answerOf(described).kind}'`,
  ];
  return `  ${described.operationId}: { ${members.join(', ')} },\n`;
}

const list = (texts: readonly string[]): string => `[${texts.map((text) => `'${text}'`).join(', ')}]`;
