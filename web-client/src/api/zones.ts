import type { Point, Polygon } from 'geojson';
import type { Command } from './types';
import type { ZoneFeature, ZoneProperties as ZoneRequestProperties, RestOperations } from '@dronemap/client';

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

/** The calls around zones. */
export class ZoneCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  async all(): Promise<Zone[]> {
    return (await this.#rest.listZones()).features as Zone[];
  }

  add(zone: NewZone): Promise<Zone> {
    return this.#rest.addZone(zone as ZoneFeature) as Promise<Zone>;
  }

  replace(id: string, zone: NewZone): Promise<Zone> {
    return this.#rest.replaceZone({ id }, zone as ZoneFeature) as Promise<Zone>;
  }

  /** All zones of a GeoJSON file, or none. */
  async importFile(file: Blob): Promise<Zone[]> {
    return (await this.#rest.importZones(file)).features as Zone[];
  }

  /** Makes the zones that bind a drone its own fence. */
  putOnBoard(drone: string): Promise<Command> {
    return this.#rest.setFenceFromZones({ id: drone });
  }

  /** Has the vehicle's fence read. */
  askOnBoard(drone: string): Promise<Command> {
    return this.#rest.readFence({ id: drone });
  }

  /** The number of areas in the fence of the vehicle; null: it was not read yet. */
  async onBoard(drone: string): Promise<number | null> {
    const fence = await this.#rest.getFence({ id: drone });
    return fence.zones?.length ?? null;
  }

  remove(id: string): Promise<void> {
    return this.#rest.deleteZone({ id });
  }
}
