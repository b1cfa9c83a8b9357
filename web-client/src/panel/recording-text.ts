import type { Recording } from '../api/recordings';
import { span } from '../ui/format';

/** The length and size of a recording, in one line. */
export function recordingText(flight: Recording): string {
  const length = flight.seconds === null ? 'going on' : span(Math.round(flight.seconds));
  return `${length} · ${size(flight.bytes)}`;
}

export function recordingDate(flight: Recording): string {
  return new Date(flight.start).toLocaleString([], { dateStyle: 'medium', timeStyle: 'short' });
}

export function size(bytes: number): string {
  if (bytes < 1e6) {
    return `${Math.max(1, Math.round(bytes / 1e3))} kB`;
  }
  return bytes < 1e9 ? `${(bytes / 1e6).toFixed(1)} MB` : `${(bytes / 1e9).toFixed(2)} GB`;
}
