import type { Feature, FeatureCollection, Position } from 'geojson';
import type { RecoveryPreview } from '../api/recoveries';
import { landingFeatures } from '../map/features';
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

/** Where drones come down: those of a preview that waits to be confirmed, else the one that is chosen. */
export function comingDownFeatures({
  recoveries,
  selected,
}: Pick<Station, 'recoveries' | 'selected'>): FeatureCollection {
  return recoveries.preview === null ? landingFeatures(selected) : recoveryFeatures(recoveries.preview);
}
