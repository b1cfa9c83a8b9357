/** Faults of values, in the words and with the codes that the server has for them. */
import type { ErrorObject } from 'ajv';
import type { Schema } from './description';
import { Refusal } from './refusal';

/** What is wrong with a value. */
export interface Fault {
  /** One of docs/problems.md. */
  readonly code: string;
  /** Where, such as `items[0].longitude`; empty: the value itself. */
  readonly field: string;
  readonly allowed: string;
  readonly sentence: string;
}

const TYPES: Readonly<Record<string, string>> = {
  number: 'a number',
  integer: 'a whole number',
  string: 'a text',
  boolean: 'true or false',
  array: 'a list',
  object: 'a JSON object',
};

const CODES: Readonly<Record<string, string>> = {
  required: 'value-missing',
  additionalProperties: 'member-unknown',
  enum: 'value-not-allowed',
  discriminator: 'value-not-allowed',
  minimum: 'value-out-of-range',
  maximum: 'value-out-of-range',
  minLength: 'size-out-of-range',
  maxLength: 'size-out-of-range',
  minItems: 'size-out-of-range',
  maxItems: 'size-out-of-range',
};

function listed(values: readonly unknown[]): string {
  const words = values.filter((value) => value !== null).map(String);
  return words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} or ${words.at(-1) ?? ''}`;
}

function range(least: unknown, most: unknown, unit: string): string | null {
  if (least === undefined && most === undefined) {
    return null;
  }
  const words =
    most === undefined
      ? `at least ${String(least)}`
      : least === undefined
        ? `at most ${String(most)}`
        : `${String(least)} to ${String(most)}`;
  return words + unit;
}

/** What a schema allows, in words. */
function allowedBy(schema: Schema): string {
  const types = Array.isArray(schema['type']) ? (schema['type'] as unknown[]) : [schema['type']];
  return (
    (Array.isArray(schema['enum']) ? listed(schema['enum']) : null) ??
    range(schema['minimum'], schema['maximum'], '') ??
    range(schema['minLength'], schema['maxLength'], ' characters') ??
    range(schema['minItems'], schema['maxItems'], ' items') ??
    (typeof schema['pattern'] === 'string' ? `a text like ${schema['pattern']}` : null) ??
    TYPES[String(types[0])] ??
    'given'
  );
}

/** The members of an object, or the forms that it may have. */
function membersOf(schema: Schema | undefined): string {
  return Object.keys((schema?.['properties'] ?? {}) as object).join(', ');
}

function fieldOf({ instancePath, params }: ErrorObject): string {
  const member = (params['missingProperty'] ?? params['additionalProperty'] ?? params['tag']) as
    string | undefined;
  return [...instancePath.split('/').slice(1), ...(member === undefined ? [] : [member])]
    .map((step) => (/^\d+$/.test(step) ? `[${step}]` : `.${step}`))
    .join('')
    .replace(/^\./, '');
}

/** The first fault of those that ajv found with `verbose`. */
export function faultOf(errors: readonly ErrorObject[]): Fault | null {
  const [first] = errors;
  if (first === undefined) {
    return null;
  }
  const { keyword, params, data } = first;
  const schema = (first.parentSchema ?? {}) as Schema;
  const code = CODES[keyword] ?? 'value-malformed';
  const field = fieldOf(first);
  const faultWith = (allowed: string, sentence: string): Fault => ({ code, field, allowed, sentence });
  if (keyword === 'required') {
    const members = (schema['properties'] ?? {}) as Record<string, Schema>;
    const allowed = allowedBy(members[params['missingProperty'] as string] ?? {});
    return faultWith(allowed, `"${field}" is missing; it must be ${allowed}.`);
  }
  if (keyword === 'additionalProperties') {
    const members = membersOf(schema);
    return faultWith(members, `There is no member "${field}" here; there are: ${members}.`);
  }
  if (keyword === 'discriminator') {
    return faultWith(
      'one of its forms',
      `"${field}" must be one of its forms, not ${JSON.stringify(params['tagValue'])}.`,
    );
  }
  const allowed = keyword === 'type' ? allowedBy({ type: schema['type'] }) : allowedBy(schema);
  const not = code === 'value-malformed' || typeof data === 'object' ? '' : `, not ${JSON.stringify(data)}`;
  return faultWith(allowed, `"${field}" must be ${allowed}${not}.`);
}

/** The fault as the server's answer to a request that has it. */
export function refusalOf({ code, field, allowed, sentence }: Fault): Refusal {
  return field === ''
    ? new Refusal(400, 'body-not-an-object', 'A JSON object is needed as the body of this request.')
    : new Refusal(422, code, sentence, { field, allowed, parameters: { field, allowed } });
}
