import type { Point, Polygon } from 'geojson';
import type { Command } from './types';

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

  replace(id: string, zone: NewZone): Promise<Zone> {
    return this.#call('PUT', `/zones/${encodeURIComponent(id)}`, zone);
  }

  /** All zones of a GeoJSON file, or none. */
  async take(file: Blob): Promise<Zone[]> {
    return (await this.#call<{ features: Zone[] }>('POST', '/zones/import', file)).features;
  }

  /** Makes the zones that bind a drone its own fence. */
  putOnBoard(drone: string): Promise<Command> {
    return this.#call('PUT', `/drones/${encodeURIComponent(drone)}/fence/zones`);
  }

  /** Has the vehicle's fence read. */
  askOnBoard(drone: string): Promise<Command> {
    return this.#call('POST', `/drones/${encodeURIComponent(drone)}/fence/refresh`);
  }

  /** How many areas the vehicle keeps itself; null: it was not asked yet. */
  async onBoard(drone: string): Promise<number | null> {
    type Fence = { zones: unknown[] | null };
    const fence = await this.#call<Fence>('GET', `/drones/${encodeURIComponent(drone)}/fence`);
    return fence.zones?.length ?? null;
  }

  remove(id: string): Promise<void> {
    return this.#call('DELETE', `/zones/${encodeURIComponent(id)}`);
  }
}
