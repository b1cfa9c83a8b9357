import { AccessKeyCalls } from './access-keys';
import { AccountCalls, type Session } from './accounts';
import { AuditCalls } from './audit';
import type { Commands, DtlsKeys, Endpoints, RobotKeys, StreamTicket, Waitings } from './contract';
import { ControlCalls } from './control';
import type { DtlsKey, Endpoint, NewRobotKey, RobotKey } from './endpoints';
import { FlightCalls } from './flights';
import { FollowCalls } from './follows';
import { GrantCalls } from './grants';
import type { LinkPolicy, LinkSecurity, NewLinkKey } from './link-security';
import { OutletCalls } from './outlet';
import type { ParameterFile, ParameterPage } from './parameters';
import { PlanCalls } from './plans';
import { Problem } from './problem';
import type { RecordingPage } from './recordings';
import { RunCalls } from './runs';
import type { Sensed } from './sensed';
import type {
  Command,
  CommandRequest,
  Drone,
  PlannedItem,
  ProblemBody,
  SavedMission,
  Settings,
} from './types';
import type { WaitingVehicle } from './waiting';
import { VirtualCalls } from './virtual';
import { ZoneCalls } from './zones';

/** `epoch`: of the control that the page believes to have. */
export type SentCommand = CommandRequest & { id: string; epoch?: number | null };

/** A connection that takes longer counts as lost, so that nobody waits for it when it is back. */
const TICKET_MILLISECONDS = 4_000;

type Fetch = (input: string, init?: RequestInit) => Promise<Response>;

