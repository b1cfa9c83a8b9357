// The objects of the wire contract, as the server sends them. An unknown fact is null, never 0.
//
// They come from the client, which has them from the descriptions; some are narrower here.

import type { PlannedItem, WithItems } from './items';
import type { MissionRun } from './runs';
import type { VirtualDrone } from './virtual';
import type { Zone } from './zones';
import type {
  DroneActionView as Action,
  CommandView as Command,
  DroneView,
  DroneLinkView as Link,
  DroneMissionView as MissionView,
  CommandOutcomeView as Outcome,
  CommandRequest as Request,
  SavedMissionView,
  SetRelayCommand,
  StartMissionCommand,
  ProblemBody,
  DroneMessageView as VehicleMessage,
  StreamMessage as ServerMessage,
} from '@dronemap/client';

export type { Action, Command, Link, Outcome, VehicleMessage };
export type {
  DroneAttitudeView as Attitude,
  DroneBatteryView as Battery,
  DroneGpsView as Gps,
  DroneHomeView as Home,
  DroneQualityView as LinkQuality,
  DroneLinkTrendView as LinkTrend,
  DroneLocalView as LocalPosition,
  DroneMotionView as Motion,
  DronePositionView as Position,
  SettingsView as Settings,
} from '@dronemap/client';

/** `ended`: the recording that it comes from has been played to its end. */
export type LinkState = Link['state'];

export type DroneKind = Drone['kind'];

export type FlightState = NonNullable<Drone['flight']>;

export type Severity = VehicleMessage['severity'];

export type CommandPhase = Command['phase'];

export type CommandResult = Outcome['result'];

export type CommandKind = Command['type'];

/** The failsafe of a vehicle on a mission when it loses the cloud. */
export type CloudLoss = NonNullable<StartMissionCommand['onCloudLoss']>;

export type RelaySetting = SetRelayCommand['setting'];

/** The mission that the vehicle itself holds, as read back from it. */
export type VehicleMission = WithItems<MissionView>;

export type SavedMission = WithItems<SavedMissionView>;

export type Drone = Omit<DroneView, 'mission' | 'actions'> & {
  mission: VehicleMission;
  actions: Partial<Record<CommandKind | 'velocity' | 'forceDisarm', Action>>;
};

/** A command to a drone; the items of a mission as the page has them. */
export type CommandRequest =
  Exclude<Request, { type: 'uploadMission' }> | { type: 'uploadMission'; items: PlannedItem[] };

export type { AltitudeReference, LookAtItem, MissionItem, PlannedItem, WaypointItem } from './items';

/** Speeds from the vehicle's own nose, in m/s, and a turn in degrees a second, clockwise. */
export type Velocity = { frame: 'vehicle' } & Record<'forward' | 'right' | 'down' | 'turn', number>;

/** Types that are narrower on the page than in the description of the stream. */
interface NarrowedMembers {
  drone: Drone;
  drones: Drone[];
  zone: Zone;
  virtualDrone: VirtualDrone;
  run: MissionRun;
  problem: ProblemBody;
}

type Narrowed<M> = M extends unknown
  ? {
      [N in keyof M]: N extends keyof NarrowedMembers
        ? M[N] extends string
          ? M[N]
          : NarrowedMembers[N]
        : M[N];
    }
  : never;

export type StreamMessage = Narrowed<ServerMessage>;

export type { StreamRequest } from '@dronemap/client';
