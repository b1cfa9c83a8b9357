/**
 * Writes what REST and the stream take and answer, and a typed call for each operation, from their descriptions, which it
 * also checks; with --check it only says whether they are what the descriptions give.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import openapiTS, { astToString, COMMENT_HEADER, type OpenAPI3 } from 'openapi-typescript';
import { withAddedMembersOptional } from './added-members.js';
import { brokenReferences, faultsOf, type Description } from './asyncapi.js';
import { differentMembers, mergedSchemas } from './merged-schemas.js';
import { openApiFaults } from './openapi-rules.js';
import { operationsSource, type DescribedRest } from './operations-source.js';

const WIRE = new URL('../../dronemap-ws/src/test/resources/wire/', import.meta.url);
const CONTRACT = new URL('../src/contract/', import.meta.url);

const restText = readFileSync(new URL('openapi.json', WIRE), 'utf8');
const rest = JSON.parse(restText) as OpenAPI3;
const stream = JSON.parse(readFileSync(new URL('asyncapi.json', WIRE), 'utf8')) as Description;

async function schemasSource(): Promise<string> {
  const ast = await openapiTS(withAddedMembersOptional(mergedSchemas(rest, stream)), {
    rootTypes: true,
    rootTypesNoSchemaPrefix: true,
    rootTypesKeepCasing: true,
  });
  return COMMENT_HEADER + astToString(ast);
}

/** What each type of command is for, as the description of REST says it. */
function purposesSource({ components }: OpenAPI3): string {
  const command = components?.schemas?.['CommandView'] as Record<string, unknown>;
  const { type } = command['properties'] as { type: { 'x-purposes': Record<string, string> } };
  const purposes = type['x-purposes'];
  const lines = Object.entries(purposes).map(([command, purpose]) => `  ${command}: '${purpose}',\n`);
  return `// Written by npm run types: what each command is for.\n\nexport const PURPOSES = {\n${lines.join('')}} as const;\n`;
}

function fail(sentence: string): void {
  console.error(sentence);
  process.exitCode = 1;
}

function handOut(name: string, types: string): void {
  if (!process.argv.includes('--check')) {
    writeFileSync(new URL(name, CONTRACT), types);
  } else if (readFileSync(new URL(name, CONTRACT), 'utf8') !== types) {
    fail(`src/contract/${name} is not what the description gives: npm run types`);
  }
}

(await openApiFaults(restText)).forEach((fault) => {
  fail(`wire/openapi.json is not well made: ${fault}`);
});
[...faultsOf(stream), ...brokenReferences(stream)].forEach((fault) => {
  fail(`wire/asyncapi.json is no description by AsyncAPI 3: ${fault}`);
});
differentMembers(rest, stream).forEach((name) => {
  fail(`${name} has other members in wire/asyncapi.json than in wire/openapi.json`);
});
handOut('schemas.ts', await schemasSource());
handOut('operations.ts', operationsSource(rest as unknown as DescribedRest));
handOut('purposes.ts', purposesSource(rest));
