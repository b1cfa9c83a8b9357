import type {
  Events,
  FlightView as Flight,
  EventView as FlightEvent,
  Flights as FlightPage,
  Points,
  SeriesView as Series,
  PointView as TrackPoint,
} from './contract';

export type { Flight, FlightEvent, FlightPage, Series, TrackPoint };
export type { FieldSeries as SeriesField } from './contract';

/** Empty: whatever it is. */
export interface FlightSearch {
  drone: string;
  user: string;
  words: string;
  /** Local time as a field of the page has it. */
  from: string;
  until: string;
}

export type TrackForm = 'csv' | 'geojson' | 'kml' | 'gpx' | 'parquet' | 'tlog';

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls about flights and what was measured in them. */
export class FlightCalls {
  readonly #call: Call;
  readonly #base: string;

  constructor(call: Call, base: string) {
    this.#call = call;
    this.#base = base;
  }

  /** Newest first; `before`: the id of the last flight of the page before. */
  page(search: FlightSearch, before: string | null): Promise<FlightPage> {
    const wanted = parameters(search);
    if (before !== null) {
      wanted.set('before', before);
    }
    return this.#call('GET', `/flights?${wanted}`);
  }

  annotate(id: string, notes: string): Promise<Flight> {
    return this.#call('PATCH', `/flights/${encodeURIComponent(id)}`, { notes });
  }

  /** `span`: a part of the flight, null: all of it. */
  series(
    id: string,
    fields: readonly string[],
    slots: number,
    span: { from: string; until: string } | null,
  ): Promise<Series> {
    const wanted = new URLSearchParams({ fields: fields.join(','), slots: String(slots), ...span });
    return this.#call('GET', `/flights/${encodeURIComponent(id)}/telemetry?${wanted}`);
  }

  /** Of the last hour, unless `span` says otherwise. */
  seriesOf(
    drone: string,
    fields: readonly string[],
    slots: number,
    span: { from: string; until: string } | null,
  ): Promise<Series> {
    const wanted = new URLSearchParams({ fields: fields.join(','), slots: String(slots), ...span });
    return this.#call('GET', `/drones/${encodeURIComponent(drone)}/telemetry?${wanted}`);
  }

  async points(id: string): Promise<TrackPoint[]> {
    const path = `/flights/${encodeURIComponent(id)}/telemetry/points?most=20000`;
    return (await this.#call<Points>('GET', path)).points;
  }

  async events(id: string): Promise<FlightEvent[]> {
    const path = `/flights/${encodeURIComponent(id)}/events`;
    return (await this.#call<Events>('GET', path)).events;
  }

  /** The address to download the track from. */
  fileAddress(id: string, form: TrackForm): string {
    return `${this.#base}/flights/${encodeURIComponent(id)}/telemetry/file?form=${form}`;
  }

  logbookAddress(search: FlightSearch): string {
    return `${this.#base}/flights/logbook?${parameters(search)}`;
  }
}

function parameters(search: FlightSearch): URLSearchParams {
  const wanted = new URLSearchParams();
  for (const name of ['drone', 'user', 'words'] as const) {
    if (search[name].trim() !== '') {
      wanted.set(name, search[name].trim());
    }
  }
  for (const name of ['from', 'until'] as const) {
    const time = new Date(search[name]);
    if (!Number.isNaN(time.getTime())) {
      wanted.set(name, time.toISOString());
    }
  }
  return wanted;
}
