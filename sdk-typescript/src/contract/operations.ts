// Written by npm run types from the description of REST.

import type { CallOptions, FileBody, Operation } from '../rest/operation.js';
import type {
  AccessKeys,
  AuditPage,
  AuditVerdictView,
  BroadcastRequest,
  BroadcastView,
  CommandRequest,
  CommandView,
  Commands,
  ControlAskRequest,
  ControlGrantRequest,
  ControlHandOverRequest,
  ControlHeartbeatRequest,
  ControlRefuseRequest,
  ControlTakeOverRequest,
  ControlView,
  Credentials,
  DispatchList,
  DispatchRequest,
  DispatchView,
  DroneView,
  Drones,
  DtlsKeyRequest,
  DtlsKeyView,
  DtlsKeys,
  EndpointRequest,
  EndpointView,
  Endpoints,
  EnrolRequest,
  Events,
  FenceRallyView,
  FenceView,
  FleetRequest,
  FleetView,
  Fleets,
  FlightNotes,
  FlightView,
  Flights,
  FollowList,
  FollowOpenRequest,
  FollowPlaceRequest,
  FollowPositionsRequest,
  FollowReceipt,
  FollowView,
  FollowedEvents,
  GiftRequest,
  GiftView,
  Gifts,
  GrantRequest,
  GrantView,
  Grants,
  GroupRequest,
  GroupView,
  Groups,
  HealthDetails,
  HealthView,
  HistoryView,
  InvitationView,
  Invitations,
  KeyRequest,
  KeyView,
  LeftBehind,
  LinkKeyRequest,
  LinkSecurityChangeRequest,
  LinkSecurityPolicyRequest,
  LinkSecurityView,
  LinkTraffic,
  LogsView,
  MadeLinkKey,
  MissionRequest,
  Missions,
  NewInvitation,
  NewUser,
  OneTimePassword,
  OnlyGrantedRequest,
  OrganisationNameRequest,
  OrganisationView,
  Organisations,
  OutletPortRequest,
  OutletPortView,
  OutletView,
  OwnOutletView,
  ParameterValueRequest,
  ParametersFileView,
  ParametersView,
  PassphraseRequest,
  PassphraseView,
  PasswordRequest,
  PlanAcceptRequest,
  PlanList,
  PlanRequest,
  PlanView,
  Points,
  ReceiptView,
  RecordingPage,
  RecordingView,
  RecoveryList,
  RecoveryPreview,
  RecoveryRequest,
  RecoveryView,
  RegistrationAnswer,
  RegistrationPolicy,
  RegistrationRequest,
  RenameRequest,
  ReplayView,
  Replays,
  RobotKeyRequest,
  RobotKeyView,
  RobotKeys,
  RunAnswerRequest,
  RunJoinRequest,
  RunJournalView,
  RunList,
  RunMoveRequest,
  RunReplayView,
  RunStartRequest,
  RunView,
  RunWaypointsRequest,
  SavedMissionView,
  SensedView,
  SeriesView,
  SessionView,
  SettingsView,
  StreamTicket,
  TourRequest,
  TourView,
  UserChange,
  UserView,
  Users,
  VirtualDroneList,
  VirtualDroneRequest,
  VirtualDroneStartRequest,
  VirtualDroneView,
  Waitings,
  WarehouseProspectsView,
  WarehouseView,
  ZoneCollection,
  ZoneFeature,
  ZoneImportView,
} from './schemas.js';

