import type { Feature, FeatureCollection, Position } from 'geojson';
import type { Follow } from '../api/follows';
import type { Coordinates } from '../geo/coordinates';
import { age } from '../ui/format';
import { moved } from './fix';
import { DEMO_NAME } from './following';
import { isHeldUp } from './follow-text';
import { silentSeconds } from './outage';

/** Somebody whom a drone stays with. */
export interface Target {
  id: string;
  at: Coordinates;
  /** Metres. */
  accuracy: number;
  label: string;
  /** The age of the position; empty: it is new. */
  age: string;
  tone: 'green' | 'amber' | 'blue' | 'violet' | 'neutral';
}

const CORNERS = 48;

/** The target with its accuracy, and a line to its drone. */
export function targetFeatures(target: Target, drone: Coordinates | null): Feature[] {
  const { id, at, accuracy, label, tone } = target;
  const features: Feature[] = [
    feature({ type: 'Polygon', coordinates: [circle(at, accuracy)] }, { tone }),
    feature(
      { type: 'Point', coordinates: positionOf(at) },
      { id, icon: `phone|dot|${tone}|plain`, label, tone, age: target.age },
    ),
  ];
  const line = drone === null ? [] : [positionOf(drone), positionOf(at)];
  return line.length === 0
    ? features
    : [feature({ type: 'LineString', coordinates: line }, { tone }), ...features];
}

/** The targets of all follows at their last positions; `droneAt`: the shown position of a drone. */
export function followFeatures(
  follows: readonly Follow[],
  cloudNow: number,
  droneAt: (drone: string) => Coordinates | null,
): FeatureCollection {
  return {
    type: 'FeatureCollection',
    features: follows.flatMap((follow) => {
      const phone = follow.now?.phone ?? null;
      if (phone === null) {
        return [];
      }
      const silent = silentSeconds(follow, cloudNow);
      const target: Target = {
        id: follow.drone,
        at: phone.at,
        accuracy: phone.accuracy,
        label: follow.name === DEMO_NAME ? `${follow.owner}, a demo walk` : follow.owner,
        age: silent === null ? '' : age(silent * 1000),
        tone:
          silent !== null || isHeldUp(follow) ? 'amber' : follow.state === 'tracking' ? 'green' : 'neutral',
      };
      return targetFeatures(target, droneAt(follow.drone));
    }),
  };
}

function circle(center: Coordinates, radius: number): Position[] {
  return Array.from({ length: CORNERS + 1 }, (_, corner) => {
    const angle = ((corner % CORNERS) / CORNERS) * 2 * Math.PI;
    return positionOf(moved(center, radius * Math.sin(angle), radius * Math.cos(angle)));
  });
}

function feature(geometry: Feature['geometry'], properties: Record<string, unknown>): Feature {
  return { type: 'Feature', properties, geometry };
}

function positionOf({ latitude, longitude }: Coordinates): Position {
  return [longitude, latitude];
}
