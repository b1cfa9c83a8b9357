import { describe, expect, it } from 'vitest';
import { withAddedMembersOptional } from './added-members.js';

const description = {
  openapi: '3.1.0',
  info: { title: 't', version: '' },
  paths: {},
  components: { schemas: { Battery: { type: 'object' as const, required: ['percent', 'further'] } } },
};

describe('members that older servers do not tell', () => {
  it('may be missing, and the others stay needed', () => {
    const made = withAddedMembersOptional(description, { Battery: ['further'] });
    expect(made.components?.schemas).toEqual({ Battery: { type: 'object', required: ['percent'] } });
    expect(description.components.schemas.Battery.required).toEqual(['percent', 'further']);
  });

  it('are known to the description', () => {
    expect(() => withAddedMembersOptional(description, { Battery: ['cells'] })).toThrow(
      'no needed member cells',
    );
    expect(() => withAddedMembersOptional(description, { Engine: ['rpm'] })).toThrow('Engine');
  });
});
