// The items that missions are made of, as the server sends and takes them.

export type AltitudeReference = 'home' | 'amsl';

export interface WaypointItem {
  type: 'waypoint';
  latitude: number;
  longitude: number;
  altitude: number;
  altitudeReference: AltitudeReference;
  holdSeconds?: number | null;
}

export type MissionItem =
  | { type: 'takeOff'; altitude: number }
  | WaypointItem
  | { type: 'returnToLaunch' }
  | { type: 'land' }
  | { type: 'wait'; holdSeconds: number }
  | { type: 'takePhoto' }
  | { type: 'setServo'; output: number; pulse: number }
  | LookAtItem
  | { type: 'lookAhead' }
  | { type: 'other'; description: string };

/** The camera points there until it is to look ahead again. */
export interface LookAtItem {
  type: 'lookAt';
  latitude: number;
  longitude: number;
  altitude: number;
  altitudeReference?: AltitudeReference;
}
