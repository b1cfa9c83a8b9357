import type { LinkQuality } from '../api/types';
import type { Tone } from '../fleet/drone-status';
import { fixed, UNKNOWN } from '../ui/format';

/** From here on a pilot should know before anything else does. */
const WORRYING_LOSS = 0.05;

/** The quality of the link in one line: loss now and over a minute, and round trip. */
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
