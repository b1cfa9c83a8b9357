// The items that missions are made of. Their description lists the members of all kinds; which are there depends on the kind.

import type { MissionItemView } from './contract';

type Kind = NonNullable<MissionItemView['type']>;

/** A kind of item with the members that it always has. */
type Item<K extends Kind, M extends keyof MissionItemView = never> = { type: K } & {
  [N in M]: NonNullable<MissionItemView[N]>;
};

export type AltitudeReference = NonNullable<MissionItemView['altitudeReference']>;

export type WaypointItem = Item<'waypoint', 'latitude' | 'longitude' | 'altitude' | 'altitudeReference'> &
  Pick<MissionItemView, 'holdSeconds'>;

/** The camera points there until it is to look ahead again. */
export type LookAtItem = Item<'lookAt', 'latitude' | 'longitude' | 'altitude'> &
  Pick<MissionItemView, 'altitudeReference'>;

export type MissionItem =
  | Item<'takeOff', 'altitude'>
  | WaypointItem
  | Item<'returnToLaunch'>
  | Item<'land'>
  | Item<'wait', 'holdSeconds'>
  | Item<'takePhoto'>
  | Item<'setServo', 'output' | 'pulse'>
  | LookAtItem
  | Item<'lookAhead'>
  | Item<'other', 'description'>;

/** What holds items, with their kinds told apart. */
export type WithItems<T extends { items: unknown }> = Omit<T, 'items'> & {
  items: MissionItem[] | Extract<T['items'], null>;
};
