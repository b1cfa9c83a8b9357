// The service worker of the phone page. Built into a file of its own, beside the page.
import { routeOf, Shell } from './shell';

/** The part of a service worker's world that is used here. */
interface Worker {
  caches: CacheStorage;
  location: { origin: string };
  addEventListener(type: 'fetch', listener: (event: Fetched) => void): void;
}

interface Fetched extends Event {
  request: Request;
  respondWith(answer: Promise<Response>): void;
}

const worker = self as unknown as Worker;
const shell = new Shell(worker.caches, (request) => fetch(request));

worker.addEventListener('fetch', (event) => {
  const route = routeOf(event.request, worker.location.origin);
  if (route !== 'network') {
    event.respondWith(shell[route](event.request));
  }
});
