import type { OutletClient, OutletRefused } from '../api/outlet';
import { counted } from '../ui/format';

const COUNT = new Intl.NumberFormat('en-GB', { maximumFractionDigits: 0 });
const RATE = new Intl.NumberFormat('en-GB', { maximumFractionDigits: 1 });
/** Clients send a heartbeat each second. */
const QUIET_SECONDS = 5;

/** The message rates to and from a ground station. */
export function rateText(client: OutletClient): string {
  const { messagesPerSecondOut: out, messagesPerSecondIn: into } = client;
  return `${rate(out)} messages/s to it, ${rate(into)}/s from it`;
}

function rate(value: number): string {
  return value < 10 ? RATE.format(value) : COUNT.format(value);
}

export function clientText(client: OutletClient): string {
  return `${client.address} ${client.transport} · system ${client.systemId} · sees ${counted(client.drones, 'drone')}`;
}

/** Problems of a client; null: none. */
export function troubleText(client: OutletClient): string | null {
  const parts = [
    ...(client.dropped > 0 ? [`${COUNT.format(client.dropped)} dropped: its link is too slow`] : []),
    ...(client.silentSeconds >= QUIET_SECONDS ? [`silent for ${COUNT.format(client.silentSeconds)} s`] : []),
  ];
  return parts.length === 0 ? null : parts.join(' · ');
}

const REFUSED: [keyof OutletRefused, string][] = [
  ['unsigned', 'unsigned'],
  ['badSignature', 'with a wrong passphrase'],
  ['replayed', 'sent again'],
  ['tooOld', 'with a clock that is late'],
  ['turnedAway', 'from users who may not attach'],
  ['elsewhere', 'at personal ports of somebody else'],
];

/** Messages of strangers, by reason; null: there were none. */
export function refusedText(refused: OutletRefused): string | null {
  const parts = REFUSED.filter(([kind]) => refused[kind] > 0).map(
    ([kind, words]) => `${COUNT.format(refused[kind])} ${words}`,
  );
  return parts.length === 0 ? null : `Messages kept outside: ${parts.join(', ')}.`;
}
