/** The cloud's time: the clock of this page, corrected by the pings of the stream. */
export class CloudClock {
  /** Milliseconds of the cloud's time, refreshed once a second for ages on the page. */
  now = $state(Date.now());
  #offset = 0;

  /** Sets the offset from the time in a ping. The newest ping counts alone, since each has its own delay. */
  synchronise(iso: string): void {
    const at = Date.parse(iso);
    if (!Number.isNaN(at)) {
      this.#offset = at - Date.now();
      this.refresh();
    }
  }

  refresh(): void {
    this.now = Date.now() + this.#offset;
  }

  /** The age in milliseconds; null when unknown. */
  since(iso: string | null): number | null {
    return iso === null ? null : Math.max(0, this.now - Date.parse(iso));
  }
}
