import type { CommandView } from '../contract/schemas.js';
import { Problem } from '../rest/problem.js';
import { Deadline, pause } from '../timing.js';
import { NewestQueue } from '../watch/newest-queue.js';
import type { SharedStream } from '../watch/shared-stream.js';
import { errorOf, OutcomeUnknown } from './command-error.js';
import type { GivePorts } from './give.js';

export interface OutcomeOptions {
  readonly signal?: AbortSignal | undefined;
  /** Milliseconds after which it is waited for no longer; the command goes on. Without: as long as it takes. */
  readonly timeout?: number | undefined;
}

const PHASES = ['sent', 'accepted', 'done'];
/** How often it is asked for while the stream does not tell. */
const ASK_MILLISECONDS = 1_000;

/** A command that the server has accepted. */
export class GivenCommand {
  readonly id: string;
  #view: CommandView;
  readonly #ports: GivePorts & { readonly stream: SharedStream };

  constructor(view: CommandView, ports: GivePorts & { readonly stream: SharedStream }) {
    this.id = view.id;
    this.#view = view;
    this.#ports = ports;
  }

  /** As it is known to stand. */
  get view(): CommandView {
    return this.#view;
  }

  /** What may be a slip of the hand, such as a far place. */
  get warnings(): readonly string[] {
    return this.#view.warnings;
  }

  /**
   * Resolves when it has succeeded; goes on over lost connections.
   *
   * @throws CommandError of the kind of any other outcome; OutcomeUnknown also when the time is over
   */
  async outcome({ signal, timeout }: OutcomeOptions = {}): Promise<CommandView> {
    const { timers } = this.#ports;
    const deadline = new Deadline(timers, timeout, () => this.#late(timeout), signal);
    try {
      if (this.#view.outcome === null) {
        await this.#follow(deadline.signal);
      }
    } finally {
      deadline.end();
    }
    const { outcome } = this.#view;
    const error = outcome === null ? null : errorOf(this.#view, outcome);
    if (error !== null) {
      throw error;
    }
    return this.#view;
  }

  /** Until it has ended: by the stream, and by asking where that cannot tell. */
  async #follow(signal: AbortSignal): Promise<void> {
    const { stream } = this.#ports;
    const news = new NewestQueue<'told' | 'ask'>(2);
    const remove = stream.isThere
      ? stream.add({
          drones: [this.#view.drone],
          rate: 1,
          onMessage: (message) => {
            if (message.type === 'command' && message.command.id === this.id) {
              this.#apply(message.command);
              news.push('told', 'told');
            }
          },
          onUp: () => news.push('ask', 'ask'),
          onEnd: (reason) => news.end(reason),
        })
      : (): void => undefined;
    const asking = new AbortController();
    void this.#askWhileDeaf(news, asking.signal);
    try {
      await this.#ask(signal);
      while (this.#view.outcome === null) {
        const next = await news.next(signal);
        if (next?.value === 'ask') {
          await this.#ask(signal);
        }
      }
    } finally {
      asking.abort();
      remove();
    }
  }

  async #askWhileDeaf(news: NewestQueue<'told' | 'ask'>, signal: AbortSignal): Promise<void> {
    const { stream, timers } = this.#ports;
    while (!signal.aborted) {
      await pause(timers, ASK_MILLISECONDS, signal).catch(() => undefined);
      if (!stream.isUp) {
        news.push('ask', 'ask');
      }
    }
  }

  async #ask(signal: AbortSignal): Promise<void> {
    try {
      this.#apply(await this.#ports.rest.getCommand({ id: this.id }, { signal }));
    } catch (thrown) {
      if (!(thrown instanceof Problem)) {
        throw thrown;
      }
      if (thrown.code === 'command-unknown') {
        throw new OutcomeUnknown({
          reason: thrown.message,
          code: thrown.code,
          id: this.id,
          command: this.#view,
        });
      }
      if (!thrown.mayPass) {
        throw thrown;
      }
    }
  }

  /** What was overtaken changes nothing. */
  #apply(view: CommandView): void {
    const isNewer = PHASES.indexOf(view.phase) >= PHASES.indexOf(this.#view.phase);
    if (this.#view.outcome === null && (isNewer || view.outcome !== null)) {
      this.#view = view;
    }
  }

  #late(timeout = 0): OutcomeUnknown {
    const reason = `“${this.#view.summary}” has not ended within ${timeout / 1000} s; it may still do so.`;
    return new OutcomeUnknown({ reason, code: 'not-waited-for', id: this.id, command: this.#view });
  }
}
