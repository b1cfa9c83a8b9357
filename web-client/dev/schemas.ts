/** Checks values by the schemas of a description, and gives examples of them. */
import { Ajv2020, type ValidateFunction } from 'ajv/dist/2020.js';
import formats from 'ajv-formats';
import { sample } from 'openapi-sampler';
import type { Schema, WithSchemas } from './description';
import { faultOf, type Fault } from './fault';

/** As what the references within the description are looked up. */
const ID = 'description';

/**
 * The schemas as strictly as the server takes them: an object has no members but its own, and which of several forms is
 * meant tells the member that says so, alone.
 */
function strict(schemas: unknown): unknown {
  const text = JSON.stringify(schemas, (_, value: unknown) => {
    const schema = value as Schema;
    if (typeof value !== 'object' || value === null) {
      return value;
    }
    if (Array.isArray(schema['oneOf']) && 'discriminator' in schema) {
      const { discriminator } = schema;
      const name = (discriminator as { propertyName?: string }).propertyName ?? discriminator;
      return { ...schema, type: 'object', required: [name], discriminator: { propertyName: name } };
    }
    // Not of a choice: that is itself a form of another one where it has members, and its forms have more.
    if (schema['type'] === 'object' && 'properties' in schema && !('additionalProperties' in schema)) {
      return { ...schema, additionalProperties: false };
    }
    return value;
  });
  return JSON.parse(text.replaceAll('"$ref":"#/', `"$ref":"${ID}#/`));
}

export class Schemas {
  readonly #description: WithSchemas;
  readonly #ajv = new Ajv2020({ strict: false, validateSchema: false, verbose: true, discriminator: true });
  readonly #checks = new Map<Schema, ValidateFunction>();

  constructor(description: WithSchemas) {
    this.#description = description;
    formats.default(this.#ajv);
    this.#ajv.addSchema({ components: strict(description.components) as object }, ID);
  }

  /** What is wrong with a value, or null. */
  faultOf(schema: Schema, value: unknown): Fault | null {
    let check = this.#checks.get(schema);
    if (check === undefined) {
      check = this.#ajv.compile(strict(schema) as object);
      this.#checks.set(schema, check);
    }
    return check(value) ? null : faultOf(check.errors ?? []);
  }

  /** The same at each call: of several forms the first, of values the first or the least. */
  example(schema: Schema, which: 'required members' | 'all members' = 'required members'): unknown {
    const options = { skipNonRequired: which === 'required members', enablePatterns: true, quiet: true };
    return sample(schema, options, this.#description);
  }
}
