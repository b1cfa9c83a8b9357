import type { Follow, FollowOther, FollowPlace, FollowStage, FollowAction } from '../api/follows';
import { span } from '../ui/format';
import type { Absence } from './absence.svelte';

export interface StageText {
  /** A few words, large. */
  title: string;
  tone: 'green' | 'blue' | 'amber' | 'neutral';
  /** The state, as a sentence. */
  words: string;
}

const STAGES: Record<FollowStage, (drone: string) => StageText> = {
  allocated: (drone) => ({
    title: 'Ready to start',
    tone: 'blue',
    words: `${drone} is kept for you, on the ground.`,
  }),
  starting: (drone) => ({
    title: 'Taking off',
    tone: 'blue',
    words: `${drone} takes off and comes to you.`,
  }),
  tracking: (drone) => ({ title: 'Following you', tone: 'green', words: `${drone} goes where you go.` }),
  paused: (drone) => ({
    title: 'Paused',
    tone: 'amber',
    words: `${drone} stays where it is, in the air.`,
  }),
  suspended: (drone) => ({
    title: 'Control lost',
    tone: 'amber',
    // The note of the follow names the holder, if there is still one.
    words: `${drone} does not follow you now. “Resume” takes control of it again.`,
  }),
  returning: (drone) => ({
    title: 'Flying home',
    tone: 'blue',
    words: `${drone} flies home and lands there.`,
  }),
  over: (drone) => ({ title: 'Over', tone: 'neutral', words: `${drone} is free again.` }),
};

/** Something keeps it from following, as the note of the cloud says. */
export function isHeldUp({ state, note }: Follow): boolean {
  return state === 'tracking' && note !== null;
}

/** `unled`: the page knows that what it says leads no drone now. */
export function stageText(follow: Follow, unled = false): StageText {
  const { state, droneName, note } = follow;
  if (isHeldUp(follow) || (unled && state === 'tracking')) {
    return {
      title: 'Not following now',
      tone: 'amber',
      words: unled || note === null ? `${droneName} is not led now.` : note,
    };
  }
  return STAGES[state](droneName);
}

export interface ActionText {
  label: string;
  /** The effect, as a sentence. */
  effect: string;
  tone: 'plain' | 'primary' | 'danger';
  /** Moves the drone or cannot be undone: wants holding. */
  hold: boolean;
}

export const ACTIONS: Record<FollowAction, ActionText> = {
  start: {
    label: 'Start',
    effect: 'it arms its motors, takes off and comes. Nobody may stand beside it.',
    tone: 'primary',
    hold: true,
  },
  cancel: {
    label: 'Cancel',
    effect: 'the drone is free again; when it is in the air already, it flies home.',
    tone: 'plain',
    hold: false,
  },
  pause: {
    label: 'Pause',
    effect: 'it stays where it is, in the air, whatever you do. The battery runs on.',
    tone: 'primary',
    hold: false,
  },
  continue: { label: 'Resume', effect: 'it comes to you again.', tone: 'primary', hold: true },
  stop: {
    label: 'Stop and fly home',
    effect: 'it flies to where it took off and lands there, not beside you. That ends it.',
    tone: 'danger',
    hold: true,
  },
};

const STOP_OF_TAKEN: ActionText = {
  ...ACTIONS.stop,
  label: 'Stop',
  effect: 'that ends it. Whoever has the drone keeps it; one that nobody has any more is called home.',
};

/** The label and effect of an action at a stage. */
export function actionText(action: FollowAction, state: FollowStage): ActionText {
  return action === 'stop' && state === 'suspended' ? STOP_OF_TAKEN : ACTIONS[action];
}

/** The problem when the cloud did not answer; with a network it may have received the action. */
export function notDoneText(action: FollowAction, state: FollowStage, online: boolean): string {
  const { label } = actionText(action, state);
  return online
    ? `The cloud did not answer: whether “${label}” was done is seen when it does.`
    : `“${label}” was not done: there is no network. Press it again when there is one.`;
}

/** The id of the element that describes an action. */
export function effectId(action: FollowAction): string {
  return `effect-${action}`;
}

