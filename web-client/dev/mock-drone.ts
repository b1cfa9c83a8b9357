import type { Command, CommandKind, CommandRequest, Drone, DroneKind, MissionItem } from '../src/api/types';

export interface Beginning {
  id: string;
  name: string;
  kind: DroneKind;
  vehicle: string;
  port: number;
  latitude: number;
  longitude: number;
  place: string;
  replay?: boolean;
}

export const METERS_PER_DEGREE = 111_320;
const SPEED = 8;
const CLIMB = 2.5;
const PATIENCE_MILLISECONDS = 30_000;

interface Goal {
  north: number;
  east: number;
  up: number;
}

/** A vehicle just true enough to develop the page against: it moves, refuses and runs missions. */
export class MockDrone {
  readonly beginning: Beginning;
  north = 0;
  east = 0;
  up = 0;
  armed = false;
  mode = 'LOITER';
  battery = 96;
  heading = 40;
  speed = 0;
  climb = 0;
  silentSince: number | null = null;
  items: MissionItem[] | null = [];
  current: number | null = null;
  reached: number[] = [];
  goal: Goal | null = null;
  version = 1;
  messages: Drone['messages'] = [];
  lastHeard = Date.now();
  commandedAt = Date.now();

  constructor(beginning: Beginning) {
    this.beginning = beginning;
    this.report('info', `${beginning.vehicle} V4.5.6 (mock)`);
  }

  report(severity: Drone['messages'][number]['severity'], text: string): void {
    this.messages = [...this.messages, { severity, text, at: new Date().toISOString() }].slice(-30);
  }

  step(seconds: number): void {
    if (this.silentSince !== null) {
      return;
    }
    this.lastHeard = Date.now();
    this.version += 1;
    this.speed = 0;
    this.climb = 0;
    if (!this.armed) {
      return;
    }
    this.battery = Math.max(5, this.battery - seconds * (this.up > 0.2 ? 0.05 : 0.005));
    if (this.mode === 'AUTO') {
      this.#followMission();
    }
    if (this.goal !== null) {
      this.#approach(this.goal, seconds);
    }
    if ((this.returnsAt() ?? Infinity) <= Date.now()) {
      this.#changeMode('returnToLaunch');
    }
    this.#settle();
  }

  /** Nobody has control of a mock vehicle: it comes home half a minute after its last command; null: not now. */
  returnsAt(): number | null {
    const waits = this.up > 0.3 && !['AUTO', 'RTL', 'LAND'].includes(this.mode);
    return waits ? this.commandedAt + PATIENCE_MILLISECONDS : null;
  }

