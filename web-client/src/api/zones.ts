import type { Point, Polygon } from 'geojson';

/** An area of the cloud that drones stay in or out of: a feature of GeoJSON, a circle being a point with a radius. */
export interface Zone {
  type: 'Feature';
  id: string;
  geometry: Polygon | Point;
  properties: ZoneProperties;
}

/** Metres; a null floor or ceiling is no bound, a null user and drone bind everybody. */
export interface ZoneProperties {
  name: string;
  kind: 'exclusion' | 'inclusion';
  radius: number | null;
  floor: number | null;
  ceiling: number | null;
  altitudeReference: 'home' | 'amsl';
  user: string | null;
  drone: string | null;
  from: string | null;
  until: string | null;
  onBreach: BreachAction;
}

export type BreachAction = 'hold' | 'returnToLaunch' | 'land';

export type NewZone = Omit<Zone, 'id' | 'properties'> & { properties: Partial<ZoneProperties> };

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls around zones. */
export class ZoneCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async all(): Promise<Zone[]> {
    return (await this.#call<{ features: Zone[] }>('GET', '/zones')).features;
  }

  add(zone: NewZone): Promise<Zone> {
    return this.#call('POST', '/zones', zone);
  }

  /** All zones of a GeoJSON file, or none. */
  async take(file: Blob): Promise<Zone[]> {
    return (await this.#call<{ features: Zone[] }>('POST', '/zones/import', file)).features;
  }

  remove(id: string): Promise<void> {
    return this.#call('DELETE', `/zones/${encodeURIComponent(id)}`);
  }
}
