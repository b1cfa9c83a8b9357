import type { Coordinates } from '../geo/coordinates';

export type Page = 'map' | 'flights' | 'administration';
export type SheetHeight = 'low' | 'half' | 'full';

/** The place that the selected drone is to go to, until somebody confirms it. */
export interface Target extends Coordinates {
  droneId: string;
}

/** The state of the view: the selected drone, the open page, the target of a go-to, the help. */
export class ViewState {
  page = $state<Page>('map');
  selectedId = $state<string | null>(null);
  /** Rises with each selection, so that selecting the same drone again brings the map back to it. */
  selections = $state(0);
  target = $state.raw<Target | null>(null);
  /** The place that the map is to show. */
  shownPlace = $state.raw<Coordinates | null>(null);
  /** Places that the map is to show together, near enough to tell them apart. */
  shownPlaces = $state.raw<readonly Coordinates[]>([]);
  helpOpen = $state(false);
  fleetOpen = $state(true);
  sheet = $state<SheetHeight>('half');
  /** The drone was selected by keyboard: its panel takes the focus when it appears. */
  focusPanel = $state(false);

  select(id: string, byKeyboard = false): void {
    this.selectedId = id;
    this.focusPanel = byKeyboard;
    this.selections += 1;
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

  showPlace({ latitude, longitude }: Coordinates): void {
    this.shownPlace = { latitude, longitude };
    this.sheet = 'low';
  }

  setTarget(droneId: string, place: Coordinates): void {
    this.target = { droneId, latitude: place.latitude, longitude: place.longitude };
    // On the phone the card beside the place needs the map's room.
    this.sheet = 'low';
  }
}
