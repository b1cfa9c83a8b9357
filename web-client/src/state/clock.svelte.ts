/** The cloud's time as far as this page can tell: its own clock corrected by what the pings said. */
export class CloudClock {
  /** Milliseconds of the cloud's time; ticks once a second, for ages on the page. */
  now = $state(Date.now());
  #offset = 0;

  /** The cloud says what time it is; the way here takes time too, so only the newest word counts. */
  hear(iso: string): void {
    const at = Date.parse(iso);
    if (!Number.isNaN(at)) {
      this.#offset = at - Date.now();
      this.tick();
    }
  }

  tick(): void {
    this.now = Date.now() + this.#offset;
  }

  /** How long ago, in milliseconds; null when unknown. */
  since(iso: string | null): number | null {
    return iso === null ? null : Math.max(0, this.now - Date.parse(iso));
  }
}
