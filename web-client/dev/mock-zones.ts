// The zones of the mock server. They bind nobody there.
import { randomUUID } from 'node:crypto';
import type { Zone } from '../src/api/zones';
import type { ZoneCollection, ZoneFeature } from '@dronemap/client';
import type { Handler } from './mock-rest';
import { needed, Refusal } from './refusal';

/** The parts of the server that zones need. */
export interface ZonePorts {
  /** Who is signed in. */
  owner: () => string;
  broadcast: (message: unknown) => void;
}

export class MockZones {
  #zones: Zone[] = [];
  readonly #ports: ZonePorts;

  constructor(ports: ZonePorts) {
    this.#ports = ports;
  }

  readonly handlers: Record<string, Handler> = {
    listZones: () => ({ type: 'FeatureCollection', features: this.#zones }) satisfies ZoneCollection,
    addZone: (body: ZoneFeature) => this.#put(randomUUID(), body),
    getZone: (_, id) => this.#find(id),
    replaceZone: (body: ZoneFeature, id) => this.#put(this.#find(id).id, body),
    deleteZone: (_, id) => {
      this.#zones = this.#zones.filter((zone) => zone.id !== id);
      this.#ports.broadcast({ type: 'zoneRemoved', id });
    },
  };

  #find(id: string): Zone {
    const zone = this.#zones.find((one) => one.id === id);
    if (zone === undefined) {
      throw new Refusal(404, 'zone-unknown', `There is no zone ${id}.`, { parameters: { id } });
    }
    return zone;
  }

  #put(id: string, { geometry, properties }: ZoneFeature): Zone {
    const given = needed(properties, 'properties', 'a JSON object');
    const zone: Zone = {
      type: 'Feature',
      id,
      geometry: needed(geometry, 'geometry', 'a Polygon, or a Point with a radius') as Zone['geometry'],
      properties: {
        name: needed(given.name, 'properties.name', '1 to 80 characters'),
        kind: given.kind ?? 'exclusion',
        radius: given.radius ?? null,
        floor: given.floor ?? null,
        ceiling: given.ceiling ?? null,
        altitudeReference: given.altitudeReference ?? 'home',
        user: given.user ?? null,
        drone: given.drone ?? null,
        from: given.from ?? null,
        until: given.until ?? null,
        onBreach: given.onBreach ?? 'hold',
        by: this.#ports.owner(),
        changedAt: new Date().toISOString(),
      },
    };
    this.#zones = [...this.#zones.filter((one) => one.id !== id), zone];
    this.#ports.broadcast({ type: 'zone', zone });
    return zone;
  }
}
