import { Problem } from '../api/problem';
import type { StreamMessage } from '../api/types';

interface Waiting<T> {
  resolve: (answer: T) => void;
  reject: (problem: Problem) => void;
}

/** What was asked over the stream and is not answered yet. */
export class Questions<T> {
  readonly #waiting = new Map<string, Waiting<T>>();
  #number = 0;

  /** `say` hands the question over, with that id; null: the line is down. */
  ask(say: (requestId: string) => boolean): Promise<T> | null {
    this.#number += 1;
    const id = `ask-${String(this.#number)}`;
    return say(id) ? new Promise<T>((resolve, reject) => this.#waiting.set(id, { resolve, reject })) : null;
  }

  /** `requestId`: null when it was asked without one. */
  answer(requestId: string | null, answer: T): void {
    if (requestId !== null) {
      this.#take(requestId)?.resolve(answer);
    }
  }

  /** True when that was the answer to one of them. */
  refuse({ requestId, problem }: Extract<StreamMessage, { type: 'error' }>): boolean {
    const waiting = requestId === undefined ? undefined : this.#take(requestId);
    waiting?.reject(new Problem(problem));
    return waiting !== undefined;
  }

  /** The line went down: whatever was said may not have been heard. */
  giveUp(): void {
    const all = [...this.#waiting.values()];
    this.#waiting.clear();
    all.forEach(({ reject }) => reject(Problem.unreachable()));
  }

  #take(id: string): Waiting<T> | undefined {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    return waiting;
  }
}
