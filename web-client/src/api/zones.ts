import type { Point, Polygon } from 'geojson';
import type { Command } from './types';
import type { FenceView, ZoneFeature, ZoneProperties as ZoneRequestProperties } from './contract';

/** Whole, as the server answers it: its description is of what it takes as well. */
export type ZoneProperties = Required<ZoneRequestProperties> & {
  [K in 'name' | 'kind' | 'altitudeReference' | 'onBreach']: NonNullable<ZoneRequestProperties[K]>;
};

/** An area of the cloud that drones stay in or out of: a feature of GeoJSON, a circle being a point with a radius. */
export type Zone = { [K in 'type' | 'id']: NonNullable<ZoneFeature[K]> } & {
  geometry: Polygon | Point;
  properties: ZoneProperties;
};

export type NewZone = Omit<Zone, 'id' | 'properties'> & { properties: ZoneRequestProperties };

export type BreachAction = ZoneProperties['onBreach'];

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
  async importFile(file: Blob): Promise<Zone[]> {
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

  /** The number of areas in the fence of the vehicle; null: it was not read yet. */
  async onBoard(drone: string): Promise<number | null> {
    const fence = await this.#call<FenceView>('GET', `/drones/${encodeURIComponent(drone)}/fence`);
    return fence.zones?.length ?? null;
  }

  remove(id: string): Promise<void> {
    return this.#call('DELETE', `/zones/${encodeURIComponent(id)}`);
  }
}
