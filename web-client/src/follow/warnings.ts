import { span, timeOfDay } from '../ui/format';
import type { Absence, AbsenceReason } from './absence.svelte';
import type { Locating } from './fix';
import type { WakeState } from './wake-lock.svelte';

/** The drone stops after 2 s without a position; one may be late. */
export const NO_FIX_SECONDS = 4;
/** From here on a drone stays more beside the phone than where it is wanted. */
export const BAD_METERS = 15;
/** The cloud does not lead a drone by worse ones. */
export const USELESS_METERS = 50;
export const LOW_PERCENT = 30;

/** red: the drone is not led now; green: it is again; amber: look. */
export interface Warning {
  key: string;
  tone: 'red' | 'green' | 'amber';
  words: string;
  todo: string;
}

/** The state that warnings are derived from. Times in milliseconds by the phone's clock. */
export interface PhoneStatus {
  now: number;
  /** A drone is led by positions of this page. */
  leading: boolean;
  /** Positions are not needed any more: the drone flies home, or is there. */
  idle: boolean;
  demo: boolean;
  locating: Locating;
  lastFix: number | null;
  /** Metres. */
  accuracy: number | null;
  /** The newest time without positions; null: there was none. */
  absence: Absence | null;
  /** A sentence of what the drone did during the absence. */
  meantime: string;
  /** Seconds without a position before the drone flies home; null: it waits for none. */
  patience: number | null;
  cutOffSince: number | null;
  /** As far as the phone knows, it has a network. */
  online: boolean;
  refused: string | null;
  wake: WakeState;
  /** Percent. */
  battery: number | null;
}

type Rule = (status: PhoneStatus) => Warning | null;

const BACK_SHOWN_MILLISECONDS = 30_000;
const TONES = ['red', 'green', 'amber'] as const;

/** The worst first. What is red now makes it untrue that all is well again. */
export function warningsFor(status: PhoneStatus): Warning[] {
  const rules = status.idle ? RULES.filter((rule) => !ABOUT_PLACE.includes(rule)) : RULES;
  const all = rules.map((rule) => rule(status)).filter((warning) => warning !== null);
  const bad = all.some(({ tone }) => tone === 'red');
  return all
    .filter(({ tone }) => !(bad && tone === 'green'))
    .sort((a, b) => TONES.indexOf(a.tone) - TONES.indexOf(b.tone));
}

const ABOUT_PLACE: readonly Rule[] = [denied, noFix, vague];
const RULES: readonly Rule[] = [
  denied,
  noFix,
  cutOff,
  refusedByCloud,
  back,
  vague,
  screenMayTurnOff,
  lowBattery,
];

function denied({ locating }: PhoneStatus): Warning | null {
  return locating === 'denied'
    ? {
        key: 'denied',
        tone: 'red',
        words: 'This page may not know where you are.',
        todo: 'Allow location for this page in the browser’s settings (the sign beside the address), then load it again.',
      }
    : null;
}

function noFix({ now, locating, lastFix, leading, patience, cutOffSince }: PhoneStatus): Warning | null {
  if (locating !== 'on' && locating !== 'unavailable') {
    return null;
  }
  const seconds = lastFix === null ? null : Math.floor((now - lastFix) / 1000);
  if (seconds === null ? locating !== 'unavailable' : seconds < NO_FIX_SECONDS) {
    return null;
  }
  return {
    key: 'no-fix',
    tone: 'red',
    words: seconds === null ? 'The phone does not know where it is.' : `No position for ${span(seconds)}.`,
    // The warning of the lost connection mentions the drone already.
    todo: `${leading && cutOffSince === null ? standsAndWaits(patience, seconds) : ''}Go where you see the sky, and keep location switched on.`,
  };
}

function standsAndWaits(patience: number | null, seconds: number | null): string {
  const left = patience === null || seconds === null ? null : patience - seconds;
  if (left === null) {
    return 'The drone stands and waits. ';
  }
  return left > 0 ? `The drone stands, and flies home in ${span(left)}. ` : 'By now the drone flies home. ';
}

