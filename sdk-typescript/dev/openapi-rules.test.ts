import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { openApiFaults } from './openapi-rules.js';

interface Open {
  components: { schemas: Record<string, object> };
  paths: Record<string, Record<string, { operationId: string; responses: object }>>;
}

const PINNED = new URL('../../dronemap-ws/src/test/resources/wire/openapi.json', import.meta.url);

const changed = (change: (description: Open) => void): Promise<string[]> => {
  const description = JSON.parse(readFileSync(PINNED, 'utf8')) as Open;
  change(description);
  return openApiFaults(JSON.stringify(description));
};

it('finds what is not well made', async () => {
  const faults = await changed(({ components, paths }) => {
    components.schemas['Forgotten'] = { type: 'object' };
    Object.assign(paths['/api/v1/users']?.['get'] ?? {}, { operationId: 'listZones' });
  });
  expect(faults).toEqual([
    expect.stringContaining(
      'Every operation must have a unique `operationId`. (operation-operationId-unique)',
    ),
    '#/components/schemas/Forgotten Component: "Forgotten" is never used. (no-unused-components)',
  ]);
});

it('finds what is switched off for nothing', async () => {
  const faults = await changed(({ paths }) => {
    const redirect = paths['/api/v1/session/oidc']?.['get'];
    Object.assign(redirect?.responses ?? {}, { 200: { description: 'OK' } });
  });
  expect(faults).toEqual([
    'operation-2xx-response finds nothing at #/paths/~1api~1v1~1session~1oidc/get/responses: take the exception out of' +
      ' dev/openapi-rules.ts',
  ]);
});
