/** A place on the ground, in degrees. */
export interface Coordinates {
  latitude: number;
  longitude: number;
}

const NUMBER = String.raw`[-+−]?\d+(?:\.\d+)?`;
const ANGLE = String.raw`${NUMBER}(?:\s*[°º:d\s]\s*\d+(?:\.\d+)?(?:\s*(?:['′’m:]|\s)\s*\d+(?:\.\d+)?)?)?\s*[°º'′’"″”]*`;
const HEMISPHERES_AFTER = new RegExp(String.raw`^(${ANGLE})\s*([NS])[\s,;/]*(${ANGLE})\s*([EWO])$`, 'i');
const HEMISPHERES_BEFORE = new RegExp(String.raw`^([NS])\s*(${ANGLE})[\s,;/]*([EWO])\s*(${ANGLE})$`, 'i');
const PLAIN_PAIR = new RegExp(
  String.raw`^\(?\[?(${NUMBER})°?\s*[,;\s/]\s*(${NUMBER})°?(?:\s*,\s*${NUMBER})?\]?\)?$`,
);
const NAMED_PAIR = new RegExp(
  String.raw`lat(?:itude)?"?\s*[:=]?\s*(${NUMBER})[^\d+−-]+lon(?:g|gitude)?"?\s*[:=]?\s*(${NUMBER})`,
  'i',
);
const MAP_LINK = new RegExp(String.raw`(?:@|[?&](?:q|ll|query)=|geo:)(${NUMBER}),(${NUMBER})`, 'i');
const COMMA_DECIMALS = /^([-+−]?\d+),(\d{2,})[\s;,/]+([-+−]?\d+),(\d{2,})$/;

/**
 * Reads one place in the forms that people paste: decimal degrees, degrees and minutes, degrees, minutes and
 * seconds, hemisphere letters, decimal commas, `geo:` addresses and links of map sites. Null when it is none.
 */
export function parseCoordinates(text: string): Coordinates | null {
  const line = text.trim();
  const pair = readHemispheres(line) ?? readNumbers(line);
  return pair !== null && isOnEarth(pair) ? pair : null;
}

/** One place a line; lines that are no place come back by themselves so that they can be named. */
export function parseCoordinateLines(text: string): { places: Coordinates[]; unreadable: string[] } {
  const places: Coordinates[] = [];
  const unreadable: string[] = [];
  for (const line of text.split(/\r?\n/)) {
    if (line.trim() === '') {
      continue;
    }
    const place = parseCoordinates(line);
    if (place === null) {
      unreadable.push(line.trim());
    } else {
      places.push(place);
    }
  }
  return { places, unreadable };
}

/** Six decimals are 0.1 m. */
export function formatCoordinates(place: Coordinates): string {
  return `${place.latitude.toFixed(6)}, ${place.longitude.toFixed(6)}`;
}

function readHemispheres(line: string): Coordinates | null {
  const after = HEMISPHERES_AFTER.exec(line);
  if (after !== null) {
    return pairOf(after[1], after[2], after[3], after[4]);
  }
  const before = HEMISPHERES_BEFORE.exec(line);
  return before === null ? null : pairOf(before[2], before[1], before[4], before[3]);
}

function pairOf(latitude = '', northSouth = '', longitude = '', eastWest = ''): Coordinates | null {
  const north = angle(latitude);
  const east = angle(longitude);
  if (north === null || east === null) {
    return null;
  }
  return {
    latitude: /s/i.test(northSouth) ? -north : north,
    longitude: /w/i.test(eastWest) ? -east : east,
  };
}

function angle(text: string): number | null {
  const parts = [...text.matchAll(/\d+(?:\.\d+)?/g)].map((match) => Number(match[0]));
  const [degrees = 0, minutes = 0, seconds = 0] = parts;
  if (minutes >= 60 || seconds >= 60) {
    return null;
  }
  const size = degrees + minutes / 60 + seconds / 3600;
  return /^\s*[-−]/.test(text) ? -size : size;
}

function readNumbers(line: string): Coordinates | null {
  const commas = COMMA_DECIMALS.exec(line);
  if (commas !== null) {
    return {
      latitude: toNumber(`${commas[1]}.${commas[2]}`),
      longitude: toNumber(`${commas[3]}.${commas[4]}`),
    };
  }
  const pair = PLAIN_PAIR.exec(line) ?? NAMED_PAIR.exec(line) ?? MAP_LINK.exec(line);
  return pair === null ? null : { latitude: toNumber(pair[1]), longitude: toNumber(pair[2]) };
}

function toNumber(text = ''): number {
  return Number(text.replace('−', '-'));
}

function isOnEarth(place: Coordinates): boolean {
  return Math.abs(place.latitude) <= 90 && Math.abs(place.longitude) <= 180;
}
