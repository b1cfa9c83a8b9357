import type { Endpoint } from '../api/endpoints';

const COUNT = new Intl.NumberFormat('en-GB');

/** The traffic of an endpoint in one line; counts of problems are left out while they are zero. */
export function endpointText({ counts }: Endpoint): string {
  const dropped = counts.droppedIn + counts.droppedOut;
  const parts: [number, string][] = [
    [counts.lost, 'lost'],
    [counts.brokenBytes, 'broken bytes'],
    [dropped, 'dropped'],
    [counts.throttled, 'throttled'],
    [counts.refusedPeers, 'turned away'],
    [counts.kernelDrops ?? 0, 'dropped by the system'],
  ];
  const peers = counts.peers === 1 ? '1 peer' : `${COUNT.format(counts.peers)} peers`;
  return [
    peers,
    `${COUNT.format(counts.framesIn)} in`,
    `${COUNT.format(counts.framesOut)} out`,
    ...parts.filter(([count]) => count > 0).map(([count, what]) => `${COUNT.format(count)} ${what}`),
  ].join(' · ');
}
