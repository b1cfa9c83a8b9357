import type { Point, Polygon } from 'geojson';
import type { Command } from './types';
import type {
  RestOperations,
  ZoneFeature,
  ZoneLeftOutView,
  ZoneProperties as ZoneRequestProperties,
} from '@dronemap/client';

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

/** What became of a file with zones. */
export interface ZoneImport {
  zones: readonly Zone[];
  leftOut: readonly ZoneLeftOutView[];
  leftOutTotal: number;
}

/** The fence of a vehicle: how many areas it has, and what of it cannot be shown. */
export interface FenceSummary {
  areas: number;
  returns: boolean;
  leftOut: readonly string[];
}

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

  /** Adds the zones of a GeoJSON, KML or KMZ file; what became none is named. */
  async importFile(file: Blob): Promise<ZoneImport> {
    const { features, leftOut, leftOutTotal } = await this.#rest.importZones(file);
    return { zones: features as Zone[], leftOut, leftOutTotal };
  }

  /** Makes the zones that bind a drone its own fence. */
  putOnBoard(drone: string): Promise<Command> {
    return this.#rest.setFenceFromZones({ id: drone });
  }

  /** Has the vehicle's fence read. */
  askOnBoard(drone: string): Promise<Command> {
    return this.#rest.readFence({ id: drone });
  }

  /** The fence of the vehicle; null: it was not read yet. */
  async onBoard(drone: string): Promise<FenceSummary | null> {
    const { zones, returnPoint, leftOut } = await this.#rest.getFence({ id: drone });
    return zones === null || zones === undefined
      ? null
      : { areas: zones.length, returns: (returnPoint ?? null) !== null, leftOut: leftOut ?? [] };
  }

  remove(id: string): Promise<void> {
    return this.#rest.deleteZone({ id });
  }
}
