import { describe, expect, it, vi } from 'vitest';
import { routeOf, Shell } from './shell';

const ORIGIN = 'https://drones.example';
const asked = (path: string, change = {}): Parameters<typeof routeOf>[0] => ({
  method: 'GET',
  mode: 'cors',
  url: ORIGIN + path,
  ...change,
});

/** As much of the browser's as is used. */
class FakeCaches {
  readonly kept = new Map<string, Map<string, Response>>();

  open(name: string): Promise<Cache> {
    const entries = this.kept.get(name) ?? new Map<string, Response>();
    this.kept.set(name, entries);
    const key = (request: Request | string): string =>
      typeof request === 'string' ? request : new URL(request.url).pathname;
    return Promise.resolve({
      match: (request: Request | string) => Promise.resolve(entries.get(key(request))?.clone()),
      put: (request: Request | string, response: Response) => {
        entries.set(key(request), response);
        return Promise.resolve();
      },
    } as unknown as Cache);
  }

  delete(name: string): Promise<boolean> {
    return Promise.resolve(this.kept.delete(name));
  }
}

const request = (path: string): Request => new Request(ORIGIN + path);

describe('what the worker answers', () => {
  it('is the page and files whose names say their content, never what the cloud knows', () => {
    expect(routeOf(asked('/follow', { mode: 'navigate' }), ORIGIN)).toBe('page');
    expect(routeOf(asked('/assets/index-abc.js'), ORIGIN)).toBe('asset');
    for (const path of ['/api/v1/follows', '/api/v1/session', '/services/x', '/', '/follow-worker.js']) {
      expect(routeOf(asked(path), ORIGIN), path).toBe('network');
    }
    expect(routeOf(asked('/api/v1/drones', { mode: 'navigate' }), ORIGIN)).toBe('network');
    expect(routeOf(asked('/follow', { mode: 'navigate', method: 'POST' }), ORIGIN)).toBe('network');
    expect(routeOf(asked('/assets/tile.png'), 'https://other.example')).toBe('network');
  });
});

describe('the kept page', () => {
  it('is shown only where there is no network', async () => {
    const fetcher = vi.fn(() => Promise.resolve(new Response('one')));
    const shell = new Shell(new FakeCaches() as unknown as CacheStorage, fetcher);
    await shell.page(request('/follow'));
    fetcher.mockResolvedValueOnce(new Response('two'));
    expect(await (await shell.page(request('/follow'))).text()).toBe('two');
    fetcher.mockRejectedValueOnce(new TypeError('no network'));
    expect(await (await shell.page(request('/follow'))).text()).toBe('two');
  });

  it('is shown, too, where the network says nothing for long', async () => {
    const fetcher = vi.fn(() => Promise.resolve(new Response('one')));
    let late: () => void = () => undefined;
    const patience = (): Promise<void> => new Promise((resolve) => (late = resolve));
    const shell = new Shell(new FakeCaches() as unknown as CacheStorage, fetcher, patience);
    await shell.page(request('/follow'));
    fetcher.mockReturnValueOnce(new Promise(() => undefined));
    const shown = shell.page(request('/follow'));
    await new Promise((resolve) => setTimeout(resolve));
    late();
    expect(await (await shown).text()).toBe('one');
  });

  it('is nothing that failed', async () => {
    const fetcher = vi.fn(() => Promise.resolve(new Response('broken', { status: 500 })));
    const shell = new Shell(new FakeCaches() as unknown as CacheStorage, fetcher);
    await shell.page(request('/follow'));
    fetcher.mockRejectedValueOnce(new TypeError('no network'));
    await expect(shell.page(request('/follow'))).rejects.toThrow('no network');
  });

  it('leaves no files behind that another one had', async () => {
    const caches = new FakeCaches();
    let page = 'one';
    const shell = new Shell(caches as unknown as CacheStorage, () => Promise.resolve(new Response(page)));
    await shell.page(request('/follow'));
    await shell.asset(request('/assets/a.js'));
    await shell.page(request('/follow'));
    expect(caches.kept.get('/assets/')?.size).toBe(1);
    page = 'two';
    await shell.page(request('/follow'));
    expect(caches.kept.get('/assets/')).toBeUndefined();
  });
});
