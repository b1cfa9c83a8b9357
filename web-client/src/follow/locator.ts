import type { Fix, Locating, SourceListener, TargetSource } from './fix';

/** A receiver that does not move may report nothing; then a position is requested. */
export const ASK_AFTER_MILLISECONDS = 2_000;
const LONGEST_MILLISECONDS = 10_000;
const OPTIONS: PositionOptions = { enableHighAccuracy: true, maximumAge: 0, timeout: LONGEST_MILLISECONDS };

/** The phone's own receiver. */
export class PhoneReceiver implements TargetSource {
  readonly #geolocation: Geolocation | undefined;
  readonly #secure: boolean;

  constructor(
    geolocation: Geolocation | undefined = navigator.geolocation as Geolocation | undefined,
    secure: boolean = window.isSecureContext,
  ) {
    this.#geolocation = geolocation;
    this.#secure = secure;
  }

  start(listener: SourceListener): () => void {
    const geolocation = this.#geolocation;
    if (!this.#secure || geolocation === undefined) {
      listener.onLocating(this.#secure ? 'none' : 'insecure');
      return () => undefined;
    }
    listener.onLocating('asking');
    return watch(geolocation, listener);
  }
}

function watch(geolocation: Geolocation, listener: SourceListener): () => void {
  let receivedAt = performance.now();
  let asked = false;
  const receive = (position: GeolocationPosition): void => {
    receivedAt = performance.now();
    asked = false;
    listener.onLocating('on');
    listener.onFix(fixOf(position));
  };
  const fail = (error: GeolocationPositionError): void => {
    asked = false;
    listener.onLocating(locatingOf(error));
  };
  const id = geolocation.watchPosition(receive, fail, OPTIONS);
  const handle = setInterval(() => {
    if (!asked && performance.now() - receivedAt >= ASK_AFTER_MILLISECONDS) {
      asked = true;
      geolocation.getCurrentPosition(receive, fail, OPTIONS);
    }
  }, 500);
  return () => {
    geolocation.clearWatch(id);
    clearInterval(handle);
  };
}

function locatingOf(error: GeolocationPositionError): Locating {
  return error.code === error.PERMISSION_DENIED ? 'denied' : 'unavailable';
}

/** Browsers report NaN or null for what the receiver does not know. */
function fixOf({ coords, timestamp }: GeolocationPosition): Fix {
  return {
    at: Math.floor(timestamp),
    latitude: coords.latitude,
    longitude: coords.longitude,
    accuracy: coords.accuracy,
    speed: known(coords.speed),
    course: known(coords.heading),
  };
}

function known(value: number | null): number | null {
  return value === null || Number.isNaN(value) ? null : value;
}
