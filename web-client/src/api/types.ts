// The objects of the wire contract, as the server sends them. An unknown fact is null, never 0.
//
// What REST answers and takes comes from contract.ts, which is written from its description. Written by hand are the
// messages of the stream, StreamMessage, StreamRequest and Velocity, and ProblemBody.

import type { Role } from './accounts';
import type { Control } from './control';
import type { MissionItem, WithItems } from './items';
import type { FleetPlan } from './plans';
import type { Follow, FollowNow, Positions, Receipt } from './follows';
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
  DroneMessageView as VehicleMessage,
} from './contract';

export type { Action, Command, Link, Outcome, VehicleMessage };
export type {
  DroneAttitudeView as Attitude,
  DroneBatteryView as Battery,
  DroneGpsView as Gps,
  DroneHomeView as Home,
  DroneQualityView as LinkQuality,
  DroneLocalView as LocalPosition,
  DroneMotionView as Motion,
  DronePositionView as Position,
  SettingsView as Settings,
} from './contract';

/** `ended`: the recording that it comes from has been played to its end. */
export type LinkState = Link['state'];

export type DroneKind = Drone['kind'];

export type FlightState = NonNullable<Drone['flight']>;

export type Severity = VehicleMessage['severity'];

export type CommandPhase = Command['phase'];

export type CommandResult = Outcome['result'];

export type CommandKind = Command['type'];

/** What a vehicle on a mission does by itself when it no longer hears the cloud. */
export type CloudLoss = NonNullable<StartMissionCommand['onCloudLoss']>;

export type RelaySetting = SetRelayCommand['setting'];

/** The mission that the vehicle itself holds, as read back from it. */
export type VehicleMission = WithItems<MissionView>;

export type SavedMission = WithItems<SavedMissionView>;

export type Drone = Omit<DroneView, 'mission' | 'actions'> & {
  mission: VehicleMission;
  actions: Partial<Record<CommandKind | 'velocity' | 'forceDisarm', Action>>;
};

/** What a drone is asked for; the items of a mission as the page has them. */
export type CommandRequest =
  Exclude<Request, { type: 'uploadMission' }> | { type: 'uploadMission'; items: MissionItem[] };

export type { AltitudeReference, LookAtItem, MissionItem, WaypointItem } from './items';

/** Speeds from the vehicle's own nose, in m/s, and a turn in degrees a second, clockwise. */
export interface Velocity {
  frame: 'vehicle';
  forward: number;
  right: number;
  down: number;
  turn: number;
}

/** What the page says on the stream; `requestId` comes back with an error. */
export type StreamRequest =
  | { type: 'steer'; requestId: string; drone: string; velocity: Velocity; epoch?: number }
  | { type: 'letGo'; requestId: string; drone: string }
  | { type: 'subscribe'; requestId: string; drones: readonly string[] | null; rate: number }
  | ({ type: 'positions'; requestId: string; follow: string } & Positions);

/** RFC 9457 problem details, with the field at fault and its allowed range where there is one. */
export interface ProblemBody {
  type?: string;
  title?: string;
  status: number;
  detail?: string;
  code?: string;
  parameters?: Record<string, string | number | boolean>;
  field?: string;
  allowed?: string;
  commandId?: string;
}

export type StreamMessage =
  | { type: 'hello'; user: string; role: Role }
  | { type: 'drones'; drones: Drone[] }
  | { type: 'drone'; drone: Drone }
  | { type: 'droneRemoved'; id: string }
  | { type: 'zone'; zone: Zone }
  | { type: 'zoneRemoved'; id: string }
  | { type: 'virtualDrone'; virtualDrone: VirtualDrone }
  | { type: 'virtualDroneRemoved'; id: string }
  | { type: 'plan'; plan: FleetPlan }
  | { type: 'planRemoved'; id: string }
  | { type: 'run'; run: MissionRun }
  | { type: 'follow'; follow: Follow }
  | { type: 'followNow'; id: string; now: FollowNow | null }
  | { type: 'positionsHeard'; requestId: string; receipt: Receipt }
  | { type: 'command'; command: Command }
  | { type: 'control'; drone: string; control: Control }
  | { type: 'ping'; at: string }
  | { type: 'pong' }
  | { type: 'commandAccepted'; requestId: string; command: Command }
  | { type: 'error'; problem: ProblemBody; requestId?: string };