/** The REST face of the cloud. Every call resolves with the contract's object or rejects with a Problem. */
export class RestClient {
  readonly #base: string;
  readonly #fetch: Fetch;
  readonly accessKeys = new AccessKeyCalls((method, path, body) => this.#call(method, path, body));
  readonly accounts = new AccountCalls((method, path, body) => this.#call(method, path, body));
  readonly audit: AuditCalls;
  readonly flights: FlightCalls;
  readonly follows = new FollowCalls((method, path, body, longest) =>
    this.#call(method, path, body, longest),
  );
  readonly control = new ControlCalls((method, path, body) => this.#call(method, path, body));
  readonly grants = new GrantCalls((method, path, body) => this.#call(method, path, body));
  readonly outlet = new OutletCalls((method, path, body) => this.#call(method, path, body));
  readonly plans = new PlanCalls((method, path, body) => this.#call(method, path, body));
  readonly runs = new RunCalls((method, path, body) => this.#call(method, path, body));
  readonly virtuals = new VirtualCalls((method, path, body) => this.#call(method, path, body));
  readonly zones = new ZoneCalls((method, path, body) => this.#call(method, path, body));

  constructor(base = '/api/v1', fetcher: Fetch = (input, init) => fetch(input, init)) {
    this.#base = base;
    this.#fetch = fetcher;
    this.flights = new FlightCalls((method, path, body) => this.#call(method, path, body), base);
    this.audit = new AuditCalls((method, path, body) => this.#call(method, path, body), base);
  }

  session(): Promise<Session> {
    return this.#call('GET', '/session');
  }

  signIn(name: string, password: string): Promise<Session> {
    return this.#call('POST', '/session', { name, password });
  }

  signOut(): Promise<void> {
    return this.#call('DELETE', '/session');
  }

  signOutEverywhere(): Promise<void> {
    return this.#call('POST', '/session/sign-out-everywhere');
  }

  changePassword(current: string, next: string): Promise<void> {
    return this.#call('POST', '/session/password', { current, next });
  }

  settings(): Promise<Settings> {
    return this.#call('GET', '/settings');
  }

  streamTicket(): Promise<StreamTicket> {
    return this.#call('POST', '/stream-tickets', undefined, TICKET_MILLISECONDS);
  }

  renameDrone(id: string, name: string): Promise<Drone> {
    return this.#call('PATCH', `/drones/${encodeURIComponent(id)}`, { name });
  }

  deleteDrone(id: string): Promise<void> {
    return this.#call('DELETE', `/drones/${encodeURIComponent(id)}`);
  }

  linkSecurity(id: string): Promise<LinkSecurity> {
    return this.#call('GET', `/drones/${encodeURIComponent(id)}/link-security`);
  }

  setLinkPolicy(id: string, policy: LinkPolicy): Promise<LinkSecurity> {
    return this.#call('PUT', `/drones/${encodeURIComponent(id)}/link-security`, { policy });
  }

  makeLinkKey(id: string): Promise<NewLinkKey> {
    return this.#call('POST', `/drones/${encodeURIComponent(id)}/link-key`, {});
  }

  /** `confirm`: the user vouches that nobody listens on the link. */
  installLinkKey(id: string, confirm: boolean): Promise<LinkSecurity> {
    return this.#call('POST', `/drones/${encodeURIComponent(id)}/link-key/install`, { confirm });
  }

  rotateLinkKey(id: string, confirm: boolean): Promise<LinkSecurity> {
    return this.#call('POST', `/drones/${encodeURIComponent(id)}/link-key/rotate`, { confirm });
  }

  revokeLinkKey(id: string): Promise<LinkSecurity> {
    return this.#call('DELETE', `/drones/${encodeURIComponent(id)}/link-key`);
  }

  async waiting(): Promise<WaitingVehicle[]> {
    return (await this.#call<Waitings>('GET', '/waiting')).waiting;
  }

  enrol(id: string): Promise<Drone> {
    return this.#call('POST', `/waiting/${encodeURIComponent(id)}/enrol`, {});
  }

  dismissWaiting(id: string): Promise<void> {
    return this.#call('DELETE', `/waiting/${encodeURIComponent(id)}`);
  }

  sendCommand(drone: string, request: SentCommand): Promise<Command> {
    return this.#call('POST', `/drones/${encodeURIComponent(drone)}/commands`, request);
  }

  async commandsOf(drone: string): Promise<Command[]> {
    const answer = await this.#call<Commands>('GET', `/drones/${encodeURIComponent(drone)}/commands`);
    return answer.commands;
  }

  command(id: string): Promise<Command> {
    return this.#call('GET', `/commands/${encodeURIComponent(id)}`);
  }

  async missions(): Promise<SavedMission[]> {
    const answer = await this.#call<{ missions: SavedMission[] }>('GET', '/missions');
    return answer.missions;
  }

  saveMission(name: string, items: PlannedItem[]): Promise<SavedMission> {
    return this.#call('POST', '/missions', { name, items });
  }

  replaceMission(id: string, name: string, items: PlannedItem[]): Promise<SavedMission> {
    return this.#call('PUT', `/missions/${encodeURIComponent(id)}`, { name, items });
  }

  deleteMission(id: string): Promise<void> {
    return this.#call('DELETE', `/missions/${encodeURIComponent(id)}`);
  }

  parametersOf(drone: string): Promise<ParameterPage> {
    return this.#call('GET', `/drones/${encodeURIComponent(drone)}/parameters`);
  }

  /** The address to save the parameters from: a list for Mission Planner and MAVProxy, a table for QGroundControl. */
  parameterFileAddress(drone: string, form: 'list' | 'table'): string {
    return `${this.#base}/drones/${encodeURIComponent(drone)}/parameters/file?form=${form}`;
  }

  /** Compares a file with the vehicle; nothing is sent to it. */
  compareParameterFile(drone: string, file: Blob): Promise<ParameterFile> {
    return this.#call('POST', `/drones/${encodeURIComponent(drone)}/parameters/file?dryRun=true`, file);
  }

  recordingsOf(drone: string): Promise<RecordingPage> {
    return this.#call('GET', `/recordings?drone=${encodeURIComponent(drone)}`);
  }

  /** The address to download a recording from. */
  recordingAddress(id: string): string {
    return `${this.#base}/recordings/${encodeURIComponent(id)}/file`;
  }

  /** The address to download the table of sent messages from. */
  sentAddress(id: string): string {
    return `${this.#base}/recordings/${encodeURIComponent(id)}/sent`;
  }

  replayRecording(id: string, speed: number): Promise<unknown> {
    return this.#call('POST', `/recordings/${encodeURIComponent(id)}/replays?speed=${speed}`);
  }

  deleteRecording(id: string): Promise<void> {
    return this.#call('DELETE', `/recordings/${encodeURIComponent(id)}?confirm=true`);
  }

  async endpoints(): Promise<Endpoint[]> {
    return (await this.#call<Endpoints>('GET', '/endpoints')).endpoints;
  }

  addEndpoint(url: string): Promise<Endpoint> {
    return this.#call('POST', '/endpoints', { url });
  }

  removeEndpoint(id: string): Promise<void> {
    return this.#call('DELETE', `/endpoints/${encodeURIComponent(id)}`);
  }

  async dtlsKeys(): Promise<DtlsKey[]> {
    return (await this.#call<DtlsKeys>('GET', '/dtls-keys')).dtlsKeys;
  }

  createDtlsKey(label: string): Promise<DtlsKey> {
    return this.#call('POST', '/dtls-keys', { label });
  }

  revokeDtlsKey(identity: string): Promise<void> {
    return this.#call('DELETE', `/dtls-keys/${encodeURIComponent(identity)}`);
  }

  sensed(droneId: string): Promise<Sensed> {
    return this.#call('GET', `/drones/${encodeURIComponent(droneId)}/sensed`);
  }

  /** The address of the newest picture of that kind; another one for each picture. */
  pictureAddress(droneId: string, kind: 'picture' | 'map', number: number): string {
    return `${this.#base}/drones/${encodeURIComponent(droneId)}/sensed/${kind}?number=${number}`;
  }

  async robotKeys(): Promise<RobotKey[]> {
    return (await this.#call<RobotKeys>('GET', '/robot-keys')).robotKeys;
  }

  issueRobotKey(robot: NewRobotKey): Promise<RobotKey> {
    return this.#call('POST', '/robot-keys', robot);
  }

  revokeRobotKey(id: string): Promise<void> {
    return this.#call('DELETE', `/robot-keys/${encodeURIComponent(id)}`);
  }

  /** `longest`: milliseconds until it is given up, for calls that are repeated over a connection that may be dead. */
  async #call<T>(method: string, path: string, body?: unknown, longest?: number): Promise<T> {
    const { response, text } = await this.#send(method, path, body, longest);
    if (!response.ok) {
      throw new Problem(problemFrom(response.status, text));
    }
    return (text === '' ? undefined : JSON.parse(text)) as T;
  }

  async #send(
    method: string,
    path: string,
    body: unknown,
    longest: number | undefined,
  ): Promise<{ response: Response; text: string }> {
    // The custom header cannot be sent by a foreign page: it is the guard against forged requests.
    const headers: Record<string, string> = { Accept: 'application/json', 'X-Dronemap': '1' };
    const init: RequestInit = { method, headers, credentials: 'same-origin' };
    if (longest !== undefined) {
      init.signal = AbortSignal.timeout(longest);
    }
    if (body instanceof Blob) {
      headers['Content-Type'] = 'text/plain';
      init.body = body;
    } else if (body !== undefined) {
      headers['Content-Type'] = 'application/json';
      init.body = JSON.stringify(body);
    }
    try {
      const response = await this.#fetch(this.#base + path, init);
      return { response, text: await response.text() };
    } catch {
      throw Problem.unreachable();
    }
  }
}

function problemFrom(status: number, text: string): ProblemBody {
  try {
    return { ...(JSON.parse(text) as ProblemBody), status };
  } catch {
    // A proxy in between may answer with a page instead of a problem.
    return { status, detail: `The cloud answered with status ${status}.` };
  }
}
