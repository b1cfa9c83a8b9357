/** Whether the description of REST is well made: by all rules of Redocly, but for those that are switched off here. */
import { createConfig, lintFromString } from '@redocly/openapi-core';

/** Rules that are switched off, and why. */
const OFF: Readonly<Record<string, string>> = {
  'boolean-parameter-prefixes': 'names in addresses are words, as those of members are',
  'info-contact': 'whoever runs a server is asked, not who wrote it',
  'operation-description': 'the summary says it where there is no more to say',
  'parameter-description': 'the id of what the address names needs none',
  'path-http-verbs-order': 'the pinned file is in the order of names',
  'path-segment-plural': 'a drone has one fence, and a server one outlet',
  'request-mime-type': 'files are sent as what they are',
  'required-string-property-missing-min-length': 'of what is answered no text is promised not to be empty',
  'response-mime-type': 'files and problems are answered as what they are',
  'scalar-property-missing-example': 'most members are said by their range or their values',
  'tags-alphabetical': 'the order is that of the pages for people',
};

/** What a rule may find in one place, and why. */
const EXCEPTIONS: readonly { rule: string; at: string; why: string }[] = [
  {
    rule: 'operation-2xx-response',
    at: '#/paths/~1api~1v1~1session~1oidc/get/responses',
    why: 'a browser is sent on to the provider',
  },
  {
    rule: 'operation-2xx-response',
    at: '#/paths/~1api~1v1~1session~1oidc~1callback/get/responses',
    why: 'a browser is sent on to the page',
  },
];

/** What a rule says against a place of the description. */
interface Finding {
  readonly rule: string;
  /** A JSON pointer. */
  readonly at: string;
  readonly message: string;
}

async function findings(source: string): Promise<Finding[]> {
  // Whole words: a dispatch is no patch.
  const rules = { 'no-http-verbs-in-paths': { severity: 'error', splitIntoWords: true } } as const;
  const config = await createConfig({ extends: ['all'], rules });
  const problems = await lintFromString({ source, absoluteRef: 'openapi.json', config });
  return problems.map(({ ruleId, message, location: [place] }) => ({
    rule: ruleId,
    at: place !== undefined && 'pointer' in place ? (place.pointer ?? '') : '',
    message,
  }));
}

/** What is said against a description, given as JSON, and what is switched off for nothing. */
export async function openApiFaults(source: string): Promise<string[]> {
  const found = await findings(source);
  const isException = ({ rule, at }: Finding): boolean =>
    EXCEPTIONS.some((one) => one.rule === rule && one.at === at);
  return [
    ...found
      .filter((one) => !(one.rule in OFF) && !isException(one))
      .map(({ rule, at, message }) => `${at} ${message} (${rule})`),
    ...Object.keys(OFF)
      .filter((rule) => found.every((one) => one.rule !== rule))
      .map((rule) => `${rule} is switched off for nothing: take it out of dev/openapi-rules.ts`),
    ...EXCEPTIONS.filter(({ rule, at }) => found.every((one) => one.rule !== rule || one.at !== at)).map(
      ({ rule, at }) => `${rule} finds nothing at ${at}: take the exception out of dev/openapi-rules.ts`,
    ),
  ];
}
