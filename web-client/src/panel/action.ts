import type { CommandKind, Drone, Outcome } from '../api/types';
import type { Attempt } from '../state/commands.svelte';

/** The reason for which a control cannot be used now, or null: the page's own reason first, then that of the cloud. */
export function whyNot(drone: Drone, type: CommandKind, own: string | null): string | null {
  if (own !== null) {
    return own;
  }
  const action = drone.actions[type];
  if (action === undefined) {
    return 'This vehicle cannot do that.';
  }
  return action.allowed ? null : (action.why ?? 'Not possible now.');
}

/** The reason for which its motors cannot be stopped, or null. Robots stop instead. */
export function whyNoStop(drone: Drone): string | null {
  const { emergencyStop, forceDisarm } = drone.actions;
  const robot = emergencyStop?.allowed === true;
  if (robot || (forceDisarm?.allowed === true && drone.armed !== false)) {
    return null;
  }
  return forceDisarm?.why ?? emergencyStop?.why ?? 'This vehicle cannot do that.';
}

export type AttemptTone = 'busy' | 'good' | 'bad';

export interface AttemptText {
  tone: AttemptTone;
  words: string;
}

/** Commands that have succeeded when the vehicle begins; the flight itself is watched on the map. */
const GOES_ON: ReadonlySet<CommandKind> = new Set([
  'takeOff',
  'land',
  'returnToLaunch',
  'goTo',
  'startMission',
]);

/** The text and tone of a command's phase or outcome. */
export function attemptText(attempt: Attempt): AttemptText {
  if (attempt.problem !== null) {
    return { tone: 'bad', words: `Not sent. ${attempt.problem}` };
  }
  if (attempt.phase !== 'done') {
    return { tone: 'busy', words: progressText(attempt) };
  }
  if (attempt.outcome?.result === 'succeeded' && GOES_ON.has(attempt.type)) {
    return { tone: 'good', words: 'Under way' };
  }
  return outcomeText(attempt.outcome);
}

function outcomeText(outcome: Outcome | null): AttemptText {
  const reason = outcome?.reason ? ` ${outcome.reason}` : '';
  switch (outcome?.result) {
    case 'succeeded':
      return { tone: 'good', words: 'Done' };
    case 'refused':
      return { tone: 'bad', words: `Refused${outcome.by === 'vehicle' ? ' by the vehicle' : ''}.${reason}` };
    case 'failed':
      return { tone: 'bad', words: `Failed.${reason}` };
    case 'timedOut':
      return { tone: 'bad', words: `Timed out.${reason || ' The vehicle did not answer.'}` };
    case 'superseded':
      return { tone: 'bad', words: `Replaced by a later command.${reason}` };
    default:
      return { tone: 'bad', words: `Unknown whether the vehicle did it.${reason}` };
  }
}

function progressText(attempt: Attempt): string {
  const part = attempt.progress === null ? '' : ` ${attempt.progress.done} of ${attempt.progress.total}`;
  switch (attempt.phase) {
    case 'sending':
      return 'Sending…';
    case 'sent':
      return `Sent${part}, waiting for the vehicle…`;
    default:
      return `Accepted${part}, under way…`;
  }
}
