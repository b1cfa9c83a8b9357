import type { Drone, Outcome } from '../api/types';
import type { Draft } from '../plan/draft';
import { beginsWithTakeOff } from '../plan/numbering';
import type { Attempt } from '../state/commands.svelte';
import type { Station } from '../state/station.svelte';

/** The reason for which an upload was refused, at the item that it is about. */
export interface ItemFault {
  /** As on the vehicle, from 1, the take-off included. */
  number: number;
  sentence: string;
}

const FIELD = /^items\[(\d+)\]/;
const SENTENCE = /^Item (\d+) \([^)]*\): ?(.*)$/s;

/**
 * Finds the item that a refused upload is about; null where it is about none of them.
 *
 * @param before how many items the cloud puts in front of those that were sent
 */
export function itemFault(attempt: Attempt | null, before: number): ItemFault | null {
  return attempt?.phase !== 'done'
    ? null
    : (faultOfField(attempt, before) ?? faultOfSentence(attempt.outcome));
}

/** Its number is that in the request, which is not the vehicle's where the cloud adds a take-off. */
function faultOfField({ field, problem }: Attempt, before: number): ItemFault | null {
  const item = FIELD.exec(field ?? '');
  if (item === null || problem === null) {
    return null;
  }
  return { number: Number(item[1]) + 1 + before, sentence: capital(SENTENCE.exec(problem)?.[2] ?? problem) };
}

function faultOfSentence(outcome: Outcome | null): ItemFault | null {
  const item = outcome?.code === 'mission-not-for-vehicle' ? SENTENCE.exec(outcome.reason ?? '') : null;
  return item === null ? null : { number: Number(item[1]), sentence: capital(item[2] ?? '') };
}

/** The same of the plan that was last uploaded to a drone, as long as nothing of it was edited since. */
export function draftFault(station: Station, drone: Drone, draft: Draft): ItemFault | null {
  const added = !draft.takeOff && beginsWithTakeOff(draft, drone) ? 1 : 0;
  // Looked at first: what was sent is no state, whose change would have this worked out again.
  const found = itemFault(station.commands.attempt(drone.id, 'uploadMission'), added);
  return station.planner.wasSent(drone.id) ? found : null;
}

function capital(sentence: string): string {
  return sentence.charAt(0).toUpperCase() + sentence.slice(1);
}
