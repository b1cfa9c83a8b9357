import type { LayerSpecification } from 'maplibre-gl';
import type { Palette } from './palette';

export const MAP_FONT = ['Inter Variable'];

export function missionLayers(palette: Palette): LayerSpecification[] {
  return [
    {
      id: 'trails',
      type: 'line',
      source: 'trails',
      layout: { 'line-cap': 'round', 'line-join': 'round' },
      paint: {
        'line-color': ['case', ['get', 'selected'], palette.blue, palette.neutral],
        'line-width': ['case', ['get', 'selected'], 2.5, 1.5],
        'line-opacity': ['case', ['get', 'selected'], 0.75, 0.4],
      },
    },
    wayLayer('mission', palette.neutral, [1]),
    ...numberLayers('mission', palette, [
      'match',
      ['get', 'state'],
      'reached',
      palette.green,
      'current',
      palette.blue,
      palette.neutral,
    ]),
    wordsLayer('mission', palette, palette.neutral),
    wayLayer('draft', palette.violet, [2, 1.5]),
    ...numberLayers('draft', palette, palette.violet),
    wordsLayer('draft', palette, palette.violet),
    ...landingLayers(palette),
    {
      id: 'home',
      type: 'symbol',
      source: 'home',
      layout: { 'icon-image': 'home', 'icon-allow-overlap': true, 'icon-ignore-placement': true },
    },
    {
      id: 'target',
      type: 'symbol',
      source: 'target',
      layout: { 'icon-image': 'target', 'icon-allow-overlap': true, 'icon-ignore-placement': true },
    },
  ];
}

/** Under the mark of an item that is more than a waypoint. */
function wordsLayer(source: string, palette: Palette, colour: string): LayerSpecification {
  return {
    id: `${source}-words`,
    type: 'symbol',
    source,
    filter: ['==', ['geometry-type'], 'Point'],
    layout: {
      'text-field': ['get', 'words'],
      'text-font': MAP_FONT,
      'text-size': 12,
      'text-anchor': 'top',
      'text-offset': [0, 1.1],
      'text-optional': true,
    },
    paint: { 'text-color': colour, 'text-halo-color': palette.halo, 'text-halo-width': 1.6 },
  };
}

/** Violet as all that is not yet true, and thin: nobody has asked for it. Under the home, which it mostly is. */
function landingLayers(palette: Palette): LayerSpecification[] {
  return [
    {
      id: 'landing-way',
      type: 'line',
      source: 'landing',
      filter: ['==', ['geometry-type'], 'LineString'],
      paint: { 'line-color': palette.violet, 'line-width': 1.5, 'line-dasharray': [4, 4] },
    },
    {
      id: 'landing-place',
      type: 'circle',
      source: 'landing',
      filter: ['==', ['geometry-type'], 'Point'],
      paint: {
        'circle-radius': 6,
        'circle-color': palette.surface,
        'circle-stroke-color': palette.violet,
        'circle-stroke-width': 2,
      },
    },
    {
      id: 'landing-label',
      type: 'symbol',
      source: 'landing',
      filter: ['==', ['geometry-type'], 'Point'],
      layout: {
        'text-field': ['get', 'label'],
        'text-font': MAP_FONT,
        'text-size': 12,
        'text-variable-anchor': ['top', 'bottom', 'left', 'right'],
        'text-radial-offset': 1.8,
        'text-justify': 'auto',
        'text-max-width': 18,
      },
      paint: { 'text-color': palette.violet, 'text-halo-color': palette.halo, 'text-halo-width': 1.6 },
    },
  ];
}

/** Keep-outs red, areas to stay in green with nothing but an edge, what is being drawn violet. */
export function zoneLayers(palette: Palette): LayerSpecification[] {
  const colour = [
    'case',
    ['==', ['get', 'kind'], 'inclusion'],
    palette.green,
    palette.red,
  ] as unknown as string;
  return [
    {
      id: 'zones',
      type: 'fill',
      source: 'zones',
      paint: {
        'fill-color': colour,
        'fill-opacity': ['case', ['==', ['get', 'kind'], 'inclusion'], 0.03, 0.14],
      },
    },
    { id: 'zone-edges', type: 'line', source: 'zones', paint: { 'line-color': colour, 'line-width': 1.5 } },
    {
      id: 'zone-labels',
      type: 'symbol',
      source: 'zones',
      minzoom: 9,
      layout: { 'text-field': ['get', 'label'], 'text-font': MAP_FONT, 'text-size': 12 },
      paint: { 'text-color': colour, 'text-halo-color': palette.halo, 'text-halo-width': 1.4 },
    },
    {
      id: 'zone-draft',
      type: 'fill',
      source: 'zone-draft',
      filter: ['==', ['geometry-type'], 'Polygon'],
      paint: { 'fill-color': palette.violet, 'fill-opacity': 0.2, 'fill-outline-color': palette.violet },
    },
    {
      id: 'zone-draft-points',
      type: 'circle',
      source: 'zone-draft',
      filter: ['==', ['geometry-type'], 'Point'],
      paint: {
        'circle-radius': 6,
        'circle-color': palette.violet,
        'circle-stroke-color': palette.surface,
        'circle-stroke-width': 2,
      },
    },
  ];
}

