// The items that missions are made of, as the page has them: a waypoint always says what its altitude is measured from.

import type { MissionItemView, WaypointItem as DescribedWaypoint } from '@dronemap/client';

export type { LookAtItem } from '@dronemap/client';

export type AltitudeReference = NonNullable<DescribedWaypoint['altitudeReference']>;

export type WaypointItem = DescribedWaypoint & { altitudeReference: AltitudeReference };

export type MissionItem = Exclude<MissionItemView, { type: 'waypoint' }> | WaypointItem;

/** One that may be written: not one of those that are only found on a vehicle. */
export type PlannedItem = Exclude<MissionItem, { type: 'other' }>;

/** An object that holds items, with their kinds distinguished. */
export type WithItems<T extends { items: unknown }> = Omit<T, 'items'> & {
  items: MissionItem[] | Extract<T['items'], null>;
};
