import type { Flight, FlightEvent, TrackForm } from '../api/flights';
import { distance, fixed, span, UNKNOWN } from '../ui/format';

/** The begin and duration of a flight. */
export function timeText(flight: Flight): string {
  const begin = new Date(flight.start).toLocaleString([], { dateStyle: 'medium', timeStyle: 'short' });
  const length = span(Math.round(flight.seconds));
  const state = { running: ', going on', lost: ', lost', ended: '' }[flight.state];
  return `${begin} · ${length}${state}`;
}

/** The users, distance, height and charge of a flight. */
export function summaryText(flight: Flight): string {
  const who = flight.users.length === 0 ? 'manual' : flight.users.join(', ');
  return [
    who,
    distance(flight.distance),
    flight.highest === null ? null : `${fixed(flight.highest)} m high`,
    flight.battery.used === null ? null : `${flight.battery.used} % of charge`,
  ]
    .filter((part) => part !== null)
    .join(' · ');
}

export function facts(flight: Flight): [string, string][] {
  return [
    ['Distance', distance(flight.distance)],
    ['Highest', flight.highest === null ? UNKNOWN : `${fixed(flight.highest)} m above home`],
    ['Fastest', flight.fastest === null ? UNKNOWN : `${fixed(flight.fastest, 1)} m/s`],
    ['Farthest', flight.farthest === null ? UNKNOWN : distance(flight.farthest)],
    [
      'Battery',
      flight.battery.used === null
        ? UNKNOWN
        : `${flight.battery.first} → ${flight.battery.last} % (${flight.battery.used} % used)`,
    ],
    ['Commanded by', flight.users.length === 0 ? 'nobody' : flight.users.join(', ')],
    ['Conducted by', flight.operation ?? UNKNOWN],
  ];
}

/** The formats a flight can be exported in; tlog only where it was recorded. */
export function trackForms(flight: Flight): TrackForm[] {
  return [
    'csv',
    'geojson',
    'kml',
    'gpx',
    'parquet',
    ...(flight.recordings.length > 0 ? (['tlog'] as const) : []),
  ];
}

/** The names of the formats. */
export const FORM_NAMES: Record<TrackForm, string> = {
  csv: 'CSV',
  geojson: 'GeoJSON',
  kml: 'KML',
  gpx: 'GPX',
  parquet: 'Parquet',
  tlog: 'tlog of this flight',
};

export function eventText(event: FlightEvent): string {
  const by = event.by === null || event.text.includes(event.by) ? '' : ` by ${event.by}`;
  const result = event.result === null ? '' : `: ${event.result}`;
  return `${event.text}${by}${result}${event.reason === null ? '' : `, ${event.reason}`}`;
}
