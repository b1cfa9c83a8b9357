/** A flight from arming to disarming, or until the drone was heard no more; null: not known, or none. */
export interface Flight {
  id: string;
  drone: string;
  droneName: string;
  start: string;
  /** null while it goes on. */
  end: string | null;
  state: 'running' | 'lost' | 'ended';
  seconds: number;
  /** Along the ground, in metres. */
  distance: number;
  /** Above home, in metres. */
  highest: number | null;
  /** Over ground, in m/s. */
  fastest: number | null;
  farthest: number | null;
  battery: { first: number | null; last: number | null; used: number | null };
  takeOff: { latitude: number; longitude: number } | null;
  last: { latitude: number; longitude: number } | null;
  users: string[];
  operation: string | null;
  notice: string | null;
  notes: string;
  recordings: string[];
}

export interface FlightPage {
  flights: Flight[];
  next: string | null;
}

/** Empty: whatever it is. */
export interface FlightSearch {
  drone: string;
  user: string;
  words: string;
  /** Local time as a field of the page has it. */
  from: string;
  until: string;
}

/** The least and the greatest value of each slot; null: not known then. */
export interface SeriesField {
  name: string;
  unit: string;
  least: (number | null)[];
  most: (number | null)[];
}

export interface Series {
  drone: string;
  from: string;
  until: string;
  slotSeconds: number;
  times: string[];
  fields: SeriesField[];
}

export interface TrackPoint {
  at: string;
  latitude: number | null;
  longitude: number | null;
  altitudeAmsl: number | null;
  altitudeAboveHome: number | null;
  heading: number | null;
  groundSpeed: number | null;
  climbRate: number | null;
  batteryPercent: number | null;
  armed: boolean | null;
  mode: string | null;
  flight: string | null;
  link: string;
}

export interface FlightEvent {
  at: string;
  kind: 'armed' | 'disarmed' | 'mode' | 'phase' | 'message' | 'command' | 'mission' | 'control';
  text: string;
  severity: string | null;
  by: string | null;
  command: string | null;
  result: string | null;
  reason: string | null;
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
    return (await this.#call<{ points: TrackPoint[] }>('GET', path)).points;
  }

  async events(id: string): Promise<FlightEvent[]> {
    const path = `/flights/${encodeURIComponent(id)}/events`;
    return (await this.#call<{ events: FlightEvent[] }>('GET', path)).events;
  }

  /** Where the browser downloads the track from. */
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
