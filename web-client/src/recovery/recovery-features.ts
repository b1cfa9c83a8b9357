import type { Feature, FeatureCollection, Position } from 'geojson';
import type { PaddingOptions } from 'maplibre-gl';
import type { RecoveryPreview } from '../api/recoveries';
import { landingFeatures } from '../map/features';
import type { FlightMap } from '../map/flight-map';
import type { Station } from '../state/station.svelte';

/** The way of each drone of a preview, and the spot where it comes down. */
export function recoveryFeatures(preview: RecoveryPreview): FeatureCollection {
  const features = preview.drones.flatMap(
    ({ plan, droneName, fromLatitude, fromLongitude }, index): Feature[] => {
      if (plan === null) {
        return [];
      }
      const end: Position = [plan.longitude, plan.latitude];
      const way: Feature = {
        type: 'Feature',
        properties: {},
        geometry: { type: 'LineString', coordinates: [[fromLongitude, fromLatitude], end] },
      };
      const spot: Feature = {
        type: 'Feature',
        properties: { label: `${index + 1} · ${droneName} · ${plan.height.toFixed(0)} m` },
        geometry: { type: 'Point', coordinates: end },
      };
      return [way, spot];
    },
  );
  return { type: 'FeatureCollection', features };
}

/** Brings all ways and spots of a preview into sight, beside its card: nobody confirms what is not seen. */
export function showPreview(
  map: Pick<FlightMap, 'fit' | 'size'> | null,
  preview: RecoveryPreview | null,
): void {
  const places = (preview?.drones ?? []).flatMap(({ plan, fromLatitude, fromLongitude }) =>
    plan === null ? [] : [{ latitude: fromLatitude, longitude: fromLongitude }, plan],
  );
  if (map !== null && places.length > 0) {
    requestAnimationFrame(() => map.fit(places, 19, besideCard(map.size().height)));
  }
}

/** The card covers the lower part of the map, which on a phone is most of it. */
function besideCard(mapHeight: number): Required<PaddingOptions> {
  return { top: Math.min(96, mapHeight * 0.2), bottom: Math.min(264, mapHeight * 0.6), left: 72, right: 84 };
}

/** Where drones come down: those of a preview that waits to be confirmed, else the one that is chosen. */
export function comingDownFeatures({
  recoveries,
  selected,
}: Pick<Station, 'recoveries' | 'selected'>): FeatureCollection {
  return recoveries.preview === null ? landingFeatures(selected) : recoveryFeatures(recoveries.preview);
}
