import type { Dispatch } from '../api/dispatches';
import { distance, span } from '../ui/format';

/** Where a drone that was sent is now, in a few words. */
export function stageText({ state, droneName, now }: Dispatch): string {
  const name = droneName ?? 'The drone';
  switch (state) {
    case 'chosen':
      return `${name} · chosen${arrival(now)}`;
    case 'starting':
      return `${name} · starting${arrival(now)}`;
    case 'enRoute':
      return `${name} · on its way${arrival(now)}`;
    case 'arrived':
      return `${name} · there`;
    case 'here':
      return `${name} is here: control is yours`;
    case 'searching':
      return 'Another drone is looked for';
    case 'returning':
      return 'Called off · flying home';
    case 'over':
      return 'Ended';
  }
}

function arrival(now: Dispatch['now']): string {
  const meters = now?.distance ?? null;
  const seconds = now?.seconds ?? null;
  const away = meters === null ? '' : ` · ${distance(meters)}`;
  return seconds === null ? away : `${away} · ${span(seconds)}`;
}

/** The newest of its sentences, or null. */
export function newestWords({ note, end, told }: Dispatch): string | null {
  return note ?? end ?? told.at(-1)?.words ?? null;
}
