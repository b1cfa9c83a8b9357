import type { LayerSpecification } from 'maplibre-gl';
import { MAP_FONT } from './layers';
import type { Palette } from './palette';

/** The layers of follows: the accuracy of the target, a line to the drone, and a name. */
export function followLayers(palette: Palette): LayerSpecification[] {
  const colour = [
    'match',
    ['get', 'tone'],
    ...(['green', 'amber', 'blue', 'violet'] as const).flatMap((tone) => [tone, palette[tone]]),
    palette.neutral,
  ] as unknown as string;
  return [
    {
      id: 'follow-accuracy',
      type: 'fill',
      source: 'follows',
      filter: ['==', ['geometry-type'], 'Polygon'],
      paint: { 'fill-color': colour, 'fill-opacity': 0.12, 'fill-outline-color': colour },
    },
    {
      id: 'follow-lines',
      type: 'line',
      source: 'follows',
      filter: ['==', ['geometry-type'], 'LineString'],
      paint: { 'line-color': colour, 'line-width': 2, 'line-dasharray': [3, 2] },
    },
    {
      id: 'follow-phones',
      type: 'symbol',
      source: 'follows',
      filter: ['==', ['geometry-type'], 'Point'],
      layout: {
        'icon-image': ['get', 'icon'],
        'icon-allow-overlap': true,
        'icon-ignore-placement': true,
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
        'text-offset': [0, 1.5],
        'text-optional': true,
      },
      paint: { 'text-color': palette.strong, 'text-halo-color': palette.halo, 'text-halo-width': 1.6 },
    },
  ];
}
