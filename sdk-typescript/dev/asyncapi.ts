/** Whether a description is one by AsyncAPI 3: by its JSON schema, and by what refers to something within it. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { Ajv, type AnySchema } from 'ajv';

export interface Description {
  components: { schemas: Record<string, unknown> };
}

/** It brings the schema of JSON schemas along, which is not to be known twice. */
const SCHEMA = createRequire(import.meta.url).resolve('@asyncapi/specs/schemas/3.0.0.json');

/** What the schema of AsyncAPI says against it. */
export function faultsOf(description: unknown): string[] {
  const ajv = new Ajv({ strict: false, meta: false, validateSchema: false, validateFormats: false });
  const isDescription = ajv.compile(JSON.parse(readFileSync(SCHEMA, 'utf8')) as AnySchema);
  return isDescription(description)
    ? []
    : (isDescription.errors ?? []).map(({ instancePath, message }) => `${instancePath} ${message ?? ''}`);
}

/** References to what is not there. */
export function brokenReferences(description: unknown): string[] {
  const broken: string[] = [];
  JSON.stringify(description, (key, value: unknown) => {
    if (key === '$ref' && typeof value === 'string' && found(description, value) === undefined) {
      broken.push(`there is no ${value}`);
    }
    return value;
  });
  return broken;
}

function found(description: unknown, reference: string): unknown {
  return reference
    .split('/')
    .slice(1)
    .reduce<unknown>((at, step) => (at as Record<string, unknown> | undefined)?.[step], description);
}
