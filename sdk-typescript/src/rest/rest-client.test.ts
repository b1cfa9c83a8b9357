import { describe, expect, it, vi } from 'vitest';
import { VERSION } from '../version.js';
import { Problem } from './problem.js';
import { RestClient, type Fetch } from './rest-client.js';

function answering(
  status: number,
  body: unknown,
  headers: Record<string, string> = {},
): [RestClient, ReturnType<typeof vi.fn<Fetch>>] {
  const text = body === null ? null : typeof body === 'string' ? body : JSON.stringify(body);
  const fetcher = vi.fn<Fetch>(async () => new Response(text, { status, headers }));
  return [new RestClient({ url: 'https://drones.example/', key: 'secret', fetch: fetcher }), fetcher];
}

const problemOf = async (call: Promise<unknown>): Promise<Problem> => {
  const thrown = await call.catch((one: unknown) => one);
  expect(thrown).toBeInstanceOf(Problem);
  return thrown as Problem;
};

describe('REST client', () => {
  it('shows a key, or says that the browser shows its session', async () => {
    const [client, fetcher] = answering(200, { drones: [] });
    await client.operations.listDrones();
    expect(fetcher.mock.calls[0]?.[1]?.headers).toMatchObject({ Authorization: 'Bearer secret' });
    const page = new RestClient({ url: '', fetch: fetcher });
    await page.operations.listDrones({ active: true });
    const [address, init] = fetcher.mock.calls[1] ?? [];
    expect(address).toBe('/api/v1/drones?active=true');
    expect(init?.headers).toMatchObject({ 'X-Dronemap': '1' });
    expect(init?.credentials).toBe('same-origin');
  });

  it('leaves out of the address what is null or not given', async () => {
    const [client, fetcher] = answering(200, { records: [], next: null });
    await client.operations.searchAudit({ user: null, drone: undefined, limit: 5 });
    expect(fetcher.mock.calls[0]?.[0]).toBe('https://drones.example/api/v1/audit?limit=5');
  });

  it('sends a file as what it is, where the operation takes that', async () => {
    const [client, fetcher] = answering(201, { features: [] });
    const kml = 'application/vnd.google-earth.kml+xml';
    await client.operations.importZones(new Blob(['<kml/>'], { type: kml }));
    await client.operations.importZones(new Blob(['{}'], { type: 'text/plain' }));
    const types = fetcher.mock.calls.map(([, init]) => new Headers(init?.headers).get('Content-Type'));
    expect(types).toEqual([kml, 'application/geo+json']);
  });

  it('tells the problem with its code, field and allowed range', async () => {
    const [client] = answering(422, {
      detail: 'Latitude 95 is not on Earth.',
      code: 'value-out-of-range',
      parameters: { value: 95 },
      field: 'latitude',
      allowed: '-90 to 90 degrees',
    });
    const problem = await problemOf(client.operations.getDrone({ id: 'd1' }));
    expect(problem).toMatchObject({
      status: 422,
      code: 'value-out-of-range',
      field: 'latitude',
      parameters: { value: 95 },
      detail: 'Latitude 95 is not on Earth.',
      message: 'Latitude 95 is not on Earth. Allowed: -90 to 90 degrees.',
    });
  });

  it('says that a server of another version does not have the operation', async () => {
    const missing = { code: 'address-unknown', detail: 'There is nothing there.' };
    const [client] = answering(404, missing, { 'Dronemap-Version': '0.0.9' });
    expect((await problemOf(client.operations.listRuns())).message).toBe(
      `This server (0.0.9) has no listRuns; this client was made for ${VERSION}.`,
    );
    const [old] = answering(404, missing);
    expect((await problemOf(old.operations.listRuns())).message).toBe(
      `This server has no listRuns; this client was made for ${VERSION}.`,
    );
    const [other] = answering(404, { code: 'drone-unknown', detail: 'There is no such drone.' });
    expect((await problemOf(other.operations.listRuns())).message).toBe('There is no such drone.');
  });

  it('ends with the reason of the signal, and is unreachable when the time is over', async () => {
    const never: Fetch = (_, init) =>
      new Promise((_resolve, reject) => {
        init?.signal?.addEventListener('abort', () => reject(init.signal?.reason as Error));
      });
    const client = new RestClient({ url: '', fetch: never });
    const stop = new AbortController();
    const call = client.operations.listDrones({}, { signal: stop.signal, timeout: 60_000 });
    stop.abort(new Error('not needed any more'));
    await expect(call).rejects.toThrow('not needed any more');
    await expect(client.operations.listDrones({}, { timeout: 1 })).rejects.toMatchObject({ status: 0 });
    await expect(client.operations.listDrones({}, { signal: stop.signal })).rejects.toThrow('not needed');
  });

  it('answers a file as it comes, and a text as such', async () => {
    const [client] = answering(200, 'a,b');
    expect(await client.operations.exportLogbook()).toBe('a,b');
    const file = await client.operations.exportAudit({ form: 'csv' });
    expect(await new Response(file.body).text()).toBe('a,b');
  });

  it('gives addresses for links, escaped', () => {
    const client = new RestClient({ url: '' });
    expect(client.address('exportParameters', { id: 'a/b', form: 'list' })).toBe(
      '/api/v1/drones/a%2Fb/parameters/file?form=list',
    );
    expect(client.address('getAuditReceipt', {})).toBe('/api/v1/audit/receipt');
  });

  it('keeps what a newer server adds', async () => {
    const [client] = answering(200, { drones: [{ id: 'd1', kind: 'airship', wings: 2 }], more: true });
    expect(await client.operations.listDrones()).toEqual({
      drones: [{ id: 'd1', kind: 'airship', wings: 2 }],
      more: true,
    });
  });
});
