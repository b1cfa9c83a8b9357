/**
 * Writes the types of what REST takes and answers from its description; with --check it only says whether they are what
 * the description gives. Addresses and their statuses are left out: the page has its own words for them.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import openapiTS, { astToString, COMMENT_HEADER, type OpenAPI3 } from 'openapi-typescript';

const DESCRIPTION = new URL('../../dronemap-ws/src/test/resources/wire/openapi.json', import.meta.url);
const TYPES = new URL('../src/api/contract.ts', import.meta.url);

const description = JSON.parse(readFileSync(DESCRIPTION, 'utf8')) as OpenAPI3;
const ast = await openapiTS(
  { ...description, paths: {} },
  { rootTypes: true, rootTypesNoSchemaPrefix: true, rootTypesKeepCasing: true },
);
const types = COMMENT_HEADER + astToString(ast);

if (!process.argv.includes('--check')) {
  writeFileSync(TYPES, types);
} else if (readFileSync(TYPES, 'utf8') !== types) {
  console.error('src/api/contract.ts is not what the description of REST gives: npm run types');
  process.exitCode = 1;
}
