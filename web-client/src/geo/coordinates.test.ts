import { describe, expect, it } from 'vitest';
import { formatCoordinates, parseCoordinateLines, parseCoordinates } from './coordinates';

describe('coordinates', () => {
  it.each([
    '47.3977, 8.5456',
    '47.3977 8.5456',
    '47.3977;8.5456',
    '(47.3977, 8.5456)',
    '[47.3977, 8.5456]',
    '47.3977°, 8.5456°',
    '47,3977 8,5456',
    '47.3977 N, 8.5456 E',
    'N47.3977 E8.5456',
    '47°23.862′N 8°32.736′E',
    '47 23.862 N, 8 32.736 E',
    '47°23\'51.72"N 8°32\'44.16"E',
    '47° 23′ 51.72″ N, 8° 32′ 44.16″ E',
    'N 47°23.862 E 8°32.736',
    'lat: 47.3977 lon: 8.5456',
    '{"latitude": 47.3977, "longitude": 8.5456}',
    'geo:47.3977,8.5456',
    'https://www.google.com/maps/@47.3977,8.5456,17z',
    'https://maps.example.org/?q=47.3977,8.5456',
    '47.3977, 8.5456, 408.2',
  ])('reads %s', (text) => {
    const place = parseCoordinates(text);
    expect(place?.latitude).toBeCloseTo(47.3977, 6);
    expect(place?.longitude).toBeCloseTo(8.5456, 6);
  });

  it('reads the southern and western hemispheres', () => {
    expect(parseCoordinates('35.363262 S, 149.165237 E')).toEqual({
      latitude: -35.363262,
      longitude: 149.165237,
    });
    expect(parseCoordinates('-35.36, −70.5')).toEqual({ latitude: -35.36, longitude: -70.5 });
    expect(parseCoordinates('33°30\'00"S 70°30\'00"W')).toEqual({ latitude: -33.5, longitude: -70.5 });
  });

  it.each(['', 'Zürich', '95, 8', '47.1, 181', '47°75\'0"N 8°0\'0"E', '47.3977'])('refuses %s', (text) => {
    expect(parseCoordinates(text)).toBeNull();
  });

  it('reads one place a line and names the lines that are none', () => {
    const { places, unreadable } = parseCoordinateLines('47.1, 8.1\n\nover there\r\n47.2, 8.2\n');
    expect(places).toEqual([
      { latitude: 47.1, longitude: 8.1 },
      { latitude: 47.2, longitude: 8.2 },
    ]);
    expect(unreadable).toEqual(['over there']);
  });

  it('writes what it can read', () => {
    expect(formatCoordinates({ latitude: -1.5, longitude: 2 })).toBe('-1.500000, 2.000000');
    expect(parseCoordinates('-1.500000, 2.000000')).toEqual({ latitude: -1.5, longitude: 2 });
  });
});
