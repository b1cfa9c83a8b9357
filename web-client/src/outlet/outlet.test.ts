import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { OutletClient, PersonalPort } from '../api/outlet';
import { STATION, Station } from '../state/station.svelte';
import { rateText, refusedText, troubleText, clientText } from './client-text';
import OutletClients from './OutletClients.svelte';
import OwnOutlet from './OwnOutlet.svelte';
import { portText, portPlace } from './port-text';
import { settingsFor, signerFor, addressText, outletAddresses } from './settings';

const CLIENT: OutletClient = {
  id: 'client-1',
  user: 'ann',
  address: '192.0.2.1:5000',
  transport: 'udp',
  systemId: 255,
  drones: 1,
  since: '2026-01-01T12:00:00Z',
  messagesIn: 60,
  messagesOut: 74_040,
  queue: 0,
  messagesPerSecondIn: 1,
  messagesPerSecondOut: 1234,
  dropped: 0,
  silentSeconds: 0.4,
};
const NOBODY = { unsigned: 0, badSignature: 0, replayed: 0, tooOld: 0, turnedAway: 0, elsewhere: 0 };
const ENDPOINTS = ['udpserver://0.0.0.0:14560', 'tcpserver://127.0.0.1:5790', 'wssserver://[::]:5791/mav'];

const PORT: PersonalPort = {
  id: 'port-1',
  endpoint: 'udpserver://0.0.0.0:14561',
  address: '192.0.2.7',
  peer: null,
  user: 'ann',
  since: '2026-01-01T12:00:00Z',
  refused: 0,
  until: '2026-01-01T20:00:00Z',
};

afterEach(cleanup);

describe('an attached ground station', () => {
  it('is shown by rates, address and what it sees', () => {
    expect(rateText(CLIENT)).toBe('1,234 messages/s to it, 1/s from it');
    expect(clientText({ ...CLIENT, drones: 2 })).toBe('192.0.2.1:5000 udp · system 255 · sees 2 drones');
    expect(troubleText(CLIENT)).toBeNull();
    expect(troubleText({ ...CLIENT, dropped: 7, silentSeconds: 12.3 })).toBe(
      '7 dropped: its link is too slow · silent for 12 s',
    );
  });

  it('leaves strangers outside, counted by reason', () => {
    expect(refusedText(NOBODY)).toBeNull();
    expect(refusedText({ ...NOBODY, unsigned: 1200, badSignature: 3 })).toBe(
      'Messages kept outside: 1,200 unsigned, 3 with a wrong passphrase.',
    );
  });
});

describe('the settings of programs', () => {
  it('name the address by which this server was reached, unless it listens on one only', () => {
    expect(outletAddresses(ENDPOINTS, 'cloud.example').map(addressText)).toEqual([
      'UDP cloud.example:14560',
      'TCP 127.0.0.1:5790',
      'wss://cloud.example:5791',
    ]);
    expect(outletAddresses(['dtlsserver://0.0.0.0:14599'], 'cloud.example').map(addressText)).toEqual([
      'DTLS cloud.example:14599',
    ]);
    expect(outletAddresses(['serial:///dev/tty'], 'cloud.example')).toEqual([]);
  });

  it('can be copied as they are, with the passphrase while it is known', () => {
    const known = settingsFor(outletAddresses(ENDPOINTS, 'cloud.example'), 'open sesame 1234567');
    const lines = known.flatMap((program) => program.lines.map((line) => line.text));
    expect(lines).toContain('mavproxy.py --mav20 --master=udpout:cloud.example:14560');
    expect(lines).toContain('signing key "open sesame 1234567"');
    expect(known.map((one) => one.program)).toEqual([
      'QGroundControl',
      'Mission Planner',
      'MAVProxy',
      'pymavlink',
    ]);
    const [only] = settingsFor(outletAddresses([ENDPOINTS[1] ?? ''], 'x'), null).slice(2);
    expect(only?.lines[0]?.text).toBe('mavproxy.py --mav20 --master=tcp:127.0.0.1:5790');
    expect(settingsFor([], null)).toEqual([]);
    expect(signerFor(outletAddresses(ENDPOINTS, 'cloud.example'))).toBe(
      'python -m dronemap_signing_relay --server udp:cloud.example:14560',
    );
    expect(signerFor([])).toBeNull();
  });
});

