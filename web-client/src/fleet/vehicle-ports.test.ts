import { describe, expect, it } from 'vitest';
import type { Endpoint } from '../api/endpoints';
import { vehiclePorts, portsText } from './vehicle-ports';

const open = (url: string, state: Endpoint['state'] = 'open'): Endpoint =>
  ({ id: url, url, state }) as Endpoint;

describe('ports in for vehicles', () => {
  it('are the ports that are open, and no others', () => {
    const ports = vehiclePorts([
      open('udpserver://0.0.0.0:14550', 'failed'),
      open('udpserver://0.0.0.0:28450'),
      open('tcpserver://0.0.0.0:28460'),
      open('udpclient://10.0.0.2:14550'),
    ]);
    expect(ports).toEqual({ udp: '28450', tcp: '28460' });
    expect(portsText(ports)).toBe('UDP port 28450 or TCP port 28460');
  });

  it('are shown without ports where none is known', () => {
    expect(portsText(vehiclePorts([]))).toBe('one of the links of this cloud');
    expect(portsText({ udp: '14550', tcp: null })).toBe('UDP port 14550');
  });
});