/** Each operation of REST, by its id. A refusal rejects with a `Problem`. */
export interface RestOperations {
  /** Accept a plan (planner; to start it operator): POST /api/v1/plans/{id}/accept */
  acceptPlan(parameters: { id: string; wait?: number | undefined }, body?: PlanAcceptRequest, options?: CallOptions): Promise<PlanView>;
  /** Add an endpoint (administrator): POST /api/v1/endpoints */
  addEndpoint(body: EndpointRequest, options?: CallOptions): Promise<EndpointView>;
  /** Make a fleet of drones: POST /api/v1/fleets */
  addFleet(body: FleetRequest, options?: CallOptions): Promise<FleetView>;
  /** Grant something: POST /api/v1/grants */
  addGrant(body: GrantRequest, options?: CallOptions): Promise<GrantView>;
  /** Make a group of users: POST /api/v1/groups */
  addGroup(body: GroupRequest, options?: CallOptions): Promise<GroupView>;
  /** Invite somebody: POST /api/v1/invitations */
  addInvitation(body: NewInvitation, options?: CallOptions): Promise<InvitationView>;
  /** Save a mission (operator): POST /api/v1/missions */
  addMission(body: MissionRequest, options?: CallOptions): Promise<SavedMissionView>;
  /** Make an organisation: POST /api/v1/organisations */
  addOrganisation(body: OrganisationNameRequest, options?: CallOptions): Promise<OrganisationView>;
  /** Add a zone to a mission run (operator): POST /api/v1/runs/{id}/barriers */
  addRunBarrier(parameters: { id: string }, body: ZoneFeature, options?: CallOptions): Promise<RunView>;
  /** Add waypoints to a mission run (operator): POST /api/v1/runs/{id}/waypoints */
  addRunWaypoints(parameters: { id: string }, body: RunWaypointsRequest, options?: CallOptions): Promise<RunView>;
  /** Add a user: POST /api/v1/users */
  addUser(body: NewUser, options?: CallOptions): Promise<UserView>;
  /** Make a virtual drone (planner): POST /api/v1/virtual-drones */
  addVirtualDrone(body: VirtualDroneRequest, options?: CallOptions): Promise<VirtualDroneView>;
  /** Add a zone (supervisor): POST /api/v1/zones */
  addZone(body: ZoneFeature, options?: CallOptions): Promise<ZoneFeature>;
  /** Write notes about a flight (operator): PATCH /api/v1/flights/{id} */
  annotateFlight(parameters: { id: string }, body: FlightNotes, options?: CallOptions): Promise<FlightView>;
  /** Answer a proposal of a mission run (operator): POST /api/v1/runs/{id}/answers/{proposal} */
  answerRun(parameters: { id: string; proposal: string }, body: RunAnswerRequest, options?: CallOptions): Promise<RunView>;
  /** Bring drones home, or down, together (operator): POST /api/v1/recoveries */
  beginRecovery(body: RecoveryRequest, options?: CallOptions): Promise<RecoveryView>;
  /** Give one command to several drones or all (operator): POST /api/v1/commands */
  broadcastCommand(parameters: { wait?: number | undefined }, body: BroadcastRequest, options?: CallOptions): Promise<BroadcastView>;
  /** Call a drone off that was sent (operator): POST /api/v1/dispatches/{id}/cancel */
  cancelDispatch(parameters: { id: string }, options?: CallOptions): Promise<DispatchView>;
  /** Cancel a follow (operator): POST /api/v1/follows/{id}/cancel */
  cancelFollow(parameters: { id: string }, options?: CallOptions): Promise<FollowView>;
  /** Call a recovery off (operator): POST /api/v1/recoveries/{id}/cancel */
  cancelRecovery(parameters: { id: string }, options?: CallOptions): Promise<RecoveryView>;
  /** Cancel a waypoint of a mission run (operator): DELETE /api/v1/runs/{id}/waypoints/{waypoint} */
  cancelRunWaypoint(parameters: { id: string; waypoint: string }, options?: CallOptions): Promise<RunView>;
  /** Change where the drone stays (operator): PATCH /api/v1/follows/{id} */
  changeFollow(parameters: { id: string }, body: FollowPlaceRequest, options?: CallOptions): Promise<FollowView>;
  /** Change one's own password: POST /api/v1/session/password */
  changePassword(body: PasswordRequest, options?: CallOptions): Promise<void>;
  /** Change a user's role, let a waiting one in, disable one: PATCH /api/v1/users/{name} */
  changeUser(parameters: { name: string }, body: UserChange, options?: CallOptions): Promise<UserView>;
  /** Take the fence away (operator): DELETE /api/v1/drones/{id}/fence */
  clearFence(parameters: { id: string }, options?: CallOptions): Promise<CommandView>;
  /** Take one's own signing passphrase away: DELETE /api/v1/outlet/passphrase */
  clearOutletPassphrase(options?: CallOptions): Promise<void>;
  /** Take the rally points away (operator): DELETE /api/v1/drones/{id}/rally-points */
  clearRallyPoints(parameters: { id: string }, options?: CallOptions): Promise<CommandView>;
  /** Close a personal port of one's own, or as an administrator anybody's: DELETE /api/v1/outlet/ports/{id} */
  closeOutletPort(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Let a follow go on (operator): POST /api/v1/follows/{id}/continue */
  continueFollow(parameters: { id: string }, options?: CallOptions): Promise<FollowView>;
  /** Let a paused mission run go on (operator): POST /api/v1/runs/{id}/continue */
  continueRun(parameters: { id: string }, options?: CallOptions): Promise<RunView>;
  /** Remove one of one's own access keys, with those made from it: DELETE /api/v1/access-keys/{id} */
  deleteAccessKey(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Revoke the DTLS key of a vehicle; its links end at once (administrator): DELETE /api/v1/dtls-keys/{identity} */
  deleteDtlsKey(parameters: { identity: string }, options?: CallOptions): Promise<void>;
  /** Remove a fleet, with all grants of it: DELETE /api/v1/fleets/{id} */
  deleteFleet(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Remove a group, with what was granted to it: DELETE /api/v1/groups/{id} */
  deleteGroup(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Take the key off the vehicle (administrator): DELETE /api/v1/drones/{id}/link-key */
  deleteLinkKey(parameters: { id: string; vehicle?: boolean | undefined }, options?: CallOptions): Promise<LinkSecurityView>;
  /** Remove the server's copy of a log (operator): DELETE /api/v1/drones/{id}/logs/{number}/file */
  deleteLogFile(parameters: { id: string; number: number }, options?: CallOptions): Promise<void>;
  /** Remove a saved mission (operator): DELETE /api/v1/missions/{id} */
  deleteMission(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Remove an organisation that has neither users nor drones: DELETE /api/v1/organisations/{id} */
  deleteOrganisation(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Delete a recording for ever (operator): DELETE /api/v1/recordings/{id} */
  deleteRecording(parameters: { id: string; confirm?: boolean | undefined }, options?: CallOptions): Promise<void>;
  /** Remove a user with sessions and keys: DELETE /api/v1/users/{name} */
  deleteUser(parameters: { name: string }, options?: CallOptions): Promise<void>;
  /** Remove an access key of a user, with those made from it: DELETE /api/v1/users/{name}/access-keys/{id} */
  deleteUserAccessKey(parameters: { name: string; id: string }, options?: CallOptions): Promise<void>;
  /** Remove a zone (supervisor): DELETE /api/v1/zones/{id} */
  deleteZone(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Disconnect what is attached (administrator): DELETE /api/v1/outlet/clients/{id} */
  disconnectOutletClient(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Take a vehicle off the list (administrator): DELETE /api/v1/waiting/{id} */
  dismissWaiting(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Fetch a log from the vehicle (operator): POST /api/v1/drones/{id}/logs/{number}/download */
  downloadLog(parameters: { id: string; number: number }, options?: CallOptions): Promise<CommandView>;
  /** Let a vehicle in as a drone (administrator): POST /api/v1/waiting/{id}/enrol */
  enrolWaiting(parameters: { id: string }, body?: EnrolRequest, options?: CallOptions): Promise<DroneView>;
  /** Take all that are looked for along as a file (supervisor): GET /api/v1/audit/file */
  exportAudit(parameters?: { user?: string | null | undefined; drone?: string | null | undefined; operation?: string | null | undefined; face?: string | null | undefined; outcome?: string | null | undefined; from?: string | null | undefined; until?: string | null | undefined; form?: string | undefined }, options?: CallOptions): Promise<Response>;
  /** Take telemetry along as a file: GET /api/v1/drones/{id}/telemetry/file */
  exportDroneTelemetry(parameters: { id: string; from?: string | null | undefined; until?: string | null | undefined; fields?: string | null | undefined; slots?: string | null | undefined; most?: string | null | undefined; form?: string | undefined }, options?: CallOptions): Promise<Response>;
  /** Take a flight along as a file: GET /api/v1/flights/{id}/telemetry/file */
  exportFlightTelemetry(parameters: { id: string; from?: string | null | undefined; until?: string | null | undefined; fields?: string | null | undefined; slots?: string | null | undefined; most?: string | null | undefined; form?: string | undefined }, options?: CallOptions): Promise<Response>;
  /** Take all flights that are looked for along as a table (CSV): GET /api/v1/flights/logbook */
  exportLogbook(parameters?: { drone?: string | null | undefined; user?: string | null | undefined; from?: string | null | undefined; until?: string | null | undefined; words?: string | null | undefined }, options?: CallOptions): Promise<string>;
  /** Save the parameters as a file: GET /api/v1/drones/{id}/parameters/file */
  exportParameters(parameters: { id: string; form?: string | undefined }, options?: CallOptions): Promise<string>;
  /** Come back from the provider: GET /api/v1/session/oidc/callback */
  finishSignInElsewhere(parameters?: { code?: string | undefined; state?: string | undefined }, options?: CallOptions): Promise<Response>;
  /** Follow what happens to drones: GET /api/v1/events */
  followEvents(parameters?: { after?: string | null | undefined; limit?: number | null | undefined; drones?: string | null | undefined; wait?: number | undefined }, options?: CallOptions): Promise<FollowedEvents>;
  /** Get a receipt for all records up to now (supervisor): GET /api/v1/audit/receipt */
  getAuditReceipt(options?: CallOptions): Promise<ReceiptView>;
  /** Look at one command: GET /api/v1/commands/{id} */
  getCommand(parameters: { id: string }, options?: CallOptions): Promise<CommandView>;
  /** See who has control: GET /api/v1/drones/{id}/control */
  getControl(parameters: { id: string }, options?: CallOptions): Promise<ControlView>;
  /** Look at one drone that was sent: GET /api/v1/dispatches/{id} */
  getDispatch(parameters: { id: string }, options?: CallOptions): Promise<DispatchView>;
  /** Look at one drone: GET /api/v1/drones/{id} */
  getDrone(parameters: { id: string }, options?: CallOptions): Promise<DroneView>;
  /** Look at numbers over time: GET /api/v1/drones/{id}/telemetry */
  getDroneTelemetry(parameters: { id: string; from?: string | null | undefined; until?: string | null | undefined; fields?: string | null | undefined; slots?: string | null | undefined; most?: string | null | undefined }, options?: CallOptions): Promise<SeriesView>;
  /** Look at one endpoint (administrator): GET /api/v1/endpoints/{id} */
  getEndpoint(parameters: { id: string }, options?: CallOptions): Promise<EndpointView>;
  /** Look at the fence: GET /api/v1/drones/{id}/fence */
  getFence(parameters: { id: string }, options?: CallOptions): Promise<FenceView>;
  /** Look at one flight: GET /api/v1/flights/{id} */
  getFlight(parameters: { id: string }, options?: CallOptions): Promise<FlightView>;
  /** Look at numbers over a flight: GET /api/v1/flights/{id}/telemetry */
  getFlightTelemetry(parameters: { id: string; from?: string | null | undefined; until?: string | null | undefined; fields?: string | null | undefined; slots?: string | null | undefined; most?: string | null | undefined }, options?: CallOptions): Promise<SeriesView>;
  /** Look at one follow: GET /api/v1/follows/{id} */
  getFollow(parameters: { id: string }, options?: CallOptions): Promise<FollowView>;
  /** Is the server well? (no sign-in): GET /api/v1/health */
  getHealth(options?: CallOptions): Promise<HealthView>;
  /** How each part of the server is, and why it ended last (administrator): GET /api/v1/health/parts */
  getHealthParts(options?: CallOptions): Promise<HealthDetails>;
  /** Is all that drones do written down? (administrator): GET /api/v1/history */
  getHistory(options?: CallOptions): Promise<HistoryView>;
  /** Look at how a drone's link is secured, and what was refused: GET /api/v1/drones/{id}/link-security */
  getLinkSecurity(parameters: { id: string }, options?: CallOptions): Promise<LinkSecurityView>;
  /** Save a log that was fetched: GET /api/v1/drones/{id}/logs/{number}/file */
  getLogFile(parameters: { id: string; number: number }, options?: CallOptions): Promise<Response>;
  /** Look at one saved mission: GET /api/v1/missions/{id} */
  getMission(parameters: { id: string }, options?: CallOptions): Promise<SavedMissionView>;
  /** Where to attach, whether a passphrase is set, and one's own programs that are attached: GET /api/v1/outlet */
  getOutlet(options?: CallOptions): Promise<OwnOutletView>;
  /** Look at one plan: GET /api/v1/plans/{id} */
  getPlan(parameters: { id: string }, options?: CallOptions): Promise<PlanView>;
  /** What would follow if a drone were put into the warehouse (operator): GET /api/v1/warehouse/{id}/prospects */
  getProspects(parameters: { id: string }, options?: CallOptions): Promise<WarehouseProspectsView>;
  /** Look at the rally points: GET /api/v1/drones/{id}/rally-points */
  getRallyPoints(parameters: { id: string }, options?: CallOptions): Promise<FenceRallyView>;
  /** Look at one recording: GET /api/v1/recordings/{id} */
  getRecording(parameters: { id: string }, options?: CallOptions): Promise<RecordingView>;
  /** Download a recording: GET /api/v1/recordings/{id}/file */
  getRecordingFile(parameters: { id: string }, options?: CallOptions): Promise<Response>;
  /** Download who sent what in a recording (tab-separated): GET /api/v1/recordings/{id}/sent */
  getRecordingSent(parameters: { id: string }, options?: CallOptions): Promise<string>;
  /** Look at one recovery: GET /api/v1/recoveries/{id} */
  getRecovery(parameters: { id: string }, options?: CallOptions): Promise<RecoveryView>;
  /** How accounts are made here: GET /api/v1/registrations */
  getRegistrationPolicy(options?: CallOptions): Promise<RegistrationPolicy>;
  /** Look at one replay: GET /api/v1/replays/{id} */
  getReplay(parameters: { id: string }, options?: CallOptions): Promise<ReplayView>;
  /** Look at one mission run: GET /api/v1/runs/{id} */
  getRun(parameters: { id: string }, options?: CallOptions): Promise<RunView>;
  /** Read the journal of a mission run (operator): GET /api/v1/runs/{id}/journal */
  getRunJournal(parameters: { id: string; from?: number | undefined }, options?: CallOptions): Promise<RunJournalView>;
  /** Look at what its sensors brought last: GET /api/v1/drones/{id}/sensed */
  getSensed(parameters: { id: string }, options?: CallOptions): Promise<SensedView>;
  /** Its map, drawn from above: GET /api/v1/drones/{id}/sensed/map */
  getSensedMap(parameters: { id: string }, options?: CallOptions): Promise<Response>;
  /** The newest picture of its camera: GET /api/v1/drones/{id}/sensed/picture */
  getSensedPicture(parameters: { id: string }, options?: CallOptions): Promise<Response>;
  /** Who is signed in: GET /api/v1/session */
  getSession(options?: CallOptions): Promise<SessionView>;
  /** What a client has to know of the server: GET /api/v1/settings */
  getSettings(options?: CallOptions): Promise<SettingsView>;
  /** What went over the link of each vehicle (administrator): GET /api/v1/traffic */
  getTraffic(options?: CallOptions): Promise<LinkTraffic>;
  /** Look at one virtual drone: GET /api/v1/virtual-drones/{id} */
  getVirtualDrone(parameters: { id: string }, options?: CallOptions): Promise<VirtualDroneView>;
  /** Look at one zone: GET /api/v1/zones/{id} */
  getZone(parameters: { id: string }, options?: CallOptions): Promise<ZoneFeature>;
  /** Give a command (operator): POST /api/v1/drones/{id}/commands */
  giveCommand(parameters: { id: string; wait?: number | undefined }, body: CommandRequest, options?: CallOptions): Promise<CommandView>;
  /** Give a drone of your own organisation to another one: PUT /api/v1/organisations/{id}/drones/{drone} */
  giveDrone(parameters: { id: string; drone: string }, body?: GiftRequest, options?: CallOptions): Promise<GiftView>;
  /** Take a drone out of a mission run (operator): POST /api/v1/runs/{id}/drones/{drone}/give-up */
  giveUpRunDrone(parameters: { id: string; drone: string }, options?: CallOptions): Promise<RunView>;
  /** Give control to somebody who asks for it (holder): POST /api/v1/drones/{id}/control/grant */
  grantControl(parameters: { id: string }, body: ControlGrantRequest, options?: CallOptions): Promise<ControlView>;
  /** Give control to somebody (holder): POST /api/v1/drones/{id}/control/hand-over */
  handOverControl(parameters: { id: string }, body: ControlHandOverRequest, options?: CallOptions): Promise<ControlView>;
  /** Compare with a file, or load it (operator): POST /api/v1/drones/{id}/parameters/file */
  importParameters(parameters: { id: string; dryRun?: boolean | undefined }, body: FileBody, options?: CallOptions): Promise<ParametersFileView>;
  /** Add the zones of a GeoJSON, KML or KMZ file (supervisor): POST /api/v1/zones/import */
  importZones(body: FileBody, options?: CallOptions): Promise<ZoneImportView>;
  /** Give the vehicle its key and hear that it signs (administrator): POST /api/v1/drones/{id}/link-key/install */
  installLinkKey(parameters: { id: string }, body?: LinkSecurityChangeRequest, options?: CallOptions): Promise<LinkSecurityView>;
  /** Issue the key of a robot (administrator): POST /api/v1/robot-keys */
  issueRobotKey(body: RobotKeyRequest, options?: CallOptions): Promise<RobotKeyView>;
  /** Have a further drone join a mission run (operator): POST /api/v1/runs/{id}/drones */
  joinRun(parameters: { id: string }, body: RunJoinRequest, options?: CallOptions): Promise<RunView>;
  /** Say that the holder is there (holder): POST /api/v1/drones/{id}/control/heartbeat */
  keepControl(parameters: { id: string }, body: ControlHeartbeatRequest, options?: CallOptions): Promise<ControlView>;
  /** List one's own access keys: GET /api/v1/access-keys */
  listAccessKeys(options?: CallOptions): Promise<AccessKeys>;
  /** List a drone's last commands: GET /api/v1/drones/{id}/commands */
  listCommands(parameters: { id: string }, options?: CallOptions): Promise<Commands>;
  /** List drones that were sent: GET /api/v1/dispatches */
  listDispatches(options?: CallOptions): Promise<DispatchList>;
  /** Look at what happened to a drone: GET /api/v1/drones/{id}/events */
  listDroneEvents(parameters: { id: string; from?: string | null | undefined; until?: string | null | undefined; fields?: string | null | undefined; slots?: string | null | undefined; most?: string | null | undefined }, options?: CallOptions): Promise<Events>;
  /** Look at states over time: GET /api/v1/drones/{id}/telemetry/points */
  listDroneTelemetryPoints(parameters: { id: string; from?: string | null | undefined; until?: string | null | undefined; fields?: string | null | undefined; slots?: string | null | undefined; most?: string | null | undefined }, options?: CallOptions): Promise<Points>;
  /** List the drones: GET /api/v1/drones */
  listDrones(parameters?: { active?: boolean | undefined }, options?: CallOptions): Promise<Drones>;
  /** List the DTLS keys of vehicles (administrator): GET /api/v1/dtls-keys */
  listDtlsKeys(options?: CallOptions): Promise<DtlsKeys>;
  /** List the endpoints with their state and counters (administrator): GET /api/v1/endpoints */
  listEndpoints(options?: CallOptions): Promise<Endpoints>;
  /** List the fleets: GET /api/v1/fleets */
  listFleets(options?: CallOptions): Promise<Fleets>;
  /** Look at what happened in a flight: GET /api/v1/flights/{id}/events */
  listFlightEvents(parameters: { id: string; from?: string | null | undefined; until?: string | null | undefined; fields?: string | null | undefined; slots?: string | null | undefined; most?: string | null | undefined }, options?: CallOptions): Promise<Events>;
  /** Look at the states of a flight: GET /api/v1/flights/{id}/telemetry/points */
  listFlightTelemetryPoints(parameters: { id: string; from?: string | null | undefined; until?: string | null | undefined; fields?: string | null | undefined; slots?: string | null | undefined; most?: string | null | undefined }, options?: CallOptions): Promise<Points>;
  /** Look for flights: GET /api/v1/flights */
  listFlights(parameters?: { drone?: string | null | undefined; user?: string | null | undefined; from?: string | null | undefined; until?: string | null | undefined; words?: string | null | undefined; before?: string | undefined; limit?: number | undefined }, options?: CallOptions): Promise<Flights>;
  /** List follows: GET /api/v1/follows */
  listFollows(options?: CallOptions): Promise<FollowList>;
  /** List the drones that were given to an organisation and that it still has: GET /api/v1/organisations/{id}/drones */
  listGivenDrones(parameters: { id: string }, options?: CallOptions): Promise<Gifts>;
  /** List the grants: GET /api/v1/grants */
  listGrants(options?: CallOptions): Promise<Grants>;
  /** List the groups of users: GET /api/v1/groups */
  listGroups(options?: CallOptions): Promise<Groups>;
  /** List the open invitations: GET /api/v1/invitations */
  listInvitations(options?: CallOptions): Promise<Invitations>;
  /** List removed drones with what their owners had set (administrator): GET /api/v1/left-behind */
  listLeftBehind(options?: CallOptions): Promise<LeftBehind>;
  /** List the logs on board: GET /api/v1/drones/{id}/logs */
  listLogs(parameters: { id: string }, options?: CallOptions): Promise<LogsView>;
  /** List the saved missions: GET /api/v1/missions */
  listMissions(options?: CallOptions): Promise<Missions>;
  /** List the organisations: GET /api/v1/organisations */
  listOrganisations(options?: CallOptions): Promise<Organisations>;
  /** List all that is attached, and what was refused (administrator): GET /api/v1/outlet/clients */
  listOutletClients(options?: CallOptions): Promise<OutletView>;
  /** List or search the parameters: GET /api/v1/drones/{id}/parameters */
  listParameters(parameters: { id: string; search?: string | undefined }, options?: CallOptions): Promise<ParametersView>;
  /** List your plans: GET /api/v1/plans */
  listPlans(options?: CallOptions): Promise<PlanList>;
  /** List the recordings, newest first, and the room that they take: GET /api/v1/recordings */
  listRecordings(parameters?: { drone?: string | undefined }, options?: CallOptions): Promise<RecordingPage>;
  /** List recoveries: GET /api/v1/recoveries */
  listRecoveries(options?: CallOptions): Promise<RecoveryList>;
  /** List the replays: GET /api/v1/replays */
  listReplays(options?: CallOptions): Promise<Replays>;
  /** List the keys of robots (administrator): GET /api/v1/robot-keys */
  listRobotKeys(options?: CallOptions): Promise<RobotKeys>;
  /** List mission runs: GET /api/v1/runs */
  listRuns(options?: CallOptions): Promise<RunList>;
  /** List a user's access keys: GET /api/v1/users/{name}/access-keys */
  listUserAccessKeys(parameters: { name: string }, options?: CallOptions): Promise<AccessKeys>;
  /** List the users: GET /api/v1/users */
  listUsers(options?: CallOptions): Promise<Users>;
  /** List your virtual drones: GET /api/v1/virtual-drones */
  listVirtualDrones(options?: CallOptions): Promise<VirtualDroneList>;
  /** List the vehicles that wait (administrator): GET /api/v1/waiting */
  listWaiting(options?: CallOptions): Promise<Waitings>;
  /** List the drones of the warehouse: GET /api/v1/warehouse */
  listWarehouse(options?: CallOptions): Promise<WarehouseView>;
  /** List the zones: GET /api/v1/zones */
  listZones(options?: CallOptions): Promise<ZoneCollection>;
  /** Make an access key: POST /api/v1/access-keys */
  makeAccessKey(body: KeyRequest, options?: CallOptions): Promise<KeyView>;
  /** Make a backup (administrator): POST /api/v1/backup */
  makeBackup(options?: CallOptions): Promise<Response>;
  /** Make the DTLS key of a vehicle (administrator): POST /api/v1/dtls-keys */
  makeDtlsKey(body: DtlsKeyRequest, options?: CallOptions): Promise<DtlsKeyView>;
  /** Make a key, or bring one along (administrator): POST /api/v1/drones/{id}/link-key */
  makeLinkKey(parameters: { id: string }, body: LinkKeyRequest, options?: CallOptions): Promise<MadeLinkKey>;
  /** Ask for a plan (planner): POST /api/v1/plans */
  makePlan(body: PlanRequest, options?: CallOptions): Promise<PlanView>;
  /** Get a ticket for the stream: POST /api/v1/stream-tickets */
  makeStreamTicket(options?: CallOptions): Promise<StreamTicket>;
  /** Move a waypoint of a mission run (operator): PATCH /api/v1/runs/{id}/waypoints/{waypoint} */
  moveRunWaypoint(parameters: { id: string; waypoint: string }, body: RunMoveRequest, options?: CallOptions): Promise<RunView>;
  /** Ask to be followed (operator): POST /api/v1/follows */
  openFollow(body: FollowOpenRequest, options?: CallOptions): Promise<FollowView>;
  /** Open a personal port, view-only, for a program that cannot sign: POST /api/v1/outlet/ports */
  openOutletPort(body: OutletPortRequest, options?: CallOptions): Promise<OutletPortView>;
  /** Put the waypoints of one drone into a good order (planner): POST /api/v1/tours */
  orderTour(body: TourRequest, options?: CallOptions): Promise<TourView>;
  /** Pause a follow (operator): POST /api/v1/follows/{id}/pause */
  pauseFollow(parameters: { id: string }, options?: CallOptions): Promise<FollowView>;
  /** Pause a mission run (operator): POST /api/v1/runs/{id}/pause */
  pauseRun(parameters: { id: string }, options?: CallOptions): Promise<RunView>;
  /** Preview a recovery (operator): POST /api/v1/recoveries/preview */
  previewRecovery(body: RecoveryRequest, options?: CallOptions): Promise<RecoveryPreview>;
  /** Let a drone serve virtual ones (supervisor): PUT /api/v1/warehouse/{id} */
  putIntoWarehouse(parameters: { id: string }, options?: CallOptions): Promise<WarehouseView>;
  /** Read the fence from the vehicle (operator): POST /api/v1/drones/{id}/fence/refresh */
  readFence(parameters: { id: string }, options?: CallOptions): Promise<CommandView>;
  /** Ask the vehicle for the list of its logs (operator): POST /api/v1/drones/{id}/logs/refresh */
  readLogs(parameters: { id: string }, options?: CallOptions): Promise<CommandView>;
  /** Read all parameters from the vehicle (operator): POST /api/v1/drones/{id}/parameters/refresh */
  readParameters(parameters: { id: string; wait?: number | undefined }, options?: CallOptions): Promise<CommandView>;
  /** Read the rally points from the vehicle (operator): POST /api/v1/drones/{id}/rally-points/refresh */
  readRallyPoints(parameters: { id: string }, options?: CallOptions): Promise<CommandView>;
  /** Keep control from somebody who asks for it (holder): POST /api/v1/drones/{id}/control/refuse */
  refuseControl(parameters: { id: string }, body: ControlRefuseRequest, options?: CallOptions): Promise<ControlView>;
  /** Ask for an account: POST /api/v1/registrations */
  register(body: RegistrationRequest, options?: CallOptions): Promise<RegistrationAnswer>;
  /** Give control back (holder): DELETE /api/v1/drones/{id}/control */
  releaseControl(parameters: { id: string }, options?: CallOptions): Promise<ControlView>;
  /** Forget a lost drone (administrator): DELETE /api/v1/drones/{id} */
  removeDrone(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Remove an endpoint that was added (administrator): DELETE /api/v1/endpoints/{id} */
  removeEndpoint(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Cancel or forget a plan (planner): DELETE /api/v1/plans/{id} */
  removePlan(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** End a replay and remove its drones (operator): DELETE /api/v1/replays/{id} */
  removeReplay(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Remove a virtual drone (planner): DELETE /api/v1/virtual-drones/{id} */
  removeVirtualDrone(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Give a drone another name (operator): PATCH /api/v1/drones/{id} */
  renameDrone(parameters: { id: string }, body: RenameRequest, options?: CallOptions): Promise<DroneView>;
  /** Rename an organisation: PATCH /api/v1/organisations/{id} */
  renameOrganisation(parameters: { id: string }, body: OrganisationNameRequest, options?: CallOptions): Promise<OrganisationView>;
  /** Renew an access key: POST /api/v1/access-keys/{id}/renew */
  renewAccessKey(parameters: { id: string }, options?: CallOptions): Promise<KeyView>;
  /** Change the name and the drones of a fleet: PUT /api/v1/fleets/{id} */
  replaceFleet(parameters: { id: string }, body: FleetRequest, options?: CallOptions): Promise<FleetView>;
  /** Change the name and the members of a group: PUT /api/v1/groups/{id} */
  replaceGroup(parameters: { id: string }, body: GroupRequest, options?: CallOptions): Promise<GroupView>;
  /** Replace a saved mission (operator): PUT /api/v1/missions/{id} */
  replaceMission(parameters: { id: string }, body: MissionRequest, options?: CallOptions): Promise<SavedMissionView>;
  /** Name it, say what it needs, plan its mission (planner): PUT /api/v1/virtual-drones/{id} */
  replaceVirtualDrone(parameters: { id: string }, body: VirtualDroneRequest, options?: CallOptions): Promise<VirtualDroneView>;
  /** Replace a zone (supervisor): PUT /api/v1/zones/{id} */
  replaceZone(parameters: { id: string }, body: ZoneFeature, options?: CallOptions): Promise<ZoneFeature>;
  /** Play a recording on the map (operator): POST /api/v1/recordings/{id}/replays */
  replayRecording(parameters: { id: string; speed?: number | undefined }, options?: CallOptions): Promise<ReplayView>;
  /** Replay the journal of a mission run (operator): GET /api/v1/runs/{id}/journal/replay */
  replayRunJournal(parameters: { id: string }, options?: CallOptions): Promise<RunReplayView>;
  /** Say where the phone is (operator): POST /api/v1/follows/{id}/positions */
  reportFollowPositions(parameters: { id: string }, body: FollowPositionsRequest, options?: CallOptions): Promise<FollowReceipt>;
  /** Ask the holder for control (operator): POST /api/v1/drones/{id}/control/request */
  requestControl(parameters: { id: string }, body?: ControlAskRequest, options?: CallOptions): Promise<ControlView>;
  /** Give a user a one-time password: POST /api/v1/users/{name}/password */
  resetPassword(parameters: { name: string }, options?: CallOptions): Promise<OneTimePassword>;
  /** Give a drone back to its mission run (operator): POST /api/v1/runs/{id}/drones/{drone}/resume */
  resumeRunDrone(parameters: { id: string; drone: string }, options?: CallOptions): Promise<RunView>;
  /** Go on with what is not flown yet (operator): POST /api/v1/virtual-drones/{id}/resume */
  resumeVirtualDrone(parameters: { id: string }, options?: CallOptions): Promise<VirtualDroneView>;
  /** Take a grant back: DELETE /api/v1/grants/{id} */
  revokeGrant(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Revoke the key of a robot (administrator): DELETE /api/v1/robot-keys/{id} */
  revokeRobotKey(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Change the vehicle over to a new key (administrator): POST /api/v1/drones/{id}/link-key/rotate */
  rotateLinkKey(parameters: { id: string }, body?: LinkSecurityChangeRequest, options?: CallOptions): Promise<LinkSecurityView>;
  /** Look for records (supervisor): GET /api/v1/audit */
  searchAudit(parameters?: { user?: string | null | undefined; drone?: string | null | undefined; operation?: string | null | undefined; face?: string | null | undefined; outcome?: string | null | undefined; from?: string | null | undefined; until?: string | null | undefined; before?: number | undefined; limit?: number | undefined }, options?: CallOptions): Promise<AuditPage>;
  /** Send a drone here (operator): POST /api/v1/dispatches */
  sendDrone(body: DispatchRequest, options?: CallOptions): Promise<DispatchView>;
  /** Replace the fence (operator): PUT /api/v1/drones/{id}/fence */
  setFence(parameters: { id: string }, body: FenceView, options?: CallOptions): Promise<CommandView>;
  /** Make the cloud's zones the vehicle's own fence (planner): PUT /api/v1/drones/{id}/fence/zones */
  setFenceFromZones(parameters: { id: string }, options?: CallOptions): Promise<CommandView>;
  /** Let the members of a group see only what was granted, or all drones by their role: PUT /api/v1/groups/{id}/only-granted */
  setGroupOnlyGranted(parameters: { id: string }, body: OnlyGrantedRequest, options?: CallOptions): Promise<void>;
  /** Set the policy: off, optional or required (administrator): PUT /api/v1/drones/{id}/link-security */
  setLinkSecurity(parameters: { id: string }, body: LinkSecurityPolicyRequest, options?: CallOptions): Promise<LinkSecurityView>;
  /** Set one's own signing passphrase: PUT /api/v1/outlet/passphrase */
  setOutletPassphrase(body: PassphraseRequest, options?: CallOptions): Promise<PassphraseView>;
  /** Change a parameter (operator): PUT /api/v1/drones/{id}/parameters/{name} */
  setParameter(parameters: { id: string; name: string; wait?: number | undefined }, body: ParameterValueRequest, options?: CallOptions): Promise<CommandView>;
  /** Replace the rally points (operator): PUT /api/v1/drones/{id}/rally-points */
  setRallyPoints(parameters: { id: string }, body: FenceRallyView, options?: CallOptions): Promise<CommandView>;
  /** Let a user see only what was granted, or all drones by the role: PUT /api/v1/users/{name}/only-granted */
  setUserOnlyGranted(parameters: { name: string }, body: OnlyGrantedRequest, options?: CallOptions): Promise<void>;
  /** Sign in: POST /api/v1/session */
  signIn(body: Credentials, options?: CallOptions): Promise<SessionView>;
  /** Sign out: DELETE /api/v1/session */
  signOut(options?: CallOptions): Promise<void>;
  /** Sign out everywhere: POST /api/v1/session/sign-out-everywhere */
  signOutEverywhere(options?: CallOptions): Promise<void>;
  /** End all sessions of a user: POST /api/v1/users/{name}/sign-out */
  signOutUser(parameters: { name: string }, options?: CallOptions): Promise<void>;
  /** Start following (operator): POST /api/v1/follows/{id}/start */
  startFollow(parameters: { id: string }, options?: CallOptions): Promise<FollowView>;
  /** Play a recording (operator): POST /api/v1/replays */
  startReplay(parameters: { speed?: number | undefined; name?: string | undefined }, body: FileBody, options?: CallOptions): Promise<ReplayView>;
  /** Fly a plan (operator): POST /api/v1/runs */
  startRun(body: RunStartRequest, options?: CallOptions): Promise<RunView>;
  /** Go to the provider to sign in: GET /api/v1/session/oidc */
  startSignInElsewhere(options?: CallOptions): Promise<Response>;
  /** Have its mission flown (operator): POST /api/v1/virtual-drones/{id}/start */
  startVirtualDrone(parameters: { id: string }, body?: VirtualDroneStartRequest, options?: CallOptions): Promise<VirtualDroneView>;
  /** Stop a follow (operator): POST /api/v1/follows/{id}/stop */
  stopFollow(parameters: { id: string }, options?: CallOptions): Promise<FollowView>;
  /** Stop the start of a plan (operator): POST /api/v1/plans/{id}/stop */
  stopPlan(parameters: { id: string }, options?: CallOptions): Promise<PlanView>;
  /** Stop a mission run (operator): POST /api/v1/runs/{id}/stop */
  stopRun(parameters: { id: string }, options?: CallOptions): Promise<RunView>;
  /** Stop its mission (operator; supervisors any): POST /api/v1/virtual-drones/{id}/stop */
  stopVirtualDrone(parameters: { id: string }, options?: CallOptions): Promise<VirtualDroneView>;
  /** Take a drone back that was given to an organisation: DELETE /api/v1/organisations/{id}/drones/{drone} */
  takeBackDrone(parameters: { id: string; drone: string }, options?: CallOptions): Promise<GiftView>;
  /** Take control where nobody has it (operator): POST /api/v1/drones/{id}/control/take */
  takeControl(parameters: { id: string }, options?: CallOptions): Promise<ControlView>;
  /** Let a drone serve virtual ones no more (supervisor): DELETE /api/v1/warehouse/{id} */
  takeFromWarehouse(parameters: { id: string }, options?: CallOptions): Promise<void>;
  /** Take control from whoever has it, with a reason (supervisor): POST /api/v1/drones/{id}/control/take-over */
  takeOverControl(parameters: { id: string }, body: ControlTakeOverRequest, options?: CallOptions): Promise<ControlView>;
  /** Verify all records, against a receipt too if one is sent (administrator): POST /api/v1/audit/verification */
  verifyAudit(body?: ReceiptView, options?: CallOptions): Promise<AuditVerdictView>;
  /** Withdraw an invitation: DELETE /api/v1/invitations/{id} */
  withdrawInvitation(parameters: { id: string }, options?: CallOptions): Promise<void>;
}

/** How each operation is called. */
export const OPERATIONS = {
  acceptPlan: { method: 'POST', path: '/api/v1/plans/{id}/accept', query: ['wait'], body: ['application/json'], answer: 'json' },
  addEndpoint: { method: 'POST', path: '/api/v1/endpoints', body: ['application/json'], answer: 'json' },
  addFleet: { method: 'POST', path: '/api/v1/fleets', body: ['application/json'], answer: 'json' },
  addGrant: { method: 'POST', path: '/api/v1/grants', body: ['application/json'], answer: 'json' },
  addGroup: { method: 'POST', path: '/api/v1/groups', body: ['application/json'], answer: 'json' },
  addInvitation: { method: 'POST', path: '/api/v1/invitations', body: ['application/json'], answer: 'json' },
  addMission: { method: 'POST', path: '/api/v1/missions', body: ['application/json'], answer: 'json' },
  addOrganisation: { method: 'POST', path: '/api/v1/organisations', body: ['application/json'], answer: 'json' },
  addRunBarrier: { method: 'POST', path: '/api/v1/runs/{id}/barriers', body: ['application/json'], answer: 'json' },
  addRunWaypoints: { method: 'POST', path: '/api/v1/runs/{id}/waypoints', body: ['application/json'], answer: 'json' },
  addUser: { method: 'POST', path: '/api/v1/users', body: ['application/json'], answer: 'json' },
  addVirtualDrone: { method: 'POST', path: '/api/v1/virtual-drones', body: ['application/json'], answer: 'json' },
  addZone: { method: 'POST', path: '/api/v1/zones', body: ['application/json'], answer: 'json' },
  annotateFlight: { method: 'PATCH', path: '/api/v1/flights/{id}', body: ['application/json'], answer: 'json' },
  answerRun: { method: 'POST', path: '/api/v1/runs/{id}/answers/{proposal}', body: ['application/json'], answer: 'json' },
  beginRecovery: { method: 'POST', path: '/api/v1/recoveries', body: ['application/json'], answer: 'json' },
  broadcastCommand: { method: 'POST', path: '/api/v1/commands', query: ['wait'], body: ['application/json'], answer: 'json' },
  cancelDispatch: { method: 'POST', path: '/api/v1/dispatches/{id}/cancel', answer: 'json' },
  cancelFollow: { method: 'POST', path: '/api/v1/follows/{id}/cancel', answer: 'json' },
  cancelRecovery: { method: 'POST', path: '/api/v1/recoveries/{id}/cancel', answer: 'json' },
  cancelRunWaypoint: { method: 'DELETE', path: '/api/v1/runs/{id}/waypoints/{waypoint}', answer: 'json' },
  changeFollow: { method: 'PATCH', path: '/api/v1/follows/{id}', body: ['application/json'], answer: 'json' },
  changePassword: { method: 'POST', path: '/api/v1/session/password', body: ['application/json'], answer: 'nothing' },
  changeUser: { method: 'PATCH', path: '/api/v1/users/{name}', body: ['application/json'], answer: 'json' },
  clearFence: { method: 'DELETE', path: '/api/v1/drones/{id}/fence', answer: 'json' },
  clearOutletPassphrase: { method: 'DELETE', path: '/api/v1/outlet/passphrase', answer: 'nothing' },
  clearRallyPoints: { method: 'DELETE', path: '/api/v1/drones/{id}/rally-points', answer: 'json' },
  closeOutletPort: { method: 'DELETE', path: '/api/v1/outlet/ports/{id}', answer: 'nothing' },
  continueFollow: { method: 'POST', path: '/api/v1/follows/{id}/continue', answer: 'json' },
  continueRun: { method: 'POST', path: '/api/v1/runs/{id}/continue', answer: 'json' },
  deleteAccessKey: { method: 'DELETE', path: '/api/v1/access-keys/{id}', answer: 'nothing' },
  deleteDtlsKey: { method: 'DELETE', path: '/api/v1/dtls-keys/{identity}', answer: 'nothing' },
  deleteFleet: { method: 'DELETE', path: '/api/v1/fleets/{id}', answer: 'nothing' },
  deleteGroup: { method: 'DELETE', path: '/api/v1/groups/{id}', answer: 'nothing' },
  deleteLinkKey: { method: 'DELETE', path: '/api/v1/drones/{id}/link-key', query: ['vehicle'], answer: 'json' },
  deleteLogFile: { method: 'DELETE', path: '/api/v1/drones/{id}/logs/{number}/file', answer: 'nothing' },
  deleteMission: { method: 'DELETE', path: '/api/v1/missions/{id}', answer: 'nothing' },
  deleteOrganisation: { method: 'DELETE', path: '/api/v1/organisations/{id}', answer: 'nothing' },
  deleteRecording: { method: 'DELETE', path: '/api/v1/recordings/{id}', query: ['confirm'], answer: 'nothing' },
  deleteUser: { method: 'DELETE', path: '/api/v1/users/{name}', answer: 'nothing' },
  deleteUserAccessKey: { method: 'DELETE', path: '/api/v1/users/{name}/access-keys/{id}', answer: 'nothing' },
  deleteZone: { method: 'DELETE', path: '/api/v1/zones/{id}', answer: 'nothing' },
  disconnectOutletClient: { method: 'DELETE', path: '/api/v1/outlet/clients/{id}', answer: 'nothing' },
  dismissWaiting: { method: 'DELETE', path: '/api/v1/waiting/{id}', answer: 'nothing' },
  downloadLog: { method: 'POST', path: '/api/v1/drones/{id}/logs/{number}/download', answer: 'json' },
  enrolWaiting: { method: 'POST', path: '/api/v1/waiting/{id}/enrol', body: ['application/json'], answer: 'json' },
  exportAudit: { method: 'GET', path: '/api/v1/audit/file', query: ['user', 'drone', 'operation', 'face', 'outcome', 'from', 'until', 'form'], answer: 'file' },
  exportDroneTelemetry: { method: 'GET', path: '/api/v1/drones/{id}/telemetry/file', query: ['from', 'until', 'fields', 'slots', 'most', 'form'], answer: 'file' },
  exportFlightTelemetry: { method: 'GET', path: '/api/v1/flights/{id}/telemetry/file', query: ['from', 'until', 'fields', 'slots', 'most', 'form'], answer: 'file' },
  exportLogbook: { method: 'GET', path: '/api/v1/flights/logbook', query: ['drone', 'user', 'from', 'until', 'words'], answer: 'text' },
  exportParameters: { method: 'GET', path: '/api/v1/drones/{id}/parameters/file', query: ['form'], answer: 'text' },
  finishSignInElsewhere: { method: 'GET', path: '/api/v1/session/oidc/callback', query: ['code', 'state'], answer: 'redirect' },
  followEvents: { method: 'GET', path: '/api/v1/events', query: ['after', 'limit', 'drones', 'wait'], answer: 'json' },
  getAuditReceipt: { method: 'GET', path: '/api/v1/audit/receipt', answer: 'json' },
  getCommand: { method: 'GET', path: '/api/v1/commands/{id}', answer: 'json' },
  getControl: { method: 'GET', path: '/api/v1/drones/{id}/control', answer: 'json' },
  getDispatch: { method: 'GET', path: '/api/v1/dispatches/{id}', answer: 'json' },
  getDrone: { method: 'GET', path: '/api/v1/drones/{id}', answer: 'json' },
  getDroneTelemetry: { method: 'GET', path: '/api/v1/drones/{id}/telemetry', query: ['from', 'until', 'fields', 'slots', 'most'], answer: 'json' },
  getEndpoint: { method: 'GET', path: '/api/v1/endpoints/{id}', answer: 'json' },
  getFence: { method: 'GET', path: '/api/v1/drones/{id}/fence', answer: 'json' },
  getFlight: { method: 'GET', path: '/api/v1/flights/{id}', answer: 'json' },
  getFlightTelemetry: { method: 'GET', path: '/api/v1/flights/{id}/telemetry', query: ['from', 'until', 'fields', 'slots', 'most'], answer: 'json' },
  getFollow: { method: 'GET', path: '/api/v1/follows/{id}', answer: 'json' },
  getHealth: { method: 'GET', path: '/api/v1/health', answer: 'json' },
  getHealthParts: { method: 'GET', path: '/api/v1/health/parts', answer: 'json' },
  getHistory: { method: 'GET', path: '/api/v1/history', answer: 'json' },
  getLinkSecurity: { method: 'GET', path: '/api/v1/drones/{id}/link-security', answer: 'json' },
  getLogFile: { method: 'GET', path: '/api/v1/drones/{id}/logs/{number}/file', answer: 'file' },
  getMission: { method: 'GET', path: '/api/v1/missions/{id}', answer: 'json' },
  getOutlet: { method: 'GET', path: '/api/v1/outlet', answer: 'json' },
  getPlan: { method: 'GET', path: '/api/v1/plans/{id}', answer: 'json' },
  getProspects: { method: 'GET', path: '/api/v1/warehouse/{id}/prospects', answer: 'json' },
  getRallyPoints: { method: 'GET', path: '/api/v1/drones/{id}/rally-points', answer: 'json' },
  getRecording: { method: 'GET', path: '/api/v1/recordings/{id}', answer: 'json' },
  getRecordingFile: { method: 'GET', path: '/api/v1/recordings/{id}/file', answer: 'file' },
  getRecordingSent: { method: 'GET', path: '/api/v1/recordings/{id}/sent', answer: 'text' },
  getRecovery: { method: 'GET', path: '/api/v1/recoveries/{id}', answer: 'json' },
  getRegistrationPolicy: { method: 'GET', path: '/api/v1/registrations', answer: 'json' },
  getReplay: { method: 'GET', path: '/api/v1/replays/{id}', answer: 'json' },
  getRun: { method: 'GET', path: '/api/v1/runs/{id}', answer: 'json' },
  getRunJournal: { method: 'GET', path: '/api/v1/runs/{id}/journal', query: ['from'], answer: 'json' },
  getSensed: { method: 'GET', path: '/api/v1/drones/{id}/sensed', answer: 'json' },
  getSensedMap: { method: 'GET', path: '/api/v1/drones/{id}/sensed/map', answer: 'file' },
  getSensedPicture: { method: 'GET', path: '/api/v1/drones/{id}/sensed/picture', answer: 'file' },
  getSession: { method: 'GET', path: '/api/v1/session', answer: 'json' },
  getSettings: { method: 'GET', path: '/api/v1/settings', answer: 'json' },
  getTraffic: { method: 'GET', path: '/api/v1/traffic', answer: 'json' },
  getVirtualDrone: { method: 'GET', path: '/api/v1/virtual-drones/{id}', answer: 'json' },
  getZone: { method: 'GET', path: '/api/v1/zones/{id}', answer: 'json' },
  giveCommand: { method: 'POST', path: '/api/v1/drones/{id}/commands', query: ['wait'], body: ['application/json'], answer: 'json' },
  giveDrone: { method: 'PUT', path: '/api/v1/organisations/{id}/drones/{drone}', body: ['application/json'], answer: 'json' },
  giveUpRunDrone: { method: 'POST', path: '/api/v1/runs/{id}/drones/{drone}/give-up', answer: 'json' },
  grantControl: { method: 'POST', path: '/api/v1/drones/{id}/control/grant', body: ['application/json'], answer: 'json' },
  handOverControl: { method: 'POST', path: '/api/v1/drones/{id}/control/hand-over', body: ['application/json'], answer: 'json' },
  importParameters: { method: 'POST', path: '/api/v1/drones/{id}/parameters/file', query: ['dryRun'], body: ['text/plain'], answer: 'json' },
  importZones: { method: 'POST', path: '/api/v1/zones/import', body: ['application/geo+json', 'application/vnd.google-earth.kml+xml', 'application/vnd.google-earth.kmz'], answer: 'json' },
  installLinkKey: { method: 'POST', path: '/api/v1/drones/{id}/link-key/install', body: ['application/json'], answer: 'json' },
  issueRobotKey: { method: 'POST', path: '/api/v1/robot-keys', body: ['application/json'], answer: 'json' },
  joinRun: { method: 'POST', path: '/api/v1/runs/{id}/drones', body: ['application/json'], answer: 'json' },
  keepControl: { method: 'POST', path: '/api/v1/drones/{id}/control/heartbeat', body: ['application/json'], answer: 'json' },
  listAccessKeys: { method: 'GET', path: '/api/v1/access-keys', answer: 'json' },
  listCommands: { method: 'GET', path: '/api/v1/drones/{id}/commands', answer: 'json' },
  listDispatches: { method: 'GET', path: '/api/v1/dispatches', answer: 'json' },
  listDroneEvents: { method: 'GET', path: '/api/v1/drones/{id}/events', query: ['from', 'until', 'fields', 'slots', 'most'], answer: 'json' },
  listDroneTelemetryPoints: { method: 'GET', path: '/api/v1/drones/{id}/telemetry/points', query: ['from', 'until', 'fields', 'slots', 'most'], answer: 'json' },
  listDrones: { method: 'GET', path: '/api/v1/drones', query: ['active'], answer: 'json' },
  listDtlsKeys: { method: 'GET', path: '/api/v1/dtls-keys', answer: 'json' },
  listEndpoints: { method: 'GET', path: '/api/v1/endpoints', answer: 'json' },
  listFleets: { method: 'GET', path: '/api/v1/fleets', answer: 'json' },
  listFlightEvents: { method: 'GET', path: '/api/v1/flights/{id}/events', query: ['from', 'until', 'fields', 'slots', 'most'], answer: 'json' },
  listFlightTelemetryPoints: { method: 'GET', path: '/api/v1/flights/{id}/telemetry/points', query: ['from', 'until', 'fields', 'slots', 'most'], answer: 'json' },
  listFlights: { method: 'GET', path: '/api/v1/flights', query: ['drone', 'user', 'from', 'until', 'words', 'before', 'limit'], answer: 'json' },
  listFollows: { method: 'GET', path: '/api/v1/follows', answer: 'json' },
  listGivenDrones: { method: 'GET', path: '/api/v1/organisations/{id}/drones', answer: 'json' },
  listGrants: { method: 'GET', path: '/api/v1/grants', answer: 'json' },
  listGroups: { method: 'GET', path: '/api/v1/groups', answer: 'json' },
  listInvitations: { method: 'GET', path: '/api/v1/invitations', answer: 'json' },
  listLeftBehind: { method: 'GET', path: '/api/v1/left-behind', answer: 'json' },
  listLogs: { method: 'GET', path: '/api/v1/drones/{id}/logs', answer: 'json' },
  listMissions: { method: 'GET', path: '/api/v1/missions', answer: 'json' },
  listOrganisations: { method: 'GET', path: '/api/v1/organisations', answer: 'json' },
  listOutletClients: { method: 'GET', path: '/api/v1/outlet/clients', answer: 'json' },
  listParameters: { method: 'GET', path: '/api/v1/drones/{id}/parameters', query: ['search'], answer: 'json' },
  listPlans: { method: 'GET', path: '/api/v1/plans', answer: 'json' },
  listRecordings: { method: 'GET', path: '/api/v1/recordings', query: ['drone'], answer: 'json' },
  listRecoveries: { method: 'GET', path: '/api/v1/recoveries', answer: 'json' },
  listReplays: { method: 'GET', path: '/api/v1/replays', answer: 'json' },
  listRobotKeys: { method: 'GET', path: '/api/v1/robot-keys', answer: 'json' },
  listRuns: { method: 'GET', path: '/api/v1/runs', answer: 'json' },
  listUserAccessKeys: { method: 'GET', path: '/api/v1/users/{name}/access-keys', answer: 'json' },
  listUsers: { method: 'GET', path: '/api/v1/users', answer: 'json' },
  listVirtualDrones: { method: 'GET', path: '/api/v1/virtual-drones', answer: 'json' },
  listWaiting: { method: 'GET', path: '/api/v1/waiting', answer: 'json' },
  listWarehouse: { method: 'GET', path: '/api/v1/warehouse', answer: 'json' },
  listZones: { method: 'GET', path: '/api/v1/zones', answer: 'json' },
  makeAccessKey: { method: 'POST', path: '/api/v1/access-keys', body: ['application/json'], answer: 'json' },
  makeBackup: { method: 'POST', path: '/api/v1/backup', answer: 'file' },
  makeDtlsKey: { method: 'POST', path: '/api/v1/dtls-keys', body: ['application/json'], answer: 'json' },
  makeLinkKey: { method: 'POST', path: '/api/v1/drones/{id}/link-key', body: ['application/json'], answer: 'json' },
  makePlan: { method: 'POST', path: '/api/v1/plans', body: ['application/json'], answer: 'json' },
  makeStreamTicket: { method: 'POST', path: '/api/v1/stream-tickets', answer: 'json' },
  moveRunWaypoint: { method: 'PATCH', path: '/api/v1/runs/{id}/waypoints/{waypoint}', body: ['application/json'], answer: 'json' },
  openFollow: { method: 'POST', path: '/api/v1/follows', body: ['application/json'], answer: 'json' },
  openOutletPort: { method: 'POST', path: '/api/v1/outlet/ports', body: ['application/json'], answer: 'json' },
  orderTour: { method: 'POST', path: '/api/v1/tours', body: ['application/json'], answer: 'json' },
  pauseFollow: { method: 'POST', path: '/api/v1/follows/{id}/pause', answer: 'json' },
  pauseRun: { method: 'POST', path: '/api/v1/runs/{id}/pause', answer: 'json' },
  previewRecovery: { method: 'POST', path: '/api/v1/recoveries/preview', body: ['application/json'], answer: 'json' },
  putIntoWarehouse: { method: 'PUT', path: '/api/v1/warehouse/{id}', answer: 'json' },
  readFence: { method: 'POST', path: '/api/v1/drones/{id}/fence/refresh', answer: 'json' },
  readLogs: { method: 'POST', path: '/api/v1/drones/{id}/logs/refresh', answer: 'json' },
  readParameters: { method: 'POST', path: '/api/v1/drones/{id}/parameters/refresh', query: ['wait'], answer: 'json' },
  readRallyPoints: { method: 'POST', path: '/api/v1/drones/{id}/rally-points/refresh', answer: 'json' },
  refuseControl: { method: 'POST', path: '/api/v1/drones/{id}/control/refuse', body: ['application/json'], answer: 'json' },
  register: { method: 'POST', path: '/api/v1/registrations', body: ['application/json'], answer: 'json' },
  releaseControl: { method: 'DELETE', path: '/api/v1/drones/{id}/control', answer: 'json' },
  removeDrone: { method: 'DELETE', path: '/api/v1/drones/{id}', answer: 'nothing' },
  removeEndpoint: { method: 'DELETE', path: '/api/v1/endpoints/{id}', answer: 'nothing' },
  removePlan: { method: 'DELETE', path: '/api/v1/plans/{id}', answer: 'nothing' },
  removeReplay: { method: 'DELETE', path: '/api/v1/replays/{id}', answer: 'nothing' },
  removeVirtualDrone: { method: 'DELETE', path: '/api/v1/virtual-drones/{id}', answer: 'nothing' },
  renameDrone: { method: 'PATCH', path: '/api/v1/drones/{id}', body: ['application/json'], answer: 'json' },
  renameOrganisation: { method: 'PATCH', path: '/api/v1/organisations/{id}', body: ['application/json'], answer: 'json' },
  renewAccessKey: { method: 'POST', path: '/api/v1/access-keys/{id}/renew', answer: 'json' },
  replaceFleet: { method: 'PUT', path: '/api/v1/fleets/{id}', body: ['application/json'], answer: 'json' },
  replaceGroup: { method: 'PUT', path: '/api/v1/groups/{id}', body: ['application/json'], answer: 'json' },
  replaceMission: { method: 'PUT', path: '/api/v1/missions/{id}', body: ['application/json'], answer: 'json' },
  replaceVirtualDrone: { method: 'PUT', path: '/api/v1/virtual-drones/{id}', body: ['application/json'], answer: 'json' },
  replaceZone: { method: 'PUT', path: '/api/v1/zones/{id}', body: ['application/json'], answer: 'json' },
  replayRecording: { method: 'POST', path: '/api/v1/recordings/{id}/replays', query: ['speed'], answer: 'json' },
  replayRunJournal: { method: 'GET', path: '/api/v1/runs/{id}/journal/replay', answer: 'json' },
  reportFollowPositions: { method: 'POST', path: '/api/v1/follows/{id}/positions', body: ['application/json'], answer: 'json' },
  requestControl: { method: 'POST', path: '/api/v1/drones/{id}/control/request', body: ['application/json'], answer: 'json' },
  resetPassword: { method: 'POST', path: '/api/v1/users/{name}/password', answer: 'json' },
  resumeRunDrone: { method: 'POST', path: '/api/v1/runs/{id}/drones/{drone}/resume', answer: 'json' },
  resumeVirtualDrone: { method: 'POST', path: '/api/v1/virtual-drones/{id}/resume', answer: 'json' },
  revokeGrant: { method: 'DELETE', path: '/api/v1/grants/{id}', answer: 'nothing' },
  revokeRobotKey: { method: 'DELETE', path: '/api/v1/robot-keys/{id}', answer: 'nothing' },
  rotateLinkKey: { method: 'POST', path: '/api/v1/drones/{id}/link-key/rotate', body: ['application/json'], answer: 'json' },
  searchAudit: { method: 'GET', path: '/api/v1/audit', query: ['user', 'drone', 'operation', 'face', 'outcome', 'from', 'until', 'before', 'limit'], answer: 'json' },
  sendDrone: { method: 'POST', path: '/api/v1/dispatches', body: ['application/json'], answer: 'json' },
  setFence: { method: 'PUT', path: '/api/v1/drones/{id}/fence', body: ['application/json'], answer: 'json' },
  setFenceFromZones: { method: 'PUT', path: '/api/v1/drones/{id}/fence/zones', answer: 'json' },
  setGroupOnlyGranted: { method: 'PUT', path: '/api/v1/groups/{id}/only-granted', body: ['application/json'], answer: 'nothing' },
  setLinkSecurity: { method: 'PUT', path: '/api/v1/drones/{id}/link-security', body: ['application/json'], answer: 'json' },
  setOutletPassphrase: { method: 'PUT', path: '/api/v1/outlet/passphrase', body: ['application/json'], answer: 'json' },
  setParameter: { method: 'PUT', path: '/api/v1/drones/{id}/parameters/{name}', query: ['wait'], body: ['application/json'], answer: 'json' },
  setRallyPoints: { method: 'PUT', path: '/api/v1/drones/{id}/rally-points', body: ['application/json'], answer: 'json' },
  setUserOnlyGranted: { method: 'PUT', path: '/api/v1/users/{name}/only-granted', body: ['application/json'], answer: 'nothing' },
  signIn: { method: 'POST', path: '/api/v1/session', body: ['application/json'], answer: 'json' },
  signOut: { method: 'DELETE', path: '/api/v1/session', answer: 'nothing' },
  signOutEverywhere: { method: 'POST', path: '/api/v1/session/sign-out-everywhere', answer: 'nothing' },
  signOutUser: { method: 'POST', path: '/api/v1/users/{name}/sign-out', answer: 'nothing' },
  startFollow: { method: 'POST', path: '/api/v1/follows/{id}/start', answer: 'json' },
  startReplay: { method: 'POST', path: '/api/v1/replays', query: ['speed', 'name'], body: ['application/octet-stream'], answer: 'json' },
  startRun: { method: 'POST', path: '/api/v1/runs', body: ['application/json'], answer: 'json' },
  startSignInElsewhere: { method: 'GET', path: '/api/v1/session/oidc', answer: 'redirect' },
  startVirtualDrone: { method: 'POST', path: '/api/v1/virtual-drones/{id}/start', body: ['application/json'], answer: 'json' },
  stopFollow: { method: 'POST', path: '/api/v1/follows/{id}/stop', answer: 'json' },
  stopPlan: { method: 'POST', path: '/api/v1/plans/{id}/stop', answer: 'json' },
  stopRun: { method: 'POST', path: '/api/v1/runs/{id}/stop', answer: 'json' },
  stopVirtualDrone: { method: 'POST', path: '/api/v1/virtual-drones/{id}/stop', answer: 'json' },
  takeBackDrone: { method: 'DELETE', path: '/api/v1/organisations/{id}/drones/{drone}', answer: 'json' },
  takeControl: { method: 'POST', path: '/api/v1/drones/{id}/control/take', answer: 'json' },
  takeFromWarehouse: { method: 'DELETE', path: '/api/v1/warehouse/{id}', answer: 'nothing' },
  takeOverControl: { method: 'POST', path: '/api/v1/drones/{id}/control/take-over', body: ['application/json'], answer: 'json' },
  verifyAudit: { method: 'POST', path: '/api/v1/audit/verification', body: ['application/json'], answer: 'json' },
  withdrawInvitation: { method: 'DELETE', path: '/api/v1/invitations/{id}', answer: 'nothing' },
} as const satisfies Record<keyof RestOperations, Operation>;
