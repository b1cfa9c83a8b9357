/** Checks requests and answers of REST by the description of the operation. */
import type { IncomingHttpHeaders } from 'node:http';
import type { Found, Operation, Parameter, Schema } from './description';
import { refusalOf } from './fault';
import { Refusal } from './refusal';
import type { Schemas } from './schemas';

const JSON_TYPE = 'application/json';

/** An answer as it goes out. */
export interface Answer {
  /** Of HTTP. */
  readonly status: number;
  /** The media type; null: there is no body. */
  readonly type: string | null;
  readonly body: unknown;
}

/** The media type without what comes after it. */
function kindOf({ 'content-type': type }: IncomingHttpHeaders): string {
  return (type ?? '').split(';')[0]?.trim() ?? '';
}

/** The text of an address as the value that it is read as; what is none of its type stays a text, and is refused so. */
function valueOf(text: string, { schema: { type } }: Parameter): unknown {
  const types = [type].flat();
  if (types.includes('boolean') && (text === 'true' || text === 'false')) {
    return text === 'true';
  }
  const isNumber = types.includes('number') || types.includes('integer');
  return isNumber && text.trim() !== '' && !Number.isNaN(Number(text)) ? Number(text) : text;
}

export class OperationChecks {
  readonly #schemas: Schemas;
  readonly #addresses = new Map<Operation, Schema>();

  constructor(schemas: Schemas) {
    this.#schemas = schemas;
  }

  /** @throws Refusal for a value in the address that the description does not allow */
  parameters({ operation, inPath }: Found, query: URLSearchParams): void {
    const { parameters = [] } = operation;
    const values = parameters.map((parameter) => {
      const { name } = parameter;
      const text = parameter.in === 'path' ? inPath[name] : query.get(name);
      return [name, typeof text === 'string' ? valueOf(text, parameter) : undefined] as const;
    });
    const fault = this.#schemas.faultOf(
      this.#asOne(operation),
      Object.fromEntries(values.filter(([, value]) => value !== undefined)),
    );
    if (fault !== null) {
      throw refusalOf(fault);
    }
  }

  /** One schema for all values in the address of an operation, always the same object. */
  #asOne(operation: Operation): Schema {
    const { parameters = [] } = operation;
    const known = this.#addresses.get(operation);
    const schema = known ?? {
      type: 'object',
      properties: Object.fromEntries(parameters.map(({ name, schema: one }) => [name, one])),
      required: parameters.filter(({ required }) => required).map(({ name }) => name),
    };
    this.#addresses.set(operation, schema);
    return schema;
  }

  /**
   * The body of a request: what its JSON says, or its text; null: there is none.
   *
   * @throws Refusal for a body that the description does not allow
   */
  body({ requestBody, responses }: Operation, headers: IncomingHttpHeaders, text: string): unknown {
    if (requestBody === undefined || (text === '' && requestBody.required !== true)) {
      return null;
    }
    const kinds = Object.keys(requestBody.content);
    if (!kinds.includes(kindOf(headers)) && '415' in responses) {
      const allowed = kinds.join(' or ');
      const words = `The body must be ${allowed}; say so in Content-Type.`;
      throw new Refusal(415, 'content-type-not-taken', words, { parameters: { allowed } });
    }
    const described = requestBody.content[JSON_TYPE];
    if (described === undefined) {
      return text;
    }
    const body = text === '' ? null : parsed(text);
    const fault = this.#schemas.faultOf(described.schema, body);
    if (fault !== null) {
      throw refusalOf(fault);
    }
    return body;
  }

  /** Why the description does not allow an answer, as a sentence; null: it does. */
  breachOf({ operationId, responses }: Operation, { status, type, body }: Answer): string | null {
    const response = responses[String(status)];
    const found = (what: string): string => `${operationId} answered ${status}: ${what}`;
    if (response === undefined) {
      return found(`the description has ${Object.keys(responses).join(', ')}.`);
    }
    if (response.content === undefined || type === null) {
      const fits = response.content === undefined && type === null && body === undefined;
      return fits ? null : found('either it or its description is without a body.');
    }
    const described = response.content[type];
    if (described === undefined) {
      return found(`it is ${type}; the description has ${Object.keys(response.content).join(', ')}.`);
    }
    const fault = this.#schemas.faultOf(described.schema, body);
    return fault === null ? null : found(fault.sentence);
  }
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (thrown) {
    throw new Refusal(400, 'json-unreadable', `This is not JSON: ${(thrown as SyntaxError).message}`);
  }
}
