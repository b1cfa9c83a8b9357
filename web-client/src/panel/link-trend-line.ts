import type { LinkSample } from '../state/link-history';
import { fixed } from '../ui/format';

export const WIDTH = 96;
export const HEIGHT = 24;
/** Down to here the line shows small losses large; a worse link is drawn down to nothing. */
const FLOOR = 0.8;
const MOST_MINUTES = 5;
const MINUTE_MILLISECONDS = 60_000;

/** The corners of the line's unbroken parts, for polylines of an image of that width and height; five minutes wide. */
export function lineParts(samples: readonly LinkSample[]): string[] {
  const newest = samples.at(-1)?.at ?? 0;
  const floor = worst(samples) < FLOOR ? 0 : FLOOR;
  const parts: string[][] = [];
  for (const { at, received, begins } of samples) {
    if (begins || parts.length === 0) {
      parts.push([]);
    }
    const x = WIDTH * (1 - (newest - at) / (MOST_MINUTES * MINUTE_MILLISECONDS));
    const y = 1 + (HEIGHT - 2) * (1 - (received - floor) / (1 - floor));
    parts.at(-1)?.push(`${x.toFixed(1)},${y.toFixed(1)}`);
  }
  return parts.filter((part) => part.length > 1).map((part) => part.join(' '));
}

/** "98 % received, 91 % at worst in 4 min"; null: too little is known yet. */
export function lineWords(samples: readonly LinkSample[]): string | null {
  const last = samples.at(-1);
  const first = samples[0];
  if (last === undefined || first === undefined || last === first) {
    return null;
  }
  const minutes = Math.max(1, Math.round((last.at - first.at) / MINUTE_MILLISECONDS));
  return `${percent(last.received)} received, ${percent(worst(samples))} at worst in ${String(minutes)} min`;
}

function worst(samples: readonly LinkSample[]): number {
  return samples.reduce((least, { received }) => Math.min(least, received), 1);
}

/** Never 100 where something was lost. */
function percent(share: number): string {
  return `${fixed(share > 0.995 && share < 1 ? 99 : share * 100)} %`;
}