/** During a follow CutOff.svelte shows this instead. */
function cutOff({ now, cutOffSince, online }: PhoneStatus): Warning | null {
  return cutOffSince === null
    ? null
    : { key: 'cut-off', tone: 'red', words: cutOffText(cutOffSince, now), todo: cutOffTodo(online) };
}

export function cutOffText(since: number, now: number): string {
  const seconds = Math.max(0, Math.floor((now - since) / 1000));
  return `Cut off from the cloud since ${timeOfDay(new Date(since).toISOString())}, ${span(seconds)} ago.`;
}

export function cutOffTitle(online: boolean): string {
  return online ? 'The cloud does not answer' : 'No network';
}

export function cutOffTodo(online: boolean): string {
  return `This page goes on by itself when ${online ? 'the cloud answers' : 'the network is back'}.`;
}

function refusedByCloud({ refused }: PhoneStatus): Warning | null {
  return refused === null
    ? null
    : {
        key: 'refused',
        tone: 'red',
        words: 'The cloud does not take your positions.',
        todo: refused,
      };
}

const ABSENCES: Record<AbsenceReason, (time: string) => [words: string, todo: string]> = {
  asleep: (time) => [
    `This page was stopped for ${time}: the screen was off, or something else was in front.`,
    'Keep this page in front and the screen on.',
  ],
  cut: (time) => [`There was no network for ${time}.`, ''],
  unanswered: (time) => [`The cloud did not answer for ${time}.`, ''],
  gone: (time) => [`This page was closed for ${time}.`, 'Keep this page open.'],
  blind: (time) => [
    `The phone did not know where it is for ${time}.`,
    'Stay where you see the sky, with location switched on.',
  ],
  vague: (time) => [
    `The phone knew its place to no better than 50 m for ${time}.`,
    'Stay where you see the sky, with location switched on.',
  ],
};

function back({ now, absence, meantime, leading }: PhoneStatus): Warning | null {
  if (absence === null || !leading || now - absence.until > BACK_SHOWN_MILLISECONDS) {
    return null;
  }
  const [words, todo] = ABSENCES[absence.why](span(absence.seconds));
  return {
    key: 'back',
    tone: 'green',
    words,
    todo: `${meantime} ${todo}`.trim(),
  };
}

function vague({ locating, accuracy, leading, patience }: PhoneStatus): Warning | null {
  if (locating !== 'on' || accuracy === null || accuracy < BAD_METERS) {
    return null;
  }
  const useless = accuracy > USELESS_METERS;
  return {
    key: 'vague',
    tone: useless ? 'red' : 'amber',
    words: `Your position is only known to ${Math.round(accuracy)} m.`,
    todo: useless
      ? `That is too vague to lead a drone.${homeAfter(leading, patience)} Go away from walls and trees, and allow the precise location.`
      : 'The drone may stand so far beside its place. Go away from walls and trees.',
  };
}

function homeAfter(leading: boolean, patience: number | null): string {
  return leading && patience !== null
    ? ` It stands, and flies home when that stays so for ${span(patience)}.`
    : '';
}

function screenMayTurnOff({ wake, leading, demo }: PhoneStatus): Warning | null {
  if (!leading || demo || wake === 'held' || wake === 'off') {
    return null;
  }
  return {
    key: 'screen-off',
    tone: 'amber',
    words: 'The screen may switch itself off.',
    todo: 'Then the phone says nothing more and the drone stands. Set the screen to stay on, and end power saving.',
  };
}

function lowBattery({ battery, leading }: PhoneStatus): Warning | null {
  return !leading || battery === null || battery > LOW_PERCENT
    ? null
    : {
        key: 'battery',
        tone: 'amber',
        words: `The drone’s battery has ${Math.round(battery)} % left.`,
        todo: 'It flies home by itself in time.',
      };
}
