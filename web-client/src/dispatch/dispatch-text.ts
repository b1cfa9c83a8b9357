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

/** The newest of its sentences without what {@link stageText} says already, or null. */
export function newestWords(dispatch: Dispatch): string | null {
  const { note, end, told } = dispatch;
  const words = note ?? end ?? told.at(-1)?.words ?? null;
  const said = `${stageText(dispatch)}. `;
  return words?.startsWith(said) === true ? words.slice(said.length) : words;
}
