/** Plays the stream as its description has it: what the scenario does not answer is answered with an example. */
import type { WebSocket } from 'ws';
import type { StreamMessage, StreamRequest } from '@dronemap/client';
import { named, type StreamDescription } from './description';
import { refusalOf } from './fault';
import { Refusal } from './refusal';
import { Schemas } from './schemas';

/** The state of the mock server, as far as the stream sees it. */
export interface StreamScenario {
  /** The first messages to each client. */
  readonly greeting: () => readonly unknown[];
  /** The answer to a request, without its id; undefined: the scenario has none. */
  readonly answer: (request: StreamRequest) => object | undefined;
  /** Called when the connection of a phone has ended. */
  readonly phoneLeft: () => void;
  /** Called with the reason when a message is not as it is described. */
  readonly breach: (sentence: string) => void;
}

/** As WebSocket has it for a server that cannot go on. */
const SERVER_FAILED = 1011;

export class MockStream {
  readonly #clients = new Set<WebSocket>();
  readonly #schemas: Schemas;
  readonly #description: StreamDescription;
  readonly #scenario: StreamScenario;

  constructor(description: StreamDescription, scenario: StreamScenario) {
    this.#description = description;
    this.#schemas = new Schemas(description);
    this.#scenario = scenario;
  }

  /** Sends a message to all clients. */
  broadcast(message: unknown): void {
    this.#clients.forEach((client) => this.#send(client, message));
  }

  accept(client: WebSocket): void {
    this.#clients.add(client);
    let isPhone = false;
    client.on('close', () => {
      this.#clients.delete(client);
      if (isPhone) {
        this.#scenario.phoneLeft();
      }
    });
    client.on('message', (data: Buffer) => {
      const answer = this.#answer(data.toString(), (request) => {
        isPhone ||= request.type === 'positions';
      });
      if (answer !== null) {
        this.#send(client, answer);
      }
    });
    this.#scenario.greeting().forEach((message) => this.#send(client, message));
  }

  /** Sends only what is described; otherwise the connection ends. */
  #send(client: WebSocket, message: unknown): void {
    const fault = this.#schemas.faultOf(named('StreamMessage'), message);
    if (fault === null) {
      client.send(JSON.stringify(message));
      return;
    }
    const sentence = `The stream was to say ${(message as StreamMessage).type}: ${fault.sentence}`;
    this.#scenario.breach(sentence);
    client.close(SERVER_FAILED, 'The mock server breaks its description; it says where.');
  }

  #answer(text: string, received: (request: StreamRequest) => void): unknown {
    let requestId: string | null = null;
    try {
      const request = JSON.parse(text) as StreamRequest;
      requestId = request.requestId ?? null;
      const fault = this.#schemas.faultOf(named('StreamRequest'), request);
      if (fault !== null) {
        throw refusalOf(fault);
      }
      received(request);
      const answer = this.#scenario.answer(request) ?? this.#example(request);
      return answer && { ...answer, ...('requestId' in answer ? { requestId } : {}) };
    } catch (thrown) {
      const { problem } = Refusal.of(thrown);
      return { type: 'error', problem, ...(requestId === null ? {} : { requestId }) };
    }
  }

  /** What a request is answered with when all goes well; null: it is answered only when not. */
  #example({ type }: StreamRequest): object | null {
    const answers = this.#description.operations[type]?.reply?.messages ?? [];
    const name = answers[0]?.$ref.split('/').at(-1) ?? '';
    return name === '' || name === 'StreamError' ? null : (this.#schemas.example(named(name)) as object);
  }
}
