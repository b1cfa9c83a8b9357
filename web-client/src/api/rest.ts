import { RestClient as Client, type Fetch, type StreamTicket } from '@dronemap/client';
import { AccessKeyCalls } from './access-keys';
import { AccountCalls, type Session } from './accounts';
import { AuditCalls } from './audit';
import { ControlCalls } from './control';
import type { DtlsKey, Endpoint, NewRobotKey, RobotKey } from './endpoints';
import { FlightCalls } from './flights';
import { DispatchCalls } from './dispatches';
import { RecoveryCalls } from './recoveries';
import { FollowCalls } from './follows';
import { GrantCalls } from './grants';
import type { LinkPolicy, LinkSecurity, NewLinkKey } from './link-security';
import { OutletCalls } from './outlet';
import type { ParameterFile, ParameterPage } from './parameters';
import { PlanCalls } from './plans';
import type { RecordingPage } from './recordings';
import { RunCalls } from './runs';
import type { Sensed } from './sensed';
import type { Command, CommandRequest, Drone, PlannedItem, SavedMission, Settings } from './types';
import type { WaitingVehicle } from './waiting';
import { VirtualCalls } from './virtual';
import { ZoneCalls } from './zones';

/** `epoch`: of the control that the page believes to have. */
export type SentCommand = CommandRequest & { id: string; epoch?: number | null };

/** A connection that takes longer counts as lost, so that nobody waits for it when it is back. */
const TICKET_MILLISECONDS = 4_000;

/** The operations of the cloud that the page uses, as it calls them. Each rejects with a Problem. */
export class RestClient {
  readonly #client: Client;
  readonly #rest: Client['operations'];
  readonly accessKeys: AccessKeyCalls;
  readonly accounts: AccountCalls;
  readonly audit: AuditCalls;
  readonly flights: FlightCalls;
  readonly follows: FollowCalls;
  readonly dispatches: DispatchCalls;
  readonly recoveries: RecoveryCalls;
  readonly control: ControlCalls;
  readonly grants: GrantCalls;
  readonly outlet: OutletCalls;
  readonly plans: PlanCalls;
  readonly runs: RunCalls;
  readonly virtuals: VirtualCalls;
  readonly zones: ZoneCalls;

  constructor(fetcher?: Fetch) {
    const client = new Client({ url: '', fetch: fetcher });
    const rest = client.operations;
    this.#client = client;
    this.#rest = rest;
    this.accessKeys = new AccessKeyCalls(rest);
    this.accounts = new AccountCalls(rest);
    this.audit = new AuditCalls(client);
    this.flights = new FlightCalls(client);
    this.follows = new FollowCalls(rest);
    this.dispatches = new DispatchCalls(rest);
    this.recoveries = new RecoveryCalls(rest);
    this.control = new ControlCalls(rest);
    this.grants = new GrantCalls(rest);
    this.outlet = new OutletCalls(rest);
    this.plans = new PlanCalls(rest);
    this.runs = new RunCalls(rest);
    this.virtuals = new VirtualCalls(rest);
    this.zones = new ZoneCalls(rest);
  }

  /** Where to sign in with the provider. */
  get providerAddress(): string {
    return this.#client.address('startSignInElsewhere', {});
  }

  session(): Promise<Session> {
    return this.#rest.getSession();
  }

  signIn(name: string, password: string): Promise<Session> {
    return this.#rest.signIn({ name, password });
  }

  signOut(): Promise<void> {
    return this.#rest.signOut();
  }

  signOutEverywhere(): Promise<void> {
    return this.#rest.signOutEverywhere();
  }

  changePassword(current: string, next: string): Promise<void> {
    return this.#rest.changePassword({ current, next });
  }

  settings(): Promise<Settings> {
    return this.#rest.getSettings();
  }

  streamTicket(): Promise<StreamTicket> {
    return this.#rest.makeStreamTicket({ timeout: TICKET_MILLISECONDS });
  }

  renameDrone(id: string, name: string): Promise<Drone> {
    return this.#rest.renameDrone({ id }, { name }) as Promise<Drone>;
  }

  deleteDrone(id: string): Promise<void> {
    return this.#rest.removeDrone({ id });
  }

  linkSecurity(id: string): Promise<LinkSecurity> {
    return this.#rest.getLinkSecurity({ id });
  }

  setLinkPolicy(id: string, policy: LinkPolicy): Promise<LinkSecurity> {
    return this.#rest.setLinkSecurity({ id }, { policy });
  }

  makeLinkKey(id: string): Promise<NewLinkKey> {
    return this.#rest.makeLinkKey({ id }, {});
  }

