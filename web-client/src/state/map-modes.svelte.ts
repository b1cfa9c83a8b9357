import { untrack } from 'svelte';
import { mayAct, type Role } from '../api/accounts';
import { markWanted } from '../dispatch/wanted-place';
import type { Coordinates } from '../geo/coordinates';
import { isSettled } from '../runs/run-text';
import type { Station } from './station.svelte';
import { FLEET_DRAFT } from './tours.svelte';

type Part = Pick<
  Station,
  'dispatches' | 'view' | 'planner' | 'runs' | 'selected' | 'session' | 'tours' | 'virtuals' | 'zones'
>;

/** A use of the map in which a click means more than a look. */
export interface MapMode {
  readonly name: string;
  /** The role that it needs; without it the mode is ended. */
  readonly role: Role;
  isOn(station: Part): boolean;
  click(station: Part, place: Coordinates): void;
  end(station: Part): void;
}

/** The map has one use at a time: of two that are on, the first. */
export const MAP_MODES: readonly MapMode[] = [
  {
    name: 'sending a drone',
    role: 'operator',
    isOn: ({ dispatches }) => dispatches.picking,
    click: (station, place) => void markWanted(station, place),
    end: ({ dispatches }) => (dispatches.picking = false),
  },
  {
    name: 'changing a run',
    role: 'operator',
    isOn: ({ runs }) => runs.tool !== null,
    click: ({ runs }, place) => runs.mark(place),
    end: ({ runs }) => runs.clearTool(),
  },
  {
    name: 'drawing a zone',
    role: 'supervisor',
    isOn: ({ zones }) => zones.draft !== null,
    click: ({ zones }, place) => zones.addPoint(place),
    end: ({ zones }) => (zones.draft = null),
  },
  {
    name: 'planning',
    role: 'planner',
    isOn: ({ planner }) => planner.droneId !== null,
    click: ({ planner }, place) => planner.addAt(place),
    end: ({ planner }) => planner.stop(),
  },
];

export function mapMode(station: Part): MapMode | null {
  return MAP_MODES.find((mode) => mode.isOn(station)) ?? null;
}

/** Calls `begun` when the condition comes true, not while it stays so. */
function whenever(condition: () => boolean, begun: () => void): void {
  const now = $derived(condition());
  let before = false;
  $effect(() => {
    const begins = now && !before;
    before = now;
    if (begins) {
      untrack(begun);
    }
  });
}

/** Ends each use of the map when what it was for is over. For the time of a component. */
export function endMapModes(station: Part): void {
  const { view, planner, runs, tours, virtuals, zones } = station;
  const endAll = (): void => MAP_MODES.forEach((mode) => mode.end(station));

  // An opened run is shown: a forgotten draft must not receive the clicks, nor cover it.
  const ran = $derived(runs.shownId);
  $effect(() => {
    if (ran !== null) {
      untrack(endAll);
    }
  });
  whenever(
    () => tours.plan?.launch?.underWay === true,
    () => planner.droneId === FLEET_DRAFT && planner.stop(),
  );
  whenever(
    () => station.selected?.mission?.running === true,
    () => planner.droneId === view.selectedId && planner.stop(),
  );
  whenever(
    () => virtuals.find(planner.droneId)?.actions.plan.allowed === false,
    () => planner.stop(),
  );

  // Planning belongs to the chosen drone: another choice leaves the editor, the draft stays.
  $effect(() => {
    const noDrone = planner.droneId === FLEET_DRAFT || virtuals.find(planner.droneId) !== null;
    const other = noDrone && view.selectedId === null;
    if (planner.droneId !== null && planner.droneId !== view.selectedId && !other) {
      planner.stop();
    }
  });

  // A waypoint that is visited, or was given up, moves no more.
  $effect(() => {
    const waypoint = runs.shown?.waypoints.find((one) => one.id === runs.chosen);
    if (runs.tool === 'move' && (waypoint === undefined || isSettled(waypoint))) {
      runs.clearTool();
    }
  });

  $effect(() => {
    if (planner.droneId !== null || zones.draft !== null || view.selectedId !== null) {
      runs.clearTool();
    }
  });

  // The place where a drone was to go is no longer meant when it has landed, or when the map is used for something else.
  whenever(
    () => station.selected?.flight === 'onGround',
    () => (view.target = null),
  );
  whenever(
    () => mapMode(station) !== null,
    () => (view.target = null),
  );

  $effect(() => {
    MAP_MODES.filter((mode) => !mayAct(station.session?.role, mode.role)).forEach((mode) =>
      mode.end(station),
    );
  });
}