  #approach(goal: Goal, seconds: number): void {
    const dn = goal.north - this.north;
    const de = goal.east - this.east;
    const distance = Math.hypot(dn, de);
    const du = goal.up - this.up;
    this.climb = Math.sign(du) * Math.min(CLIMB, Math.abs(du) / seconds);
    this.up += this.climb * seconds;
    if (distance > 0.3 && this.up > 0.5) {
      this.speed = Math.min(SPEED, distance / seconds);
      this.north += (dn / distance) * this.speed * seconds;
      this.east += (de / distance) * this.speed * seconds;
      this.heading = ((Math.atan2(de, dn) * 180) / Math.PI + 360) % 360;
    }
  }

  #settle(): void {
    const atGoal =
      this.goal !== null && Math.hypot(this.goal.north - this.north, this.goal.east - this.east) < 0.5;
    if (this.mode === 'RTL' && atGoal && this.goal !== null) {
      this.goal = { ...this.goal, up: 0 };
    }
    if ((this.mode === 'LAND' || this.mode === 'RTL') && this.up < 0.1) {
      this.armed = false;
      this.goal = null;
      this.up = 0;
      this.report('info', 'Disarming motors');
    }
  }

  #followMission(): void {
    const item = this.current === null ? undefined : this.items?.[this.current];
    if (item === undefined || this.current === null) {
      return;
    }
    this.goal = this.#goalOf(item);
    const { north, east, up } = this.goal;
    if (Math.hypot(north - this.north, east - this.east) < 0.6 && Math.abs(up - this.up) < 0.6) {
      this.reached = [...this.reached, this.current];
      this.report('info', `Reached command #${this.current + 1}`);
      const next = this.current + 1;
      this.current = next < (this.items?.length ?? 0) ? next : this.current;
      if (item.type === 'returnToLaunch') {
        this.mode = 'RTL';
      }
    }
  }

  #goalOf(item: MissionItem): Goal {
    switch (item.type) {
      case 'takeOff':
        return { north: this.north, east: this.east, up: item.altitude };
      case 'waypoint':
        return { ...this.local(item), up: item.altitude };
      case 'returnToLaunch':
        return { north: 0, east: 0, up: this.up };
      default:
        return { north: this.north, east: this.east, up: 0 };
    }
  }

  local(place: { latitude: number; longitude: number }): { north: number; east: number } {
    return {
      north: (place.latitude - this.beginning.latitude) * METERS_PER_DEGREE,
      east: (place.longitude - this.beginning.longitude) * METERS_PER_DEGREE * this.shrink(),
    };
  }

  shrink(): number {
    return Math.cos((this.beginning.latitude * Math.PI) / 180);
  }

  /** Why the gate would refuse this, or null. */
  why(type: CommandKind): string | null {
    if (this.silentSince !== null) {
      return 'The vehicle is lost: nothing reaches it.';
    }
    return this.#whyByFlight(type) ?? this.#whyByMission(type);
  }

  #whyByFlight(type: CommandKind): string | null {
    const flying = this.up > 0.3;
    const grounded = flying ? null : 'On the ground.';
    const rules: Partial<Record<CommandKind, string | null>> = {
      arm: this.armed ? 'Already armed.' : null,
      disarm: this.armed ? null : 'Already disarmed.',
      takeOff: !this.armed ? 'Arm first.' : flying ? 'Already flying.' : null,
      land: grounded,
      returnToLaunch: grounded,
      hold: grounded,
      goTo: flying ? null : 'Take off first.',
    };
    return rules[type] ?? null;
  }

  #whyByMission(type: CommandKind): string | null {
    const none = (this.items?.length ?? 0) > 0 ? null : 'No mission on the vehicle.';
    const rules: Partial<Record<CommandKind, string | null>> = {
      startMission: none ?? (this.armed ? null : 'Arm first.'),
      pauseMission: this.mode === 'AUTO' ? null : 'No mission is running.',
      clearMission: none,
    };
    return rules[type] ?? null;
  }

  act(request: CommandRequest): Command['outcome'] {
    this.commandedAt = Date.now();
    switch (request.type) {
      case 'arm':
        return this.#arm();
      case 'disarm':
        this.armed = false;
        break;
      case 'setMode':
        this.mode = request.mode;
        break;
      case 'takeOff':
        this.mode = 'GUIDED';
        this.goal = { north: this.north, east: this.east, up: request.altitude };
        break;
      case 'goTo':
        this.mode = 'GUIDED';
        this.goal = { ...this.local(request), up: request.altitude };
        break;
      case 'uploadMission':
        this.items = request.items;
        this.current = 0;
        this.reached = [];
        break;
      case 'clearMission':
        this.items = [];
        this.current = null;
        this.reached = [];
        break;
      default:
        this.#changeMode(request.type);
    }
    return { result: 'succeeded', by: 'vehicle', reason: null, code: null };
  }

  #changeMode(type: CommandRequest['type']): void {
    const here = { north: this.north, east: this.east };
    if (type === 'land') {
      this.mode = 'LAND';
      this.goal = { ...here, up: 0 };
    } else if (type === 'returnToLaunch') {
      this.mode = 'RTL';
      this.goal = { north: 0, east: 0, up: Math.max(this.up, 15) };
    } else if (type === 'startMission') {
      this.mode = 'AUTO';
      this.current = 0;
      this.reached = [];
    } else {
      this.mode = 'LOITER';
      this.goal = { ...here, up: this.up };
    }
  }

  #arm(): Command['outcome'] {
    if (this.beginning.name.endsWith('3')) {
      this.report('critical', 'PreArm: GPS 1: not healthy');
      return {
        result: 'refused',
        by: 'vehicle',
        reason: 'PreArm: GPS 1: not healthy',
        code: 'vehicle-failed',
      };
    }
    this.armed = true;
    this.mode = 'GUIDED';
    this.goal = null;
    this.report('info', 'Arming motors');
    return { result: 'succeeded', by: 'vehicle', reason: null, code: null };
  }
}
