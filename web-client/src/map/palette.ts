/** The colours of the map, read from the one token set so that map and page never disagree. */
export interface Palette {
  water: string;
  land: string;
  border: string;
  grid: string;
  text: string;
  strong: string;
  halo: string;
  surface: string;
  neutral: string;
  blue: string;
  green: string;
  amber: string;
  red: string;
  violet: string;
  /** One for each tour; further tours begin anew. */
  tours: string[];
}

export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const token = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  return {
    water: token('map-water'),
    land: token('map-land'),
    border: token('map-border'),
    grid: token('map-grid'),
    text: token('map-text'),
    strong: token('text'),
    halo: token('map-halo'),
    surface: token('surface'),
    neutral: token('text-muted'),
    blue: token('blue'),
    green: token('green'),
    amber: token('amber'),
    red: token('red'),
    violet: token('violet'),
    tours: [0, 1, 2, 3, 4, 5].map((tone) => token(`tour-${tone}`)),
  };
}
