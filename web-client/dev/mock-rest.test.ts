import { describe, expect, it } from 'vitest';
import type { WebSocket } from 'ws';
import { readRest, readStream } from './description';
import { MockRest, WithStatus, type Handler } from './mock-rest';
import { MockStream } from './mock-stream';

const SETTINGS = { streamPort: 8091, tileAddress: null, version: 'mock', publicMode: false, phonePage: null };

/** What GET settings is answered with by a scenario, and the breaches that were reported. */
function settingsBy(getSettings: Handler): [number, unknown, string[]] {
  const breaches: string[] = [];
  const rest = new MockRest(readRest(), {
    handlers: { getSettings },
    signedIn: () => true,
    breach: (sentence) => breaches.push(sentence),
  });
  const { status, body } = rest.answer({ method: 'GET', url: '/api/v1/settings', headers: {}, text: '' });
  return [status, body, breaches];
}

describe('a scenario of the mock server that answers what is not described', () => {
  const CASES: [string, Handler, string][] = [
    ['a member too many', () => ({ ...SETTINGS, port: 1 }), 'There is no member "port" here; there are:'],
    [
      'a member too few',
      () => ({ ...SETTINGS, version: undefined }),
      '"version" is missing; it must be a text.',
    ],
    ['another type', () => ({ ...SETTINGS, streamPort: '8091' }), '"streamPort" must be a whole number.'],
    ['no body', () => undefined, '"" must be a JSON object.'],
    ['another status', () => new WithStatus(201, SETTINGS), 'the description has 200, 401, 403, 429, 503.'],
  ];

  it.each(CASES)('sends 500 in place of %s', (_, handler, sentence) => {
    const [status, body, breaches] = settingsBy(handler);
    expect([status, body]).toEqual([
      500,
      expect.objectContaining({ code: 'server-failed', detail: breaches[0] }),
    ]);
    expect(breaches).toEqual([expect.stringContaining(sentence)]);
  });

  it('sends what is described', () => {
    expect(settingsBy(() => SETTINGS)).toEqual([200, SETTINGS, []]);
  });

  it('does not begin when there is no such operation', () => {
    const scenario = {
      handlers: { getSetting: () => SETTINGS },
      signedIn: () => true,
      breach: () => undefined,
    };
    expect(() => new MockRest(readRest(), scenario)).toThrow('The description has no operation getSetting.');
  });

  it('ends a stream that is to say it', () => {
    const [sent, breaches, closed]: [string[], string[], number[]] = [[], [], []];
    const stream = new MockStream(readStream(), {
      greeting: () => [{ type: 'hello', user: 'ann', role: 'guest', version: '1.0.0' }],
      answer: () => undefined,
      phoneLeft: () => undefined,
      breach: (sentence) => breaches.push(sentence),
    });
    stream.accept({
      on: () => undefined,
      send: (text: string) => sent.push(text),
      close: (code: number) => closed.push(code),
    } as unknown as WebSocket);
    expect([sent, closed]).toEqual([[], [1011]]);
    expect(breaches).toEqual([
      expect.stringContaining('The stream was to say hello: "role" must be reporter, viewer'),
    ]);
  });
});
