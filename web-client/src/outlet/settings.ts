/** An address that ground stations attach to. */
export interface OutletAddress {
  scheme: 'udp' | 'tcp' | 'dtls' | 'ws' | 'wss';
  host: string;
  port: string;
}

/** Lines to copy, or steps to follow, for one program. */
export interface ProgramSettings {
  program: string;
  steps: string[];
  lines: { label: string; text: string }[];
}

const SERVERS: Record<string, OutletAddress['scheme']> = {
  udpserver: 'udp',
  tcpserver: 'tcp',
  dtlsserver: 'dtls',
  wsserver: 'ws',
  wssserver: 'wss',
};

/** `host`: by which this page reached the server; an endpoint that listens everywhere is reached by it too. */
export function outletAddresses(endpoints: readonly string[], host: string): OutletAddress[] {
  return endpoints.flatMap((url): OutletAddress[] => {
    const match = /^(\w+):\/\/(\[[^\]]*\]|[^:/?]*):(\d+)/.exec(url);
    const scheme = SERVERS[match?.[1] ?? ''];
    const port = match?.[3];
    if (scheme === undefined || port === undefined) {
      return [];
    }
    const bound = match?.[2] ?? '';
    const everywhere = ['', '0.0.0.0', '[::]', '*'].includes(bound);
    return [{ scheme, host: everywhere ? host : bound, port }];
  });
}

export function addressText({ scheme, host, port }: OutletAddress): string {
  return scheme === 'ws' || scheme === 'wss'
    ? `${scheme}://${host}:${port}`
    : `${scheme.toUpperCase()} ${host}:${port}`;
}

/** The command line of the signer, for programs that cannot sign; null: there is no address for it. */
export function signerFor(addresses: readonly OutletAddress[]): string | null {
  const way = addresses.find((one) => one.scheme === 'udp' || one.scheme === 'tcp');
  return way === undefined
    ? null
    : `python -m dronemap_signing_relay --server ${way.scheme}:${way.host}:${way.port}`;
}

/** Exact settings of the usual programs; `passphrase` null: it is not known here any more. */
export function settingsFor(
  addresses: readonly OutletAddress[],
  passphrase: string | null,
): ProgramSettings[] {
  const way = addresses.find((one) => one.scheme === 'udp') ?? addresses.find((one) => one.scheme === 'tcp');
  if (way === undefined) {
    return [];
  }
  const { host, port } = way;
  const udp = way.scheme === 'udp';
  const secret = passphrase ?? 'PASSPHRASE';
  const address = `${udp ? 'udpout' : 'tcp'}:${host}:${port}`;
  return [
    {
      program: 'QGroundControl',
      steps: [
        udp
          ? `Application settings → Comm Links → Add: type UDP, any free port, server address ${host}:${port}.`
          : `Application settings → Comm Links → Add: type TCP, server ${host}, port ${port}.`,
        'Application settings → MAVLink → Signing: the passphrase.',
        'Switch AutoConnect → UDP off where vehicles call in on the same machine.',
      ],
      lines: udp ? [{ label: 'Server address', text: `${host}:${port}` }] : [],
    },
    {
      program: 'Mission Planner',
      steps: [
        `Connect with ${udp ? 'UDPCl' : 'TCP'} to ${host}, port ${port}.`,
        'Setup → Advanced → MAVLink Signing: add the passphrase and use it.',
      ],
      lines: [],
    },
    {
      program: 'MAVProxy',
      steps: [],
      lines: [
        { label: 'In the shell', text: `mavproxy.py --mav20 --master=${address}` },
        { label: 'In MAVProxy', text: `signing key "${secret}"` },
      ],
    },
    {
      program: 'pymavlink',
      steps: ['Set the environment variable MAVLINK20=1 first: version 1 knows no signatures.'],
      lines: [
        {
          label: 'Connect',
          text: `link = mavutil.mavlink_connection("${address}", source_system=255)`,
        },
        {
          label: 'Sign',
          text: `link.setup_signing(hashlib.sha256(b"${secret}").digest(), sign_outgoing=True)`,
        },
        { label: 'Attach, once a second', text: 'link.mav.heartbeat_send(6, 8, 0, 0, 4)' },
      ],
    },
  ];
}
