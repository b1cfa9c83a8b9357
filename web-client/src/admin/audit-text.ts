import type { AuditOutcome, AuditRecord } from '../api/audit';

export const OUTCOME_WORDS: Record<AuditOutcome, string> = {
  underWay: 'under way',
  succeeded: 'done',
  refused: 'refused',
  failed: 'failed',
  timedOut: 'timed out',
  superseded: 'superseded',
  unknown: 'unknown',
};

const INTERFACES: Record<string, string> = {
  page: 'on the page',
  rest: 'by REST',
  soap: 'by SOAP',
  stream: 'on the stream',
  rule: 'by a rule',
  safety: 'by a zone',
  script: 'by the script',
  virtual: 'for a virtual drone',
};

/** Actions of the server itself. */
const SYSTEM_ACTIONS: Record<string, string> = {
  controlLost: 'control lost',
  controlExpired: 'control expired',
  controlWithdrawn: 'control withdrawn',
  returnDue: 'return due',
  pilotActed: 'the pilot took control',
  pilotLeft: 'the pilot left',
  bindDrone: 'drone bound',
  releaseDrone: 'drone released',
};

/** The user, in a word. */
export function actorText(record: AuditRecord): string {
  return record.by ?? 'nobody known';
}

/** The action: of commands the summary, of the rest method and address without their common prefix. */
export function actionText(record: AuditRecord): string {
  return record.command !== null && record.parameters !== ''
    ? record.parameters
    : (SYSTEM_ACTIONS[record.operation] ?? record.operation.replace('/api/v1/', ''));
}

/** The remaining details, without those that are unknown. */
export function detailText(record: AuditRecord, nameOf: (drone: string) => string): string {
  return [
    record.drone === null ? null : nameOf(record.drone),
    INTERFACES[record.face] ?? record.face,
    record.accessKey === null ? null : 'with a key',
    record.epoch === null ? null : `control ${record.epoch}`,
    record.command === null && record.parameters !== '' ? record.parameters : null,
    record.latencyMillis === null ? null : `${record.latencyMillis} ms`,
    `no. ${record.sequence}`,
  ]
    .filter((part) => part !== null)
    .join(' · ');
}

export function dateAndTime(iso: string): string {
  return new Date(iso).toLocaleString([], { dateStyle: 'short', timeStyle: 'medium' });
}
