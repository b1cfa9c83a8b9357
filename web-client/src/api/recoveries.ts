import type {
  RecoveryPreview,
  RecoveryRequest as RecoveryOrder,
  RecoveryView as Recovery,
  RestOperations,
} from '@dronemap/client';

export type { Recovery, RecoveryOrder, RecoveryPreview };

/** The calls about drones that come home, or land, together. */
export class RecoveryCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  async all(): Promise<Recovery[]> {
    return (await this.#rest.listRecoveries()).recoveries;
  }

  preview(order: RecoveryOrder): Promise<RecoveryPreview> {
    return this.#rest.previewRecovery(order);
  }

  begin(order: RecoveryOrder): Promise<Recovery> {
    return this.#rest.beginRecovery(order);
  }

  cancel(id: string): Promise<Recovery> {
    return this.#rest.cancelRecovery({ id });
  }
}
