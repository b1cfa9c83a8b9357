import type { Coordinates } from '../geo/coordinates';

export type Page = 'map' | 'flights' | 'administration';
export type SheetHeight = 'low' | 'half' | 'full';

/** Where the chosen drone is asked to go, before anybody has confirmed it. */
export interface Target extends Coordinates {
  droneId: string;
}

/** What lies on the desk: the chosen drone, the open page, the go-to mark, the help. */
export class Desk {
  page = $state<Page>('map');
  selectedId = $state<string | null>(null);
  /** Rises with each choice, so that choosing the same drone again brings the map back to it. */
  flights = $state(0);
  target = $state.raw<Target | null>(null);
  /** A place that somebody asked to see; the map goes there. */
  sight = $state.raw<Coordinates | null>(null);
  /** Some metres apart: the map shows them as near as it takes to tell them apart. */
  together = $state.raw<readonly Coordinates[]>([]);
  helpOpen = $state(false);
  fleetOpen = $state(true);
  sheet = $state<SheetHeight>('half');
  /** The drone was chosen by keyboard: its panel takes the focus when it appears. */
  focusPanel = $state(false);

  select(id: string, byKeyboard = false): void {
    this.selectedId = id;
    this.focusPanel = byKeyboard;
    this.flights += 1;
    this.page = 'map';
    this.sheet = 'half';
    if (this.target?.droneId !== id) {
      this.target = null;
    }
  }

  deselect(): void {
    this.selectedId = null;
    this.target = null;
    this.sheet = 'half';
  }

  lookAt({ latitude, longitude }: Coordinates): void {
    this.sight = { latitude, longitude };
    this.sheet = 'low';
  }

  aim(droneId: string, place: Coordinates): void {
    this.target = { droneId, latitude: place.latitude, longitude: place.longitude };
    // On the phone the card beside the place needs the map's room.
    this.sheet = 'low';
  }
}
