import type { Attempt } from '../state/commands.svelte';

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
  if (attempt === null || attempt.phase !== 'done') {
    return null;
  }
  const field = FIELD.exec(attempt.field ?? '');
  if (field !== null && attempt.problem !== null) {
    return { number: Number(field[1]) + 1 + before, sentence: attempt.problem };
  }
  const { outcome } = attempt;
  const named = outcome?.code === 'mission-not-for-vehicle' ? SENTENCE.exec(outcome.reason ?? '') : null;
  if (named === null) {
    return null;
  }
  const sentence = named[2] ?? '';
  return { number: Number(named[1]), sentence: sentence.charAt(0).toUpperCase() + sentence.slice(1) };
}
