import type { PersonalPort } from '../api/outlet';
import { timeOfDay } from '../ui/format';
import { addressText, outletAddresses } from './settings';

/** The address that a program connects to; `host`: by which this page reached the server. */
export function portPlace(port: PersonalPort, host: string): string {
  return outletAddresses([port.endpoint], host).map(addressText).join() || port.endpoint;
}

/** The client that has it, or may have it, and until when. */
export function portText(port: PersonalPort): string {
  const who = port.peer === null ? `for the first from ${port.address}` : `${port.peer} has it`;
  const others = port.refused > 0 ? ` · ${port.refused} messages of others kept outside` : '';
  return `${who} · until ${timeOfDay(port.until)}${others}`;
}
