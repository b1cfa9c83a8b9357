// The objects of the wire contract, as the server sends them. An unknown fact is null, never 0.

import type { Role } from './accounts';
import type { Control, Outlook, WithoutCloud } from './control';
import type { AltitudeReference, MissionItem } from './items';
import type { FleetPlan } from './plans';
import type { Follow, FollowNow, Positions, Receipt } from './follows';
import type { MissionRun } from './runs';
import type { SensedNumbers } from './sensed';
import type { VirtualDrone } from './virtual';
import type { Zone } from './zones';

export type { AltitudeReference, LookAtItem, MissionItem, WaypointItem } from './items';

/** `ended`: the recording that it comes from has been played to its end. */
export type LinkState = 'live' | 'suspect' | 'lost' | 'ended';

/** Shares from 0 to 1 that were lost over some 5 s and 60 s; milliseconds there and back. */
export interface LinkQuality {
  lossShort: number | null;
  lossLong: number | null;
  rttMs: number | null;
}

export interface Link {
  address: string;
  port: number;
  systemId: number;
  transport: string;
  state: LinkState;
  lastHeard: string | null;
  quality?: LinkQuality;
  /** Further addresses on which the same vehicle is heard. */
  others?: string[];
}

export type DroneKind =
  | 'multicopter'
  | 'helicopter'
  | 'fixedWing'
  | 'vtol'
  | 'rover'
  | 'boat'
  | 'submarine'
  | 'airship'
  | 'unknown';

export type FlightState = 'onGround' | 'takingOff' | 'inAir' | 'landing';

/** Degrees and metres; any member may be unknown by itself. */
export interface Position {
  latitude: number | null;
  longitude: number | null;
  altitudeAmsl: number | null;
  altitudeAboveHome: number | null;
}

/** Metres in a frame of its own, such as its map; degrees counter-clockwise from x. */
export interface LocalPosition {
  x: number;
  y: number;
  z: number | null;
  yaw: number | null;
}

export interface Motion {
  groundSpeed: number | null;
  airSpeed: number | null;
  climbRate: number | null;
  heading: number | null;
}

export interface Attitude {
  roll: number | null;
  pitch: number | null;
  yaw: number | null;
}

export interface Battery {
  percent: number | null;
  volts: number | null;
  amps: number | null;
}

export interface Gps {
  fix: string | null;
  satellites: number | null;
  hdop: number | null;
}

export interface Home {
  latitude: number;
  longitude: number;
  altitudeAmsl: number | null;
}

/** The mission that the vehicle itself holds, as read back from it. */
export interface VehicleMission {
  items: MissionItem[] | null;
  current: number | null;
  reached: number[];
  total: number | null;
  running: boolean;
  /** Null when the vehicle does not say. */
  state: 'stopped' | 'running' | 'paused' | 'complete' | null;
  notice: string | null;
  /** Equal hashes, equal missions. */
  hash?: string | null;
}

export type Severity = 'emergency' | 'alert' | 'critical' | 'error' | 'warning' | 'notice' | 'info' | 'debug';

export interface VehicleMessage {
  severity: Severity;
  text: string;
  at: string;
}

export type CommandKind =
  | 'arm'
  | 'disarm'
  | 'setMode'
  | 'takeOff'
  | 'land'
  | 'returnToLaunch'
  | 'hold'
  | 'goTo'
  | 'uploadMission'
  | 'startMission'
  | 'pauseMission'
  | 'clearMission'
  | 'turn'
  | 'takePicture'
  | 'setRelay'
  | 'setHome'
  | 'readHome'
  | 'readParameters'
  | 'setParameters'
  | 'readLogs'
  | 'goToLocal'
  | 'emergencyStop'
  | 'readMap';

/** Whether a command would be let through now, and if not the sentence that says why. */
export interface Action {
  allowed: boolean;
  why: string | null;
  mode?: string | null; // in which it works, where the one of now refuses it
}

export interface Drone {
  id: string;
  name: string;
  replay: boolean;
  link: Link;
  kind: DroneKind;
  autopilot: string | null;
  vehicle: string | null;
  firmware: string | null;
  mode: string | null;
  modes: string[];
  armed: boolean | null;
  readyToArm?: boolean | null; // what the vehicle's own pre-arm checks say
  flight: FlightState | null;
  position: Position | null;
  local?: LocalPosition | null;
  sensed?: SensedNumbers | null; // the newest that its sensors brought; null: there was none
  place: string | null;
  motion: Motion | null;
  attitude: Attitude | null;
  battery: Battery | null;
  gps: Gps | null;
  home: Home | null;
  mission: VehicleMission | null;
  messages: VehicleMessage[];
  actions: Partial<Record<CommandKind | 'velocity' | 'forceDisarm', Action>>; // forceDisarm: even in the air
  control?: Control;
  cloudLoss?: WithoutCloud;
  outlook: Outlook | null; // null: it is not in the air
  lastUpdate: string | null;
  version: number;
}

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

/** What a vehicle on a mission does by itself when it no longer hears the cloud. */
export type CloudLoss = 'continue' | 'rtl';

export type RelaySetting = 'on' | 'off' | 'toggle';

export type CommandRequest =
  | { type: 'arm' | 'land' | 'returnToLaunch' | 'hold' | 'pauseMission' | 'clearMission' }
  | { type: 'takePicture' | 'readHome' | 'readParameters' | 'emergencyStop' | 'readMap' }
  | { type: 'goToLocal'; x: number; y: number }
  | { type: 'turn'; degrees: number }
  | { type: 'setRelay'; relay: number; setting: RelaySetting }
  | { type: 'setHome'; latitude?: number; longitude?: number; altitude?: number; altitudeReference?: 'amsl' }
  | { type: 'setParameters'; parameters: { name: string; value: number }[] }
  | { type: 'startMission'; onCloudLoss: CloudLoss }
  | { type: 'disarm'; force?: boolean }
  | { type: 'setMode'; mode: string }
  | { type: 'takeOff'; altitude: number }
  | {
      type: 'goTo';
      latitude: number;
      longitude: number;
      altitude: number;
      altitudeReference?: AltitudeReference;
    }
  | { type: 'uploadMission'; items: MissionItem[] };

export type CommandPhase = 'sent' | 'accepted' | 'done';

export type CommandResult = 'succeeded' | 'refused' | 'failed' | 'timedOut' | 'superseded' | 'unknown';

export interface Outcome {
  result: CommandResult;
  by: 'vehicle' | 'gate' | null;
  reason: string | null;
}

export interface Command {
  id: string;
  drone: string;
  by: string;
  face: string;
  type: CommandKind;
  summary: string;
  at: string;
  phase: CommandPhase;
  outcome: Outcome | null;
  finishedAt: string | null;
  progress: { done: number; total: number } | null;
  /** Told once, to who gave the command. */
  warnings?: string[];
}

export interface SavedMission {
  id: string;
  name: string;
  items: MissionItem[];
  by: string;
  changedAt: string;
}

export interface Settings {
  streamPort: number;
  tileAddress: string | null;
  version: string;
  publicMode: boolean;
  /** Where phones learn to trust this server, by plain HTTP; null: nowhere. */
  phonePage?: string | null;
}

/** RFC 9457 problem details, with the field at fault and its allowed range where there is one. */
export interface ProblemBody {
  type?: string;
  title?: string;
  status: number;
  detail?: string;
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
