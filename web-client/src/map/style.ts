import type { LayerSpecification, SourceSpecification, StyleSpecification } from 'maplibre-gl';
import type { Palette } from './palette';
import { droneLayers, MAP_FONT, missionLayers, tourLayers, zoneLayers } from './layers';
import { followLayers } from './follow-layers';
import { runLayers } from './run-layers';

const NOTHING = { type: 'FeatureCollection' as const, features: [] };

/** Names of the sources whose data changes while the page is open. */
export type LiveSource =
  | 'countries'
  | 'names'
  | 'grid'
  | 'zones'
  | 'zone-draft'
  | 'trails'
  | 'tours'
  | 'runs'
  | 'landing'
  | 'home'
  | 'mission'
  | 'draft'
  | 'target'
  | 'follows'
  | 'drones';

const LIVE_SOURCES: LiveSource[] = [
  'countries',
  'names',
  'grid',
  'zones',
  'zone-draft',
  'trails',
  'tours',
  'runs',
  'landing',
  'home',
  'mission',
  'draft',
  'target',
  'follows',
  'drones',
];

/** The whole style of the map. Fonts are the page's own: a style without `glyphs` draws text locally. */
export function buildStyle(palette: Palette, tileAddress: string | null): StyleSpecification {
  const sources: Record<string, SourceSpecification> = {};
  for (const name of LIVE_SOURCES) {
    sources[name] = {
      type: 'geojson',
      data: NOTHING,
      ...(name === 'countries' ? { attribution: 'Map: Natural Earth. Places: GeoNames' } : {}),
    };
  }
  if (tileAddress !== null) {
    sources['tiles'] = { type: 'raster', tiles: [tileAddress], tileSize: 256, maxzoom: 19 };
  }
  return {
    version: 8,
    sources,
    layers: [
      ...baseLayers(palette),
      ...(tileAddress === null
        ? []
        : [{ id: 'tiles', type: 'raster', source: 'tiles' } as LayerSpecification]),
      ...zoneLayers(palette),
      ...tourLayers(palette),
      ...runLayers(palette),
      ...missionLayers(palette),
      ...followLayers(palette),
      ...droneLayers(palette),
    ],
  };
}

function baseLayers(palette: Palette): LayerSpecification[] {
  return [
    { id: 'water', type: 'background', paint: { 'background-color': palette.water } },
    { id: 'land', type: 'fill', source: 'countries', paint: { 'fill-color': palette.land } },
    { id: 'grid', type: 'line', source: 'grid', paint: { 'line-color': palette.grid, 'line-width': 1 } },
    {
      id: 'borders',
      type: 'line',
      source: 'countries',
      paint: {
        'line-color': palette.border,
        'line-width': ['interpolate', ['linear'], ['zoom'], 1, 0.5, 8, 1.5],
      },
    },
    {
      id: 'names',
      type: 'symbol',
      source: 'names',
      maxzoom: 9,
      layout: {
        'text-field': ['get', 'name'],
        'text-font': MAP_FONT,
        'text-size': ['interpolate', ['linear'], ['zoom'], 1, 10, 6, 14],
        'text-max-width': 7,
        'symbol-sort-key': ['-', 0, ['get', 'size']],
      },
      paint: { 'text-color': palette.text, 'text-halo-color': palette.land, 'text-halo-width': 1.2 },
    },
  ];
}
