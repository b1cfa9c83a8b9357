/** The text for an unknown value. */
export const UNKNOWN = '—';

export function fixed(value: number | null | undefined, digits = 0): string {
  if (value === null || value === undefined) {
    return UNKNOWN;
  }
  const text = value.toFixed(digits);
  // Minus zero would flicker between "0.0" and "-0.0" on a vehicle that stands still.
  return Number(text) === 0 ? (0).toFixed(digits) : text.replace('-', '−');
}

export function heading(degrees: number | null | undefined): string {
  if (degrees === null || degrees === undefined) {
    return UNKNOWN;
  }
  return String(((Math.round(degrees) % 360) + 360) % 360).padStart(3, '0');
}

/** "1 item", "2 items". */
export function counted(count: number, noun: string): string {
  return `${count} ${noun}${count === 1 ? '' : 's'}`;
}

export function distance(meters: number): string {
  return meters < 1000 ? `${Math.round(meters)} m` : `${(meters / 1000).toFixed(2)} km`;
}

/** An age as short text. */
export function age(milliseconds: number | null): string {
  if (milliseconds === null) {
    return UNKNOWN;
  }
  const seconds = Math.max(0, Math.floor(milliseconds / 1000));
  if (seconds < 2) {
    return 'now';
  }
  if (seconds < 60) {
    return `${seconds} s ago`;
  }
  if (seconds < 3600) {
    return `${Math.floor(seconds / 60)} min ago`;
  }
  return seconds < 86_400 ? `${Math.floor(seconds / 3600)} h ago` : `${Math.floor(seconds / 86_400)} d ago`;
}

export function span(seconds: number): string {
  if (seconds < 60) {
    return `${seconds} s`;
  }
  return `${Math.floor(seconds / 60)} min ${String(seconds % 60).padStart(2, '0')} s`;
}

/** Without seconds, for what is known about that well. */
export function minuteOfDay(iso: string): string {
  return new Date(iso).toLocaleTimeString([], { hour: '2-digit', minute: '2-digit' });
}

export function timeOfDay(iso: string): string {
  return new Date(iso).toLocaleTimeString([], { hour: '2-digit', minute: '2-digit', second: '2-digit' });
}
