import { Problem } from '../api/problem';
import type { StreamMessage } from '../api/types';

interface Pending<T> {
  resolve: (answer: T) => void;
  reject: (problem: Problem) => void;
}

/** Requests that were sent on the stream and are not answered yet. */
export class PendingRequests<T> {
  readonly #pending = new Map<string, Pending<T>>();
  #number = 0;

  /** Sends a request under a new id; null when `send` reports that there is no connection. */
  request(send: (requestId: string) => boolean): Promise<T> | null {
    this.#number += 1;
    const id = `request-${String(this.#number)}`;
    return send(id) ? new Promise<T>((resolve, reject) => this.#pending.set(id, { resolve, reject })) : null;
  }

  /** `requestId`: null when the request had none. */
  resolve(requestId: string | null, answer: T): void {
    if (requestId !== null) {
      this.#remove(requestId)?.resolve(answer);
    }
  }

  /** Whether the error answers one of these requests. */
  reject({ requestId, problem }: Extract<StreamMessage, { type: 'error' }>): boolean {
    const pending = requestId === undefined ? undefined : this.#remove(requestId);
    pending?.reject(new Problem(problem));
    return pending !== undefined;
  }

  /** After the connection was lost: it is unknown which requests were received. */
  rejectAll(): void {
    const all = [...this.#pending.values()];
    this.#pending.clear();
    all.forEach(({ reject }) => reject(Problem.unreachable()));
  }

  #remove(id: string): Pending<T> | undefined {
    const pending = this.#pending.get(id);
    this.#pending.delete(id);
    return pending;
  }
}
