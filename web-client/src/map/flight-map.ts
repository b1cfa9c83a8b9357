import type { FeatureCollection } from 'geojson';
import {
  AttributionControl,
  Map as MapLibre,
  NavigationControl,
  ScaleControl,
  setWorkerUrl,
  type GeoJSONSource,
  type MapMouseEvent,
  type PaddingOptions,
} from 'maplibre-gl';
import workerAddress from 'maplibre-gl/dist/maplibre-gl-worker.mjs?worker&url';
import type { Coordinates } from '../geo/coordinates';
import { loadWorld } from './basemap';
import { gridLines, gridStep, type View } from './grid';
import { PressGestures } from './gestures';
import { drawIcon, ICON_RATIO } from './icons';
import { readPalette, type Palette } from './palette';
import { buildStyle, type LiveSource } from './style';

setWorkerUrl(workerAddress);

const CLOSE_ZOOM = 16;
const HIT_PIXELS = 14;
/** Large and given once: not worth comparing. */
const STILL_SOURCES: ReadonlySet<LiveSource> = new Set(['countries', 'names']);

/** The ids of what was clicked, or null. */
export interface Hit {
  drone: string | null;
  /** A waypoint of the mission run. */
  runWaypoint: string | null;
}

export interface MapEvents {
  onClick(place: Coordinates, hit: Hit): void;
  /** A press that stayed in place for half a second, or the secondary button. */
  /** Whether it meant something here; where it did not, letting go counts as a click. */
  onLongPress(place: Coordinates): boolean;
  onWaypointMoved(key: number, place: Coordinates): void;
  /** `byUser`: somebody moved it, not the page. */
  onMove(byUser: boolean): void;
  onGrid(stepMeters: number | null): void;
}

/** The map itself: what MapLibre needs to know, and nothing of the page around it. */
export class FlightMap {
  readonly #map: MapLibre;
  readonly #events: MapEvents;
  readonly #live = new Map<LiveSource, FeatureCollection>();
  readonly #shown = new Map<LiveSource, string>();
  #palette: Palette;
  readonly #tileAddress: string | null;
  #ready = false;

