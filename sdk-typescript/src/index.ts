/** The client of Dronemap: every operation of REST, the stream, commands and control. */
export type * from './contract/schemas.js';
export { OPERATIONS, type RestOperations } from './contract/operations.js';
export { PURPOSES } from './contract/purposes.js';
export { VERSION } from './version.js';
export type { CallOptions, FileBody } from './rest/operation.js';
export { Problem, sentenceFor, type ProblemBody } from './rest/problem.js';
export { RestClient, type Fetch, type LookOperation, type RestOptions } from './rest/rest-client.js';
export {
  openSocket,
  StreamClient,
  streamAddress,
  systemTimers,
  type Socket,
  type SocketClass,
  type SocketHandle,
  type StreamListener,
  type StreamOptions,
  type Timers,
} from './stream/stream-client.js';
export { Dronemap, type ConnectOptions } from './dronemap.js';
export { Drone, WaitEnded, type CommandOptions, type WaitOptions } from './drone.js';
export {
  CommandError,
  Failed,
  OutcomeUnknown,
  Refused,
  Superseded,
  TimedOut,
} from './command/command-error.js';
export type { GiveOptions } from './command/give.js';
export { GivenCommand, type OutcomeOptions } from './command/given-command.js';
export { Control, ControlLost, type ControlOptions, type OnExit } from './control/control.js';
export type { DroneEvent, EventsOptions } from './watch/events.js';
export type { Change, ChangesOptions, Gap, StatesOptions } from './watch/watching.js';
export { newUuid } from './uuid.js';