  /** `confirm`: the user vouches that nobody listens on the link. */
  installLinkKey(id: string, confirm: boolean): Promise<LinkSecurity> {
    return this.#rest.installLinkKey({ id }, { confirm });
  }

  rotateLinkKey(id: string, confirm: boolean): Promise<LinkSecurity> {
    return this.#rest.rotateLinkKey({ id }, { confirm });
  }

  revokeLinkKey(id: string): Promise<LinkSecurity> {
    return this.#rest.deleteLinkKey({ id });
  }

  async waiting(): Promise<WaitingVehicle[]> {
    return (await this.#rest.listWaiting()).waiting;
  }

  enrol(id: string): Promise<Drone> {
    return this.#rest.enrolWaiting({ id }, {}) as Promise<Drone>;
  }

  dismissWaiting(id: string): Promise<void> {
    return this.#rest.dismissWaiting({ id });
  }

  sendCommand(drone: string, request: SentCommand): Promise<Command> {
    return this.#rest.giveCommand({ id: drone }, request);
  }

  async commandsOf(drone: string): Promise<Command[]> {
    return (await this.#rest.listCommands({ id: drone })).commands;
  }

  command(id: string): Promise<Command> {
    return this.#rest.getCommand({ id });
  }

  async missions(): Promise<SavedMission[]> {
    return (await this.#rest.listMissions()).missions as SavedMission[];
  }

  saveMission(name: string, items: PlannedItem[]): Promise<SavedMission> {
    return this.#rest.addMission({ name, items }) as Promise<SavedMission>;
  }

  replaceMission(id: string, name: string, items: PlannedItem[]): Promise<SavedMission> {
    return this.#rest.replaceMission({ id }, { name, items }) as Promise<SavedMission>;
  }

  deleteMission(id: string): Promise<void> {
    return this.#rest.deleteMission({ id });
  }

  parametersOf(drone: string): Promise<ParameterPage> {
    return this.#rest.listParameters({ id: drone });
  }

  /** The address to save the parameters from: a list for Mission Planner and MAVProxy, a table for QGroundControl. */
  parameterFileAddress(drone: string, form: 'list' | 'table'): string {
    return this.#client.address('exportParameters', { id: drone, form });
  }

  /** Compares a file with the vehicle; nothing is sent to it. */
  compareParameterFile(drone: string, file: Blob): Promise<ParameterFile> {
    return this.#rest.importParameters({ id: drone, dryRun: true }, file);
  }

  recordingsOf(drone: string): Promise<RecordingPage> {
    return this.#rest.listRecordings({ drone });
  }

  /** The address to download a recording from. */
  recordingAddress(id: string): string {
    return this.#client.address('getRecordingFile', { id });
  }

  /** The address to download the table of sent messages from. */
  sentAddress(id: string): string {
    return this.#client.address('getRecordingSent', { id });
  }

  replayRecording(id: string, speed: number): Promise<unknown> {
    return this.#rest.replayRecording({ id, speed });
  }

  deleteRecording(id: string): Promise<void> {
    return this.#rest.deleteRecording({ id, confirm: true });
  }

  async endpoints(): Promise<Endpoint[]> {
    return (await this.#rest.listEndpoints()).endpoints;
  }

  addEndpoint(url: string): Promise<Endpoint> {
    return this.#rest.addEndpoint({ url });
  }

  removeEndpoint(id: string): Promise<void> {
    return this.#rest.removeEndpoint({ id });
  }

  async dtlsKeys(): Promise<DtlsKey[]> {
    return (await this.#rest.listDtlsKeys()).dtlsKeys;
  }

  createDtlsKey(label: string): Promise<DtlsKey> {
    return this.#rest.makeDtlsKey({ label });
  }

  revokeDtlsKey(identity: string): Promise<void> {
    return this.#rest.deleteDtlsKey({ identity });
  }

  sensed(droneId: string): Promise<Sensed> {
    return this.#rest.getSensed({ id: droneId });
  }

  /** The address of the newest picture of that kind; another one for each picture. */
  pictureAddress(droneId: string, kind: 'picture' | 'map', number: number): string {
    const operation = kind === 'map' ? 'getSensedMap' : 'getSensedPicture';
    return `${this.#client.address(operation, { id: droneId })}?number=${number}`;
  }

  async robotKeys(): Promise<RobotKey[]> {
    return (await this.#rest.listRobotKeys()).robotKeys;
  }

  issueRobotKey(robot: NewRobotKey): Promise<RobotKey> {
    return this.#rest.issueRobotKey(robot);
  }

  revokeRobotKey(id: string): Promise<void> {
    return this.#rest.revokeRobotKey({ id });
  }
}
