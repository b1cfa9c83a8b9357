import type { LayerSpecification } from 'maplibre-gl';
import { numberLayers, toneLines } from './layers';
import type { Palette } from './palette';

/** The layers of a run: each drone in its own colour, waypoints by their state, the selected one with a ring. */
export function runLayers(palette: Palette): LayerSpecification[] {
  const look = [
    'match',
    ['get', 'look'],
    'green',
    palette.green,
    'amber',
    palette.amber,
    'red',
    palette.red,
    'violet',
    palette.violet,
    'mark',
    palette.violet,
    palette.neutral,
  ];
  return [
    ...toneLines('runs', palette, 2.5),
    {
      id: 'runs-chosen',
      type: 'circle',
      source: 'runs',
      filter: ['all', ['==', ['geometry-type'], 'Point'], ['to-boolean', ['get', 'chosen']]],
      paint: {
        'circle-radius': 24,
        'circle-color': palette.blue,
        'circle-opacity': 0.16,
        'circle-stroke-color': palette.blue,
        'circle-stroke-width': 2,
      },
    },
    ...numberLayers('runs', palette, look),
  ];
}
