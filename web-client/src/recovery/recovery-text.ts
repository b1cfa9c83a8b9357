import type { Recovery, RecoveryPreview } from '../api/recoveries';
import { span } from '../ui/format';

type Leg = Recovery['drones'][number];

const STEPS: Record<Leg['step'], string> = {
  aloft: 'holds',
  levelling: 'goes to its height',
  level: 'holds at its height',
  underWay: 'on its way home',
  overHome: 'holds above its home',
  descending: 'descending',
  down: 'on the ground',
};

const OUTCOMES: Record<NonNullable<Leg['outcome']>, string> = {
  down: 'down',
  notKnown: 'not known',
  taken: 'taken',
  failed: 'failed',
  givenBack: 'holds, yours',
};

/** What all of them do together, in a few words. */
export function recoveryText({ manner, state, drones, end }: Recovery): string {
  const down = drones.filter((one) => one.outcome === 'down').length;
  const what = manner === 'land' ? 'Land all' : 'Return all';
  switch (state) {
    case 'stopping':
      return `${what} · all stop`;
    case 'comingDown':
      return `${what} · ${down} of ${drones.length} down`;
    case 'givingBack':
      return 'Called off · drones hold';
    case 'over':
      return end ?? 'Ended';
  }
}

/** What one of them does, or what became of it. */
export function legText(leg: Leg): string {
  if (leg.outcome !== null) {
    return leg.note === null ? OUTCOMES[leg.outcome] : `${OUTCOMES[leg.outcome]} · ${leg.note}`;
  }
  if (leg.note !== null) {
    return leg.note;
  }
  const waits = leg.waitsFor.length > 0 ? ` · waits for ${leg.waitsFor.join(', ')}` : '';
  return `${STEPS[leg.step]}${waits}`;
}

/** One line of a preview. */
export function plannedText({ plan, waitsFor }: RecoveryPreview['drones'][number], manner: string): string {
  if (plan === null) {
    return 'not heard · its own fail-safe brings it home';
  }
  const height = `${manner === 'land' ? 'from' : 'at'} ${plan.height.toFixed(0)} m`;
  const waits = waitsFor.length > 0 ? ` · after ${waitsFor.join(', ')}` : '';
  // A figure and its unit stay in one line.
  const down = span(plan.downSeconds).replaceAll(' ', '\u00a0');
  return `${height} · down in ${down}${waits}`;
}
