import type { Endpoint } from '../api/endpoints';

/** Ports that vehicles connect to; null: none of that kind. */
export interface VehiclePorts {
  udp: string | null;
  tcp: string | null;
}

/** The first open port of each kind that listens. */
export function vehiclePorts(endpoints: readonly Endpoint[]): VehiclePorts {
  return { udp: portOf(endpoints, 'udpserver'), tcp: portOf(endpoints, 'tcpserver') };
}

function portOf(endpoints: readonly Endpoint[], scheme: string): string | null {
  const open = endpoints.find(({ url, state }) => state === 'open' && url.startsWith(`${scheme}://`));
  return open === undefined ? null : (/:(\d+)(?:[/?]|$)/.exec(open.url)?.[1] ?? null);
}

/** The ports to send MAVLink to, as text. */
export function portsText({ udp, tcp }: VehiclePorts): string {
  const ports = [udp === null ? null : `UDP port ${udp}`, tcp === null ? null : `TCP port ${tcp}`];
  return ports.filter((port) => port !== null).join(' or ') || 'one of the links of this cloud';
}