  constructor(container: HTMLElement, tileAddress: string | null, events: MapEvents) {
    this.#events = events;
    this.#tileAddress = tileAddress;
    this.#palette = readPalette();
    this.#map = new MapLibre({
      container,
      style: buildStyle(this.#palette, tileAddress),
      center: [8.5, 30],
      zoom: 1.6,
      maxZoom: 21,
      maxPitch: 0,
      dragRotate: false,
      attributionControl: false,
      renderWorldCopies: true,
      fadeDuration: 0,
    });
    this.#map.touchZoomRotate.disableRotation();
    this.#map.addControl(new NavigationControl({ showCompass: false }), 'top-right');
    this.#map.addControl(new ScaleControl({ maxWidth: 110 }), 'bottom-left');
    this.#map.addControl(new AttributionControl({ compact: false }), 'bottom-right');
    this.#listen();
    void this.#loadBase();
  }

  /** Replaces what a layer shows; kept, so that it comes back after a change of theme. */
  show(source: LiveSource, data: FeatureCollection): void {
    if (!STILL_SOURCES.has(source)) {
      // A fleet that stands still costs no redraw, however often it reports.
      const text = JSON.stringify(data);
      if (this.#shown.get(source) === text) {
        return;
      }
      this.#shown.set(source, text);
    }
    this.#live.set(source, data);
    this.#setData(source, data);
  }

  #setData(source: LiveSource, data: FeatureCollection): void {
    if (this.#ready) {
      this.#map.getSource<GeoJSONSource>(source)?.setData(data);
    }
  }

  repaint(): void {
    this.#palette = readPalette();
    this.#ready = false;
    this.#map.setStyle(buildStyle(this.#palette, this.#tileAddress), { diff: false });
  }

  flyTo(place: Coordinates): void {
    this.#map.resize();
    const zoom = Math.max(CLOSE_ZOOM, Math.min(18, this.#map.getZoom()));
    this.#map.flyTo({ center: [place.longitude, place.latitude], zoom, duration: 700 });
  }

  /** Shows all these places; one place alone is not zoomed into further than a neighbourhood. */
  fit(places: readonly Coordinates[], maxZoom = 15, padding: number | Required<PaddingOptions> = 80): void {
    // A panel may just have taken its room.
    this.#map.resize();
    const longitudes = places.map((place) => place.longitude);
    const latitudes = places.map((place) => place.latitude);
    this.#map.fitBounds(
      [
        [Math.min(...longitudes), Math.min(...latitudes)],
        [Math.max(...longitudes), Math.max(...latitudes)],
      ],
      { padding, maxZoom, duration: 0 },
    );
  }

  shows(place: Coordinates): boolean {
    return this.#map.getBounds().contains([place.longitude, place.latitude]);
  }

  pixelOf(place: Coordinates): { x: number; y: number } {
    return this.#map.project([place.longitude, place.latitude]);
  }

  size(): { width: number; height: number } {
    const { clientWidth: width, clientHeight: height } = this.#map.getContainer();
    return { width, height };
  }

  zoom(): number {
    return this.#map.getZoom();
  }

  setPlanning(planning: boolean): void {
    this.#map.getCanvas().style.cursor = planning ? 'crosshair' : '';
  }

  dispose(): void {
    this.#map.remove();
  }

  async #loadBase(): Promise<void> {
    try {
      const world = await loadWorld();
      this.show('countries', world.countries);
      this.show('names', world.names);
    } catch (thrown) {
      // Drones are drawn without it too; the reason is for whoever looks.
      console.error(thrown);
    }
  }

  #listen(): void {
    const map = this.#map;
    map.on('style.load', () => {
      this.#ready = true;
      this.#live.forEach((data, source) => this.#setData(source, data));
      this.#showGrid();
    });
    map.setMissingStyleImageResolver((id) => {
      const image = drawIcon(id, this.#palette);
      if (image !== null && !map.hasImage(id)) {
        map.addImage(id, image, { pixelRatio: ICON_RATIO });
      }
    });
    map.on('moveend', () => this.#showGrid());
    map.on('move', ({ originalEvent }) => this.#events.onMove(originalEvent !== undefined));
    new PressGestures(map, {
      isWaypoint: (event) => this.#waypointAt(event),
      onPress: (place) => this.#events.onLongPress(place),
      onDrop: (key, place) => this.#events.onWaypointMoved(key, place),
      onClick: (event) => this.#click(event),
    });
  }

  #click(event: MapMouseEvent): void {
    if (this.#waypointAt(event) === null) {
      const { lat: latitude, lng: longitude } = event.lngLat.wrap();
      // A click on a target selects the drone that follows it.
      const drone = this.#idAt(event, 'drones') ?? this.#idAt(event, 'follow-phones');
      this.#events.onClick({ latitude, longitude }, { drone, runWaypoint: this.#idAt(event, 'runs-points') });
    }
  }

  #idAt(event: MapMouseEvent, layer: string): string | null {
    const { x, y } = event.point;
    const [hit] = this.#map.queryRenderedFeatures(
      [
        [x - HIT_PIXELS, y - HIT_PIXELS],
        [x + HIT_PIXELS, y + HIT_PIXELS],
      ],
      { layers: [layer] },
    );
    const id: unknown = hit?.properties['id'];
    return typeof id === 'string' ? id : null;
  }

  #waypointAt(event: { point: { x: number; y: number } }): number | null {
    const [hit] = this.#map.queryRenderedFeatures([event.point.x, event.point.y], {
      layers: ['draft-points'],
    });
    return hit === undefined ? null : Number(hit.properties['key']);
  }

  #showGrid(): void {
    const view = this.#view();
    this.show('grid', gridLines(view));
    this.#events.onGrid(view.metersPerPixel < 60 ? gridStep(view) : null);
  }

  #view(): View {
    const bounds = this.#map.getBounds();
    const latitude = this.#map.getCenter().lat;
    // MapLibre's tiles are 512 pixels wide: 78,271.5 m a pixel at the equator at zoom 0.
    const metersPerPixel = (78_271.517 * Math.cos((latitude * Math.PI) / 180)) / 2 ** this.#map.getZoom();
    return {
      west: bounds.getWest(),
      south: bounds.getSouth(),
      east: bounds.getEast(),
      north: bounds.getNorth(),
      metersPerPixel,
    };
  }
}