/** Actions at each stage, the likeliest first. */
const OFFERED: Record<FollowStage, readonly FollowAction[]> = {
  allocated: ['start', 'cancel'],
  starting: ['cancel'],
  tracking: ['pause', 'stop'],
  paused: ['continue', 'stop'],
  suspended: ['continue', 'stop'],
  returning: [],
  over: [],
};

/** While one drone returns already, its relief can be stopped. */
export function offered(follow: Follow): readonly FollowAction[] {
  return follow.state === 'returning' && reliefOf(follow) !== null ? ['stop'] : OFFERED[follow.state];
}

/** The drone that is on its way to replace the one that follows. */
export function reliefOf(follow: Follow): FollowOther | null {
  return follow.others.find(({ comes }) => comes) ?? null;
}

/** The other drones of the follow, as sentences. */
export function otherDroneTexts(follow: Follow): string[] {
  return follow.others.map(({ droneName, comes, state }) => {
    if (comes) {
      return `${droneName} comes to replace ${follow.droneName}.`;
    }
    return state === 'returning' ? `${droneName} flies home.` : `Somebody else flies ${droneName}.`;
  });
}

/** The behaviour of the drone during an absence of the phone, as far as the cloud reports it; it may have been down itself. */
export function absenceText({ told, since, state, note }: Follow, { from, waited }: Absence): string {
  const texts = told.filter(({ at }) => Date.parse(at) > from).map(({ words }) => words);
  if (texts.length === 0) {
    return '';
  }
  if (Date.parse(since) > from) {
    return texts.slice(-2).join(' ');
  }
  const again = state === 'tracking' && note === null ? ' Now it follows you again.' : '';
  return `The drone stood and waited for ${span(waited)}.${again}`;
}

/** A drone in the air needs positions of this phone. */
export function dependsOnPhone(follow: Follow | null): boolean {
  return follow !== null && (follow.state === 'starting' || follow.state === 'tracking');
}

/** No drone needs positions of this phone any more, neither this one nor a relief. */
export function isIdle(follow: Follow | null): boolean {
  return (
    follow !== null &&
    (follow.state === 'over' || (follow.state === 'returning' && reliefOf(follow) === null))
  );
}

const SIDES = ['north', 'north-east', 'east', 'south-east', 'south', 'south-west', 'west', 'north-west'];

export function compassText(degrees: number): string {
  return SIDES[Math.round((((degrees % 360) + 360) % 360) / 45) % 8] as string;
}

export function placeText(place: FollowPlace, who = 'you'): string {
  const where = {
    behind: 'behind',
    ahead: 'ahead of',
    fixed: `${compassText(place.bearing ?? 0)} of`,
    orbit: 'circling',
  }[place.side];
  return `${Math.round(place.distance)} m ${where} ${who}, ${Math.round(place.height)} m up`;
}

/** A summary of all follows in a few words, problems first. */
export function overviewNote(follows: readonly Follow[], isSilent: (follow: Follow) => boolean): string {
  const silent = follows.filter(isSilent).length;
  const heldUp = follows.filter((follow) => isHeldUp(follow) && !isSilent(follow)).length;
  if (silent + heldUp > 0) {
    return silent > 0 ? `${silent} silent of ${follows.length}` : `${heldUp} held up of ${follows.length}`;
  }
  return follows.length === 0 ? '' : `${follows.length} under way`;
}

/** One follow in one line for the ground station. `waits`: no positions come. */
export function followText(follow: Follow, waits = false): string {
  const words: Record<FollowStage, string> = {
    allocated: 'is kept for',
    starting: 'takes off for',
    tracking: isHeldUp(follow) ? 'is not following' : 'follows',
    paused: 'waits in the air for',
    suspended: 'is under other control and does not follow',
    returning: 'flies home from',
    over: 'followed',
  };
  const relief = reliefOf(follow);
  const then = relief === null ? '' : `; ${relief.droneName} comes to replace it`;
  const stands = waits && follow.state === 'tracking' ? 'stands still and waits for' : words[follow.state];
  return `${follow.droneName} ${stands} ${follow.owner}${then}`;
}