/** Each tour in a colour of its own, with the name of its drone along it; what nobody visits stands out. */
export function tourLayers(palette: Palette): LayerSpecification[] {
  return [
    ...toneLines('tours', palette, 3.5),
    ...numberLayers('tours', palette, ['case', ['has', 'unserved'], palette.red, toneColour(palette)]),
  ];
}

function toneColour(palette: Palette): string {
  return [
    'match',
    ['get', 'tone'],
    ...palette.tours.flatMap((tone, index) => [index, tone]),
    palette.violet,
  ] as unknown as string;
}

/** Lines in the colour of their drone, with its name along them. */
export function toneLines(source: string, palette: Palette, width: number): LayerSpecification[] {
  const colour = toneColour(palette);
  const ways = ['==', ['geometry-type'], 'LineString'] as unknown as boolean;
  return [
    {
      id: source,
      type: 'line',
      source,
      filter: ways,
      layout: { 'line-cap': 'round', 'line-join': 'round' },
      paint: { 'line-color': colour, 'line-width': width, 'line-opacity': 0.9 },
    },
    {
      id: `${source}-labels`,
      type: 'symbol',
      source,
      filter: ways,
      layout: {
        'symbol-placement': 'line',
        'text-field': ['get', 'label'],
        'text-font': MAP_FONT,
        'text-size': 12,
      },
      paint: { 'text-color': colour, 'text-halo-color': palette.halo, 'text-halo-width': 1.6 },
    },
  ];
}

function wayLayer(source: string, colour: string, dash: number[]): LayerSpecification {
  return {
    id: `${source}-way`,
    type: 'line',
    source,
    filter: ['==', ['geometry-type'], 'LineString'],
    layout: { 'line-join': 'round' },
    paint: { 'line-color': colour, 'line-width': 2.5, 'line-dasharray': dash },
  };
}

export function numberLayers(source: string, palette: Palette, colour: unknown): LayerSpecification[] {
  // Wide enough for numbers of three digits, and for a mark beside them.
  const radius = ['step', ['length', ['to-string', ['get', 'label']]], 11, 3, 14, 4, 17, 5, 20];
  return [
    {
      id: `${source}-points`,
      type: 'circle',
      source,
      filter: ['==', ['geometry-type'], 'Point'],
      paint: {
        'circle-radius': radius as unknown as number,
        'circle-color': colour as string,
        'circle-stroke-color': palette.surface,
        'circle-stroke-width': 2,
      },
    },
    {
      id: `${source}-numbers`,
      type: 'symbol',
      source,
      filter: ['==', ['geometry-type'], 'Point'],
      layout: {
        'text-field': ['get', 'label'],
        'text-font': MAP_FONT,
        'text-size': 12,
        'text-allow-overlap': true,
        'text-ignore-placement': true,
      },
      paint: { 'text-color': palette.surface },
    },
  ];
}

export function droneLayers(palette: Palette): LayerSpecification[] {
  return [
    {
      id: 'drone-chosen',
      type: 'circle',
      source: 'drones',
      filter: ['get', 'selected'],
      paint: {
        'circle-radius': 25,
        'circle-color': palette.blue,
        'circle-opacity': 0.14,
        'circle-stroke-color': palette.blue,
        'circle-stroke-width': 2,
      },
    },
    {
      id: 'drones',
      type: 'symbol',
      source: 'drones',
      layout: {
        'icon-image': ['get', 'icon'],
        'icon-rotate': ['get', 'heading'],
        'icon-rotation-alignment': 'map',
        'icon-allow-overlap': true,
        'icon-ignore-placement': true,
        'symbol-sort-key': ['-', 1, ['get', 'rank']],
      },
      paint: { 'icon-opacity': ['get', 'opacity'] },
    },
    {
      id: 'drone-labels',
      type: 'symbol',
      source: 'drones',
      minzoom: 5,
      layout: {
        'text-field': [
          'format',
          ['get', 'label'],
          {},
          ['case', ['==', ['get', 'age'], ''], '', ['concat', '\n', ['get', 'age']]],
          { 'text-color': palette.amber, 'font-scale': 0.9 },
        ],
        'text-font': MAP_FONT,
        'text-size': 12.5,
        'text-anchor': 'top',
        'text-offset': [0, 2.1],
        'text-optional': true,
        'symbol-sort-key': ['get', 'rank'],
      },
      paint: { 'text-color': palette.strong, 'text-halo-color': palette.halo, 'text-halo-width': 1.6 },
    },
  ];
}
