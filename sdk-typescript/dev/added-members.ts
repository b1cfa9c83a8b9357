/** Members that answers have since programs use the client: an older server does not tell them, so they may be missing. */
import type { OpenAPI3, SchemaObject } from 'openapi-typescript';

/** By schema; what is added to an answer gets a place here. */
export const ADDED_MEMBERS: Readonly<Record<string, readonly string[]>> = {
  DroneBatteryView: ['further'],
  DroneLinkView: ['outdated'],
  PlanView: ['upTo'],
  RunView: ['upTo'],
  VirtualDroneRunView: ['drones', 'shares'],
  VirtualDroneView: ['upTo'],
};

export function withAddedMembersOptional(
  description: OpenAPI3,
  added: Readonly<Record<string, readonly string[]>> = ADDED_MEMBERS,
): OpenAPI3 {
  const schemas = { ...(description.components?.schemas as Record<string, SchemaObject>) };
  for (const [name, members] of Object.entries(added)) {
    const schema = schemas[name];
    const required = schema?.required ?? [];
    const unknown = members.find((member) => !required.includes(member));
    if (schema === undefined || unknown !== undefined) {
      throw new Error(`dev/added-members.ts: ${name} has no needed member ${unknown ?? members.join()}`);
    }
    schemas[name] = { ...schema, required: required.filter((member) => !members.includes(member)) };
  }
  return { ...description, components: { ...description.components, schemas } };
}
