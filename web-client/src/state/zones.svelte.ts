import { sentenceFor } from '../api/problem';
import type { Zone, ZoneCalls, ZoneImport } from '../api/zones';
import type { Coordinates } from '../geo/coordinates';
import { featureOf, withPoint, type ZoneDraft } from '../zones/zone-draft';

/** The zones of the cloud, and the one that is being drawn. */
export class Zones {
  all = $state.raw<readonly Zone[]>([]);
  draft = $state.raw<ZoneDraft | null>(null);
  /** The zone that the map shall show; a new object each time. */
  wanted = $state.raw<{ zone: Zone } | null>(null);
  problem = $state<string | null>(null);
  /** What became of the file that was imported last. */
  imported = $state.raw<ZoneImport | null>(null);
  readonly #calls: ZoneCalls;

  constructor(calls: ZoneCalls) {
    this.#calls = calls;
  }

  async load(): Promise<void> {
    await this.#attempt(async () => {
      this.all = sorted(await this.#calls.all());
      this.#endDraftOfNone();
    });
  }

  apply(zone: Zone): void {
    this.all = sorted([...this.all.filter((one) => one.id !== zone.id), zone]);
  }

  applyRemoval(id: string): void {
    this.all = this.all.filter((one) => one.id !== id);
    this.#endDraftOfNone();
  }

  /** Somebody removed the zone that is being changed: what is drawn would belong to nothing. */
  #endDraftOfNone(): void {
    const id = this.draft?.id ?? null;
    if (id !== null && !this.all.some((one) => one.id === id)) {
      this.draft = null;
    }
  }

  clear(): void {
    this.all = [];
    this.draft = null;
    this.problem = null;
    this.imported = null;
  }

  addPoint(place: Coordinates): void {
    if (this.draft !== null) {
      this.draft = withPoint(this.draft, place);
    }
  }

  /** Sends what was drawn; it stays on the map as a draft when it was refused. */
  async save(): Promise<void> {
    const { draft } = this;
    if (draft !== null) {
      await this.#attempt(async () => {
        const zone = featureOf(draft);
        this.apply(await (draft.id === null ? this.#calls.add(zone) : this.#calls.replace(draft.id, zone)));
        this.draft = null;
      });
    }
  }

  async importFile(file: Blob): Promise<void> {
    this.imported = null;
    await this.#attempt(async () => {
      this.imported = await this.#calls.importFile(file);
      this.imported.zones.forEach((zone) => this.apply(zone));
    });
  }

  async remove(id: string): Promise<void> {
    await this.#attempt(async () => {
      await this.#calls.remove(id);
      this.applyRemoval(id);
    });
  }

  async #attempt(action: () => Promise<void>): Promise<void> {
    try {
      await action();
      this.problem = null;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
    }
  }
}

function sorted(zones: readonly Zone[]): Zone[] {
  return zones.toSorted((a, b) => a.properties.name.localeCompare(b.properties.name));
}
