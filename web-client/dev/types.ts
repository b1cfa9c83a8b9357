/**
 * Writes the types of what REST takes and answers, and of what is sent on the stream, from their descriptions, which it also
 * checks; with --check it only says whether they are what the descriptions give. Addresses and their statuses are left out: the page has its own
 * words for them.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import openapiTS, { astToString, COMMENT_HEADER, type OpenAPI3, type SchemaObject } from 'openapi-typescript';
import { brokenReferences, faultsOf, type Description } from './asyncapi';
import { openApiFaults } from './openapi-rules';

const WIRE = new URL('../../dronemap-ws/src/test/resources/wire/', import.meta.url);
const API = new URL('../src/api/', import.meta.url);

const restText = readFileSync(new URL('openapi.json', WIRE), 'utf8');
const rest = JSON.parse(restText) as OpenAPI3;
const stream = JSON.parse(readFileSync(new URL('asyncapi.json', WIRE), 'utf8')) as Description;

/** As the schemas of a description of REST, which tells what is meant by a discriminator in another way. */
function asRest({ components: { schemas } }: Description): OpenAPI3 {
  const plain = JSON.stringify(schemas, (_, value: unknown) =>
    typeof value === 'object' && value !== null && 'oneOf' in value && 'discriminator' in value
      ? { ...value, discriminator: undefined }
      : value,
  );
  return {
    openapi: '3.1.0',
    info: { title: 'stream', version: '' },
    components: { schemas: JSON.parse(plain) as Record<string, SchemaObject> },
  };
}

async function written(description: OpenAPI3): Promise<string> {
  const ast = await openapiTS(
    { ...description, paths: {} },
    { rootTypes: true, rootTypesNoSchemaPrefix: true, rootTypesKeepCasing: true },
  );
  return COMMENT_HEADER + astToString(ast);
}

function fail(sentence: string): void {
  console.error(sentence);
  process.exitCode = 1;
}

/** What each type of command is for, as the description of REST says it. */
function purposes({ components }: OpenAPI3): string {
  const command = components?.schemas?.['CommandView'] as Record<string, unknown>;
  const { type } = command['properties'] as { type: { 'x-purposes': Record<string, string> } };
  const purposes = type['x-purposes'];
  const lines = Object.entries(purposes).map(([command, purpose]) => `  ${command}: '${purpose}',\n`);
  return `// Written by npm run types: what each command is for.\n\nexport const PURPOSES = {\n${lines.join('')}} as const;\n`;
}

function handOut(name: string, types: string): void {
  if (!process.argv.includes('--check')) {
    writeFileSync(new URL(name, API), types);
  } else if (readFileSync(new URL(name, API), 'utf8') !== types) {
    fail(`src/api/${name} is not what the description gives: npm run types`);
  }
}

(await openApiFaults(restText)).forEach((fault) => {
  fail(`wire/openapi.json is not well made: ${fault}`);
});
[...faultsOf(stream), ...brokenReferences(stream)].forEach((fault) => {
  fail(`wire/asyncapi.json is no description by AsyncAPI 3: ${fault}`);
});
handOut('contract.ts', await written(rest));
handOut('stream-contract.ts', await written(asRest(stream)));
handOut('purposes.ts', purposes(rest));
