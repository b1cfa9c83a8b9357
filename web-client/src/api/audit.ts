import type { AuditPage, AuditView as AuditRecord, AuditVerdictView as AuditVerdict } from './contract';

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

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls about audit records. */
export class AuditCalls {
  readonly #call: Call;
  readonly #base: string;

  constructor(call: Call, base: string) {
    this.#call = call;
    this.#base = base;
  }

  /** Newest first; `before`: only those before that number. */
  page(search: AuditSearch, before: number | null): Promise<AuditPage> {
    const wanted = parameters(search);
    if (before !== null) {
      wanted.set('before', String(before));
    }
    return this.#call('GET', `/audit?${wanted}`);
  }

  /** The address to download all matching records from. */
  fileAddress(search: AuditSearch, form: 'csv' | 'jsonl'): string {
    const wanted = parameters(search);
    wanted.set('form', form);
    return `${this.#base}/audit/file?${wanted}`;
  }

  receiptAddress(): string {
    return `${this.#base}/audit/receipt`;
  }

  /** `receipt`: the text of a file that was downloaded earlier. */
  verify(receipt: unknown): Promise<AuditVerdict> {
    return this.#call('POST', '/audit/verification', receipt);
  }
}

function parameters(search: AuditSearch): URLSearchParams {
  const wanted = new URLSearchParams();
  for (const name of ['user', 'drone', 'operation', 'outcome'] as const) {
    if (search[name].trim() !== '') {
      wanted.set(name, search[name].trim());
    }
  }
  for (const name of ['from', 'until'] as const) {
    const time = new Date(search[name]);
    if (!Number.isNaN(time.getTime())) {
      wanted.set(name, time.toISOString());
    }
  }
  return wanted;
}
