import { describe, expect, it, vi } from 'vitest';
import { Problem } from './problem';
import { RestClient } from './rest';

function answering(status: number, body: unknown): [RestClient, ReturnType<typeof vi.fn>] {
  const text = body === null ? null : typeof body === 'string' ? body : JSON.stringify(body);
  const fetcher = vi.fn(async () => new Response(text, { status }));
  return [new RestClient(fetcher), fetcher];
}

describe('REST client', () => {
  it('marks every call with the header that a foreign page cannot send', async () => {
    const [client, fetcher] = answering(200, { name: 'alice', role: 'operator', mustChangePassword: false });
    await client.signIn('alice', 'secret');
    const [address, init] = fetcher.mock.calls[0] as [string, RequestInit];
    expect(address).toBe('/api/v1/session');
    expect(init.headers).toMatchObject({ 'X-Dronemap': '1', 'Content-Type': 'application/json' });
    expect(init.body).toBe('{"name":"alice","password":"secret"}');
  });

  it('gives up what a dead line does not answer, where it is asked again and again', async () => {
    const [client, fetcher] = answering(200, { upTo: null });
    await client.follows.positions('f1', { sent: '2026-01-01T12:00:00Z', positions: [] });
    const [, soon] = fetcher.mock.calls[0] as [string, RequestInit];
    expect(soon.signal).toBeInstanceOf(AbortSignal);
    await client.follows.act('f1', 'stop');
    const [, patient] = fetcher.mock.calls[1] as [string, RequestInit];
    expect(patient.signal).toBeUndefined();
  });

  it('resolves with nothing for an answer without a body', async () => {
    const [client] = answering(204, null);
    await expect(client.signOut()).resolves.toBeUndefined();
  });

  it('turns a problem into a sentence with field and allowed range', async () => {
    const [client] = answering(422, {
      detail: 'Latitude 95 is not on Earth.',
      code: 'value-out-of-range',
      field: 'latitude',
      allowed: '-90 to 90 degrees',
    });
    const problem = await client
      .sendCommand('d1', { type: 'arm', id: 'c1' })
      .catch((thrown: unknown) => thrown);
    expect(problem).toBeInstanceOf(Problem);
    expect(problem).toMatchObject({
      status: 422,
      code: 'value-out-of-range',
      field: 'latitude',
      message: 'Latitude 95 is not on Earth. Allowed: -90 to 90 degrees.',
    });
  });

  it('keeps the status of an answer that is no problem document', async () => {
    const [client] = answering(502, '<html>Bad gateway</html>');
    await expect(client.settings()).rejects.toMatchObject({ status: 502 });
  });

  it('says that the cloud did not answer when the network fails', async () => {
    const client = new RestClient(() => Promise.reject(new TypeError('Failed to fetch')));
    await expect(client.session()).rejects.toMatchObject({ status: 0 });
  });

  it('escapes what goes into an address', async () => {
    const [client, fetcher] = answering(204, null);
    await client.accounts.remove('a/b c');
    expect(fetcher.mock.calls[0]?.[0]).toBe('/api/v1/users/a%2Fb%20c');
  });
});
