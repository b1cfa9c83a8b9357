import type {
  AuditPage,
  AuditView as AuditRecord,
  AuditVerdictView as AuditVerdict,
  ReceiptView,
  RestClient,
} from '@dronemap/client';
import { timeOf, wordsOf } from './search';

export type { AuditPage, AuditRecord, AuditVerdict };

export type AuditOutcome = AuditRecord['outcome'];

/** Empty: whatever it is. */
export interface AuditSearch {
  user: string;
  drone: string;
  operation: string;
  outcome: AuditOutcome | '';
  /** Local time as a field of the page has it. */
  from: string;
  until: string;
}

/** The calls about audit records. */
export class AuditCalls {
  readonly #rest: RestClient;

  constructor(rest: RestClient) {
    this.#rest = rest;
  }

  /** Newest first; `before`: only those before that number. */
  page(search: AuditSearch, before: number | null): Promise<AuditPage> {
    return this.#rest.operations.searchAudit({ ...parameters(search), before: before ?? undefined });
  }

  /** The address to download all matching records from. */
  fileAddress(search: AuditSearch, form: 'csv' | 'jsonl'): string {
    return this.#rest.address('exportAudit', { ...parameters(search), form });
  }

  receiptAddress(): string {
    return this.#rest.address('getAuditReceipt', {});
  }

  /** `receipt`: the content of a file that was downloaded earlier; the server says what is wrong with another one. */
  verify(receipt: unknown): Promise<AuditVerdict> {
    return this.#rest.operations.verifyAudit(receipt as ReceiptView | undefined);
  }
}

function parameters(search: AuditSearch): Record<keyof AuditSearch, string | null> {
  return {
    user: wordsOf(search.user),
    drone: wordsOf(search.drone),
    operation: wordsOf(search.operation),
    outcome: wordsOf(search.outcome),
    from: timeOf(search.from),
    until: timeOf(search.until),
  };
}
