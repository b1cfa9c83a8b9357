/** The schemas of both descriptions as those of one: most that the stream has are REST's. */
import type { OpenAPI3, SchemaObject } from 'openapi-typescript';
import type { Description } from './asyncapi.js';

/** Everything of REST but its addresses, which `operations-source.ts` writes, and what only the stream has. */
export function mergedSchemas(rest: OpenAPI3, stream: Description): OpenAPI3 {
  const ofRest = (rest.components?.schemas ?? {}) as Record<string, SchemaObject>;
  return {
    openapi: '3.1.0',
    info: { title: 'REST and the stream', version: '' },
    paths: {},
    components: { schemas: { ...asRest(stream), ...ofRest } },
  };
}

/** Of the schemas that both have, those with other members: what both say of the same thing is to be the same. */
export function differentMembers(rest: OpenAPI3, stream: Description): string[] {
  const ofRest = rest.components?.schemas ?? {};
  return Object.entries(stream.components.schemas)
    .filter(([name, schema]) => name in ofRest && membersOf(schema) !== membersOf(ofRest[name]))
    .map(([name]) => name);
}

const membersOf = (schema: unknown): string =>
  Object.keys((schema as { properties?: object }).properties ?? {})
    .sort()
    .join();

/** A description of REST tells what is meant by a discriminator in another way. */
function asRest({ components: { schemas } }: Description): Record<string, SchemaObject> {
  const plain = JSON.stringify(schemas, (_, value: unknown) =>
    typeof value === 'object' && value !== null && 'oneOf' in value && 'discriminator' in value
      ? { ...value, discriminator: undefined }
      : value,
  );
  return JSON.parse(plain) as Record<string, SchemaObject>;
}
