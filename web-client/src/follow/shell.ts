/** page: the one document of the phone page; asset: a file whose name changes with its content. */
export type Route = 'page' | 'asset' | 'network';

export type Asked = Pick<Request, 'method' | 'mode' | 'url'>;

const PAGE = '/follow';
const ASSETS = '/assets/';

/** The source of each response: data of the cloud come from the cloud alone, or not at all. */
export function routeOf({ method, mode, url }: Asked, origin: string): Route {
  const address = new URL(url);
  if (method !== 'GET' || address.origin !== origin) {
    return 'network';
  }
  if (address.pathname.startsWith(ASSETS)) {
    return 'asset';
  }
  return mode === 'navigate' && address.pathname === PAGE ? 'page' : 'network';
}

type Fetch = (request: Request) => Promise<Response>;

/** A network that is gone says nothing at all, often for minutes. */
const SOON_MILLISECONDS = 4_000;

function soon(): Promise<unknown> {
  return new Promise((resolve) => setTimeout(resolve, SOON_MILLISECONDS));
}

/** Lets the phone page open where there is no network: its document and its files, nothing else. */
export class Shell {
  readonly #caches: CacheStorage;
  readonly #fetch: Fetch;
  readonly #late: () => Promise<unknown>;

  /** `late`: comes when an answer would be too late. */
  constructor(caches: CacheStorage, fetcher: Fetch, late: () => Promise<unknown> = soon) {
    this.#caches = caches;
    this.#fetch = fetcher;
    this.#late = late;
  }

  /** The newest there is; the one before only where none can be had, or not soon. */
  async page(request: Request): Promise<Response> {
    const cache = await this.#caches.open(PAGE);
    const kept = await cache.match(PAGE);
    const fresh = this.#fresh(cache, request);
    if (kept === undefined) {
      return fresh;
    }
    return Promise.race([fresh.catch(() => kept), this.#late().then(() => kept)]);
  }

  async #fresh(cache: Cache, request: Request): Promise<Response> {
    const response = await this.#fetch(request);
    if (response.ok) {
      await this.#keep(cache, response.clone());
    }
    return response;
  }

  /** Its name says its content: what is kept is right. */
  async asset(request: Request): Promise<Response> {
    const cache = await this.#caches.open(ASSETS);
    const kept = await cache.match(request);
    if (kept !== undefined) {
      return kept;
    }
    const response = await this.#fetch(request);
    if (response.ok) {
      await cache.put(request, response.clone());
    }
    return response;
  }

  /** Another document has other files: those of the one before are not kept. */
  async #keep(cache: Cache, page: Response): Promise<void> {
    const before = await cache.match(PAGE);
    if (before !== undefined && (await before.text()) !== (await page.clone().text())) {
      await this.#caches.delete(ASSETS);
    }
    await cache.put(PAGE, page);
  }
}
