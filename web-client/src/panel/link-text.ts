import type { LinkQuality } from '../api/types';
import type { Tone } from '../fleet/drone-status';
import { fixed, UNKNOWN } from '../ui/format';

/** From here on a pilot should know before anything else does. */
const WORRYING_LOSS = 0.05;

/** How well the link carries, in one line: what was lost lately and over a minute, and how long an answer takes. */
export function linkQualityText(quality: LinkQuality | undefined): string {
  const { lossShort, lossLong, rttMs } = quality ?? { lossShort: null, lossLong: null, rttMs: null };
  if (lossShort === null && rttMs === null) {
    return `Link quality ${UNKNOWN}`;
  }
  const loss = `${percent(lossShort)} lost now, ${percent(lossLong)} in a minute`;
  return `Link: ${loss} · round trip ${rttMs === null ? UNKNOWN : `${fixed(rttMs)} ms`}`;
}

export function lossTone(quality: LinkQuality | undefined): Tone {
  return (quality?.lossShort ?? 0) >= WORRYING_LOSS ? 'amber' : 'neutral';
}

function percent(share: number | null): string {
  return share === null ? UNKNOWN : `${fixed(share * 100, share > 0 && share < 0.1 ? 1 : 0)} %`;
}
