import type { LinkQuality, LinkTrend } from '../api/types';
import type { Tone } from '../fleet/drone-status';
import { fixed, UNKNOWN } from '../ui/format';

/** From here on a pilot should know before anything else does. */
const WORRYING_LOSS = 0.05;

/** The quality of the link in one line: loss now and over a minute, round trip and jitter. */
export function linkQualityText(quality: LinkQuality | undefined): string {
  const { lossShort = null, lossLong = null, rttMs = null, jitterMs = null } = quality ?? {};
  if (lossShort === null && rttMs === null) {
    return `Link quality ${UNKNOWN}`;
  }
  const loss = `${percent(lossShort)} lost now, ${percent(lossLong)} in a minute`;
  return `Link: ${loss} · round trip ${millis(rttMs)} · jitter ${millis(jitterMs)}`;
}

/** What is to be said of where the link goes; nothing while it is as it usually is, or that is not known. */
export function linkTrendText(trend: LinkTrend | null | undefined): string | null {
  return trend?.state === 'worse' || trend?.state === 'falling' ? trend.sentence : null;
}

export function trendTone(trend: LinkTrend | null | undefined): Tone {
  return trend?.state === 'falling' ? 'red' : 'amber';
}

function millis(value: number | null): string {
  return value === null ? UNKNOWN : `${fixed(value)} ms`;
}

export function lossTone(quality: LinkQuality | undefined): Tone {
  return (quality?.lossShort ?? 0) >= WORRYING_LOSS ? 'amber' : 'neutral';
}

function percent(share: number | null): string {
  return share === null ? UNKNOWN : `${fixed(share * 100, share > 0 && share < 0.1 ? 1 : 0)} %`;
}
