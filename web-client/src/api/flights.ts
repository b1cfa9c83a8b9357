import type {
  FlightView as Flight,
  EventView as FlightEvent,
  Flights as FlightPage,
  SeriesView as Series,
  PointView as TrackPoint,
  RestClient,
} from '@dronemap/client';
import { timeOf, wordsOf } from './search';

export type { Flight, FlightEvent, FlightPage, Series, TrackPoint };
export type { FieldSeries as SeriesField } from '@dronemap/client';

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

/** The calls about flights and what was measured in them. */
export class FlightCalls {
  readonly #rest: RestClient;

  constructor(rest: RestClient) {
    this.#rest = rest;
  }

  /** Newest first; `before`: the id of the last flight of the page before. */
  page(search: FlightSearch, before: string | null): Promise<FlightPage> {
    return this.#rest.operations.listFlights({ ...parameters(search), before: before ?? undefined });
  }

  annotate(id: string, notes: string): Promise<Flight> {
    return this.#rest.operations.annotateFlight({ id }, { notes });
  }

  /** `span`: a part of the flight, null: all of it. */
  series(
    id: string,
    fields: readonly string[],
    slots: number,
    span: { from: string; until: string } | null,
  ): Promise<Series> {
    const wanted = { fields: fields.join(','), slots: String(slots), ...span };
    return this.#rest.operations.getFlightTelemetry({ id, ...wanted });
  }

  /** Of the last hour, unless `span` says otherwise. */
  seriesOf(
    drone: string,
    fields: readonly string[],
    slots: number,
    span: { from: string; until: string } | null,
  ): Promise<Series> {
    const wanted = { fields: fields.join(','), slots: String(slots), ...span };
    return this.#rest.operations.getDroneTelemetry({ id: drone, ...wanted });
  }

  async points(id: string): Promise<TrackPoint[]> {
    return (await this.#rest.operations.listFlightTelemetryPoints({ id, most: '20000' })).points;
  }

  async events(id: string): Promise<FlightEvent[]> {
    return (await this.#rest.operations.listFlightEvents({ id })).events;
  }

  /** The address to download the track from. */
  fileAddress(id: string, form: TrackForm): string {
    return this.#rest.address('exportFlightTelemetry', { id, form });
  }

  logbookAddress(search: FlightSearch): string {
    return this.#rest.address('exportLogbook', parameters(search));
  }
}

function parameters(search: FlightSearch): Record<keyof FlightSearch, string | null> {
  return {
    drone: wordsOf(search.drone),
    user: wordsOf(search.user),
    words: wordsOf(search.words),
    from: timeOf(search.from),
    until: timeOf(search.until),
  };
}
