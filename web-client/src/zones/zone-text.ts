import type { BreachAction, Zone } from '../api/zones';

export const BREACH_WORDS: Record<BreachAction, string> = {
  hold: 'hold',
  returnToLaunch: 'return to launch',
  land: 'land',
};

/** A zone in one line. */
export function zoneText(zone: Zone, nameOf: (drone: string) => string | null): string {
  const { properties } = zone;
  const parts = [properties.kind === 'inclusion' ? 'stay in' : 'keep out', heights(zone)];
  if (properties.drone !== null) {
    parts.push(`only ${nameOf(properties.drone) ?? 'one drone'}`);
  }
  if (properties.user !== null) {
    parts.push(`only for ${properties.user}`);
  }
  if (properties.from !== null) {
    parts.push(`from ${moment(properties.from)}`);
  }
  if (properties.until !== null) {
    parts.push(`until ${moment(properties.until)}`);
  }
  parts.push(`on breach ${BREACH_WORDS[properties.onBreach]}`);
  return parts.join(' · ');
}

function heights({ properties: { floor, ceiling, altitudeReference } }: Zone): string {
  const above = altitudeReference === 'home' ? 'above home' : 'above sea level';
  if (floor === null && ceiling === null) {
    return 'at any height';
  }
  if (floor === null) {
    return `up to ${ceiling} m ${above}`;
  }
  return ceiling === null ? `from ${floor} m ${above} upwards` : `${floor} to ${ceiling} m ${above}`;
}

function moment(iso: string): string {
  return new Date(iso).toLocaleString([], { dateStyle: 'short', timeStyle: 'short' });
}