describe('the outlet page', () => {
  it('shows a new passphrase once, and says when nothing is attached', async () => {
    const station = new Station();
    station.connection.up();
    const { outlet } = station.rest;
    const own = { endpoints: ENDPOINTS, passphraseSet: false, clients: [], ports: [] };
    const look = vi.spyOn(outlet, 'own').mockResolvedValue(own);
    vi.spyOn(outlet, 'newPassphrase').mockResolvedValue('correct horse battery');
    render(OwnOutlet, { context: new Map([[STATION, station]]) });
    await fireEvent.click(await screen.findByRole('button', { name: 'Make a passphrase' }));
    expect(await screen.findByText('correct horse battery')).toBeDefined();
    look.mockResolvedValue({ ...own, passphraseSet: true });
    expect(screen.queryByRole('list', { name: 'Attached in your name' })).toBeNull();
  });

  it('opens a personal port for an address, and closes it only when it is confirmed', async () => {
    const station = new Station();
    station.connection.up();
    const { outlet } = station.rest;
    const own = { endpoints: ENDPOINTS, passphraseSet: false, clients: [], ports: [] };
    const look = vi.spyOn(outlet, 'own').mockResolvedValue(own);
    const openPort = vi.spyOn(outlet, 'openPort').mockResolvedValue(PORT);
    const closePort = vi.spyOn(outlet, 'closePort').mockResolvedValue();
    render(OwnOutlet, { context: new Map([[STATION, station]]) });
    await fireEvent.click(await screen.findByText('Programs that cannot sign'));
    await fireEvent.input(screen.getByLabelText('Address of the program, or its network'), {
      target: { value: ' 192.0.2.7 ' },
    });
    look.mockResolvedValue({ ...own, ports: [PORT] });
    await fireEvent.click(screen.getByRole('button', { name: 'Open a port to look' }));
    expect(openPort).toHaveBeenCalledWith('192.0.2.7', 8);
    const button = await screen.findByRole('button', { name: /Close/ });
    await fireEvent.click(button);
    expect(closePort).not.toHaveBeenCalled();
    await fireEvent.click(button);
    expect(closePort).toHaveBeenCalledWith('port-1');
  });

  it('shows of a personal port where it is, who has it and how long', () => {
    expect(portPlace(PORT, 'cloud.example')).toBe('UDP cloud.example:14561');
    expect(portText(PORT)).toMatch(/^for the first from 192\.0\.2\.7 · until /);
    expect(portText({ ...PORT, peer: '192.0.2.7:5000', refused: 3 })).toMatch(
      /^192\.0\.2\.7:5000 has it · until .* · 3 messages of others kept outside$/,
    );
  });

  it('lists who is attached, and disconnects only when it is confirmed', async () => {
    const station = new Station();
    station.connection.up();
    const { outlet } = station.rest;
    vi.spyOn(outlet, 'all').mockResolvedValue({
      endpoints: ENDPOINTS,
      clients: [CLIENT],
      ports: [],
      refused: NOBODY,
      dropped: 0,
      notPassed: 0,
    });
    const disconnect = vi.spyOn(outlet, 'disconnect').mockResolvedValue();
    render(OutletClients, { context: new Map([[STATION, station]]) });
    const button = await screen.findByRole('button', { name: /Disconnect/ });
    expect(screen.getByText('1,234 messages/s to it, 1/s from it')).toBeDefined();
    await fireEvent.click(button);
    expect(disconnect).not.toHaveBeenCalled();
    await fireEvent.click(button);
    expect(disconnect).toHaveBeenCalledWith('client-1');
  });
});
