import { describe, expect, it } from 'vitest';
import { connected, take } from '../testing/connected.js';

const all = connected();
const event = (number: number): object => ({ number, kind: 'armed', drone: 'd1', text: `event ${number}` });
const gap = (after: number): object => ({ after, cause: 'notWritten', text: 'The disk was full.' });

/** Answers for each place from which events are followed; where there is none, nothing comes. */
function following(answers: Readonly<Record<string, object>>): URLSearchParams[] {
  const asked: URLSearchParams[] = [];
  all.server.followed = (query) => {
    asked.push(query);
    return { events: [], gaps: [], next: 'end', ...answers[query.get('after') ?? 'now'] };
  };
  return asked;
}

describe('events', () => {
  it('begin now unless told, and come with those that follow', async () => {
    const asked = following({
      now: { next: 'p1' },
      p1: { events: [event(1), event(2)], next: 'p2' },
      p2: { next: 'p3' },
      p3: { events: [event(5)], next: 'p4' },
    });
    const told = await take(all.dronemap.events({ drones: ['d1', 'd2'] }), 3);
    expect(told).toMatchObject([
      { type: 'event', number: 1, resume: 'p1' },
      { type: 'event', number: 2, resume: 'p2' },
      { type: 'event', number: 5, resume: 'p4' },
    ]);
    expect(asked.map(String)).toEqual([
      'drones=d1%2Cd2',
      ...['p1', 'p2', 'p3'].map((place) => `after=${place}&drones=d1%2Cd2&wait=30`),
    ]);
  });

  it('go on where an earlier program was, and say where some are missing', async () => {
    following({ p7: { events: [event(8), event(9)], gaps: [gap(0), gap(8), gap(9)], next: 'p8' } });
    const told = await take(all.dronemap.events({ after: 'p7' }), 5);
    expect(told.map((one) => (one.type === 'gap' ? 'gap' : one.number))).toEqual(['gap', 8, 'gap', 9, 'gap']);
    expect(told.map(({ resume }) => resume)).toEqual(['p7', 'p7', 'p7', 'p7', 'p8']);
  });

  it('are each told once over broken lines and a busy server', async () => {
    following({ p1: { events: [event(1)], next: 'p2' }, p2: { events: [event(2)], next: 'p3' } });
    const busy = { status: 503, problem: { code: 'busy', retryAfterSeconds: 1 } };
    all.server.faults.set('GET /api/v1/events?after=p1&wait=30', ['answer lost', busy]);
    all.server.faults.set('GET /api/v1/events?after=p2&wait=30', ['request lost']);
    const told = await take(all.dronemap.events({ after: 'p1' }), 2);
    expect(told).toMatchObject([{ number: 1 }, { number: 2 }]);
  });

  it('end with the signal and with a problem that does not pass', async () => {
    following({});
    const stop = new AbortController();
    const stopped = take(all.dronemap.events({ after: 'p1', signal: stop.signal }), 1);
    stop.abort(new Error('read enough'));
    await expect(stopped).rejects.toThrow('read enough');
    const old = { status: 404, problem: { code: 'address-unknown', detail: 'There is nothing there.' } };
    all.server.faults.set('GET /api/v1/events', [old]);
    await expect(take(all.dronemap.events(), 1)).rejects.toThrow(
      'This server (0.1.0) has no followEvents; this client was made for 0.1.0.',
    );
  });
});
